const rerunWords = "run the cycle again with this version of millwear to see its charge.";
const hasCharge = Boolean(data.charge && data.charge.cycles.length);
const withoutCharge = (load) => hasCharge ? `Cycle ${load.cycle} has no charge.h5; ${rerunWords}` : `This campaign has no charge.h5; ${rerunWords}`;

const pictureNames = {section: "The section, coloured by speed", section_by_size: "The section, coloured by size",
  close_up: "Between the lifters where the charge rises", slice: "The slice, with the liner cut open",
  streaks: "Paths of the particles"};

const shadesOfMaterials = ["blue", "brown", "green", "violet"];

/** What a picture's colours mean, and of the close-up how much of the packing it shows was measured. */
function pictureWords(name, cycle) {
  if (name === "section_by_size") {
    const materials = d3.set(data.charge.classes.map((one) => one.material)).values();
    return materials.map((material, i) => `${material}: ${shadesOfMaterials[i % shadesOfMaterials.length]}`).join(", ") +
      "; the smaller the brighter.";
  }
  const colours = `Dark is at rest, yellow ${significant(2)(data.charge.fastest)} m/s and more.`;
  const motion = data.motion.find((one) => one.cycle === cycle);
  if (name !== "close_up" || !motion || !known(motion.packed_share.value)) return colours;
  const share = (one) => `${fixed(1)(inPercent(one.value))} %` + (known(one.error) ? ` ± ${significant(2)(inPercent(one.error))} %` : "");
  return `${colours} Packed between the lifters and moving with the mill: ${share(motion.packed_share)} of the ascending charge, ` +
    `${share(motion.between_locked_share)} of what ascends between them.`;
}

function showPictures() {
  const load = chosenLoad();
  const charge = chargeOf(load);
  const pictures = Object.entries(pictureNames).filter(([name]) => charge && charge.pictures && charge.pictures[name]);
  document.getElementById("pictures").replaceChildren(...pictures.map(([name, title]) => element("figure", {},
    element("h3", {}, title), element("img", {src: charge.pictures[name], alt: `${title}, cycle ${load.cycle}`}),
    element("figcaption", {}, pictureWords(name, load.cycle)))));
}

function fillOptions(id, names, titleOf) {
  document.getElementById(id).append(...names.map((name) => element("option", {value: name}, titleOf(name))));
}

/** The view of the particles is a script of its own, which this page may have or not. */
function startView() {
  const place = document.getElementById("charge-view");
  if (typeof startChargeView === "function" && hasCharge) startChargeView(place);
  else place.remove();
}

function startCharge() {
  if (!data.loads.length || !hasCharge) {
    document.querySelectorAll("#charge .of-charge").forEach((part) => part.remove());
    nothing(document.getElementById("charge-missing"), data.loads.length ? withoutCharge() : "No load was published yet.");
    return;
  }
  document.getElementById("charge-missing").remove();
  const hasAround = data.charge.cycles.some((one) => one.around);
  document.querySelectorAll(".of-around").forEach((part) => { part.hidden = !hasAround; });
  startView();
  fillOptions("charge-map", offeredMaps(), mapTitle);
  fillOptions("around-measure", Object.keys(aroundMeasures), (name) => aroundMeasures[name]);
  document.getElementById("charge-map").addEventListener("change", () => redrawPanel("section-map"));
  document.getElementById("around-measure").addEventListener("change", () => redrawPanel("around-map"));
  cyclePanel("section-map", drawSection);
  cyclePanel("landmarks-table", fillLandmarks);
  cyclePanel("around-map", drawAround);
  cyclePanel("pictures", showPictures);
}

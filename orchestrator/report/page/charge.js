const rerunWords = "run the cycle again with this version of millwear to see its charge.";
const hasCharge = Boolean(data.charge && data.charge.cycles.length);
const withoutCharge = (load) => hasCharge ? `Cycle ${load.cycle} has no charge.h5; ${rerunWords}` : `This campaign has no charge.h5; ${rerunWords}`;

const pictureNames = {section: "The section, coloured by speed", section_by_size: "The section, coloured by size",
  close_up: "Between the lifters where the charge rises", slice: "The slice, with the liner cut open",
  streaks: "Paths of the particles"};

function showPictures() {
  const load = chosenLoad();
  const charge = chargeOf(load);
  const pictures = Object.entries(pictureNames).filter(([name]) => charge && charge.pictures && charge.pictures[name]);
  document.getElementById("pictures").replaceChildren(...pictures.map(([name, title]) => element("figure", {},
    element("h3", {}, title), element("img", {src: charge.pictures[name], alt: `${title}, cycle ${load.cycle}`}))));
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

const rerunWords = "run the cycle again with this version of millwear to see its charge.";
const hasCharge = Boolean(data.charge && data.charge.cycles.length);
const withoutCharge = (load) => hasCharge ? `Cycle ${load.cycle} has no charge.h5; ${rerunWords}` : `This campaign has no charge.h5; ${rerunWords}`;

function showPictures() {
  document.getElementById("pictures").replaceChildren(...pictureFigures(chargeOf(chosenLoad())));
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
  startChargeView(document.getElementById("charge-view"));
  fillOptions("charge-map", offeredMaps(), mapTitle);
  fillOptions("around-measure", Object.keys(aroundMeasures), (name) => aroundMeasures[name]);
  document.getElementById("charge-map").addEventListener("change", () => redrawPanel("section-map"));
  document.getElementById("around-measure").addEventListener("change", () => redrawPanel("around-map"));
  cyclePanel("section-map", drawSection);
  cyclePanel("landmarks-table", fillLandmarks);
  cyclePanel("around-map", drawAround);
  cyclePanel("pictures", showPictures);
}

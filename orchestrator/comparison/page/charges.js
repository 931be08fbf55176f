/** The recorded charge of the campaign that is nearest to the chosen moment, of those that has(charge) holds for; null
 *  where there is none. */
function nearestCharge(has) {
  const chosen = chosenCharge();
  const distance = (charge) => Math.abs(ageOfCycle(charge.cycle) - chosen.operating_hours);
  return data.charge.cycles.filter(has).reduce((best, one) => best && distance(best) <= distance(one) ? best : one, null);
}

/** The range of colours that holds a map's values in all campaigns. */
function commonRange(name) {
  const ranges = campaigns.flatMap(({data: {charge}}) => charge.cycles.filter(({maps}) => hasMap(maps, name)))
    .map(({maps}) => rangeOfMap(maps, name));
  return {low: d3.min(ranges, ({low}) => low), high: d3.max(ranges, ({high}) => high)};
}

/** The same place in all campaigns: a figure each, headed by the campaign. */
function figureOfEach(id, prefix) {
  document.getElementById(id).append(...campaigns.map((one, i) =>
    element("figure", {}, element("h4", {}, one.name), element("div", {id: `${prefix}-${i}`}), element("figcaption", {}))));
}

function drawMapOf(campaign, place, width) {
  const name = document.getElementById("charge-map").value;
  const charge = nearestCharge(({maps}) => hasMap(maps, name));
  place.nextElementSibling.textContent = charge ? `Cycle ${charge.cycle}, ${hoursText(ageOfCycle(charge.cycle))}.` : "";
  if (charge) drawMap(place, width, charge, name, commonRange(name));
  else nothing(place, "This map was not recorded in this campaign.");
}

function showComparedPictures() {
  document.getElementById("compared-pictures").replaceChildren(...ofEach((one) => {
    const charge = nearestCharge(({pictures}) => pictures && Object.keys(pictures).length);
    return charge ? element("section", {}, element("h3", {}, `${one.name}, cycle ${charge.cycle}`),
      element("div", {class: "pair"}, ...pictureFigures(charge))) : "";
  }));
}

/** A pane a campaign at first: new, of the first two that have frames. */
function startComparedView() {
  const viewed = ofEach((one) => viewedCharges(one.data, ({cycle}) => `${one.name}: ${cycleText(cycle)}`));
  const all = viewed.flat();
  const firsts = viewed.filter((ones) => ones.length).map(([first]) => all.indexOf(first));
  buildChargeView(document.getElementById("charge-view"), all, firsts.slice(0, 2));
}

function startCharges() {
  startComparedView();
  const maps = [...new Set(ofEach(offeredMaps).flat())];
  if (!maps.length) {
    document.querySelectorAll("#charge > :not(h2, #charge-view)").forEach((part) => part.remove());
    return;
  }
  fillOptions("charge-map", maps, mapTitle);
  figureOfEach("section-maps", "section-map");
  campaigns.forEach((one, i) => cyclePanel(`section-map-${i}`, (place, width) => inCampaign(one.data, () => drawMapOf(one, place, width))));
  document.getElementById("charge-map").addEventListener("change", () => campaigns.forEach((one, i) => redrawPanel(`section-map-${i}`)));
  cyclePanel("compared-pictures", showComparedPictures);
}

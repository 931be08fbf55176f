function figure(value, unit) {
  return element("span", {class: "figure"}, element("span", {class: "value"}, value),
    element("span", {class: "unit"}, unit));
}

/** Height lost from new to the last step, per hours and, with a feed rate, per mass milled. */
function wearWords() {
  const first = data.history[0];
  const last = data.history[data.history.length - 1];
  if (!first || first === last || !(last.operating_hours > 0)) return "";
  const lost = inMillimetres(first.lifter_height - last.lifter_height);
  const rate = known(last.tonnes) && last.tonnes > 0
    ? `${significant(3)(lost / last.tonnes * 1e3)} mm/kt` : `${significant(3)(lost / last.operating_hours * 1e3)} mm per 1000 h`;
  return ` The lifter went from ${fixed(0)(inMillimetres(first.lifter_height))} to ` +
    `${fixed(0)(inMillimetres(last.lifter_height))} mm, ${rate} on average.`;
}

function showAnswer() {
  const life = data.life;
  const cycles = d3.set(data.history.map((row) => row.cycle)).size();
  const figures = [figure(grouped(life.hours), life.reached ? "hours of life" : "hours so far")];
  if (known(life.tonnes)) figures.push(figure(massText(life.tonnes)[0], massText(life.tonnes)[1] + " milled"));
  figures.push(figure(cycles, cycles === 1 ? "DEM cycle" : "DEM cycles"));
  const band = known(life.hours_low) && known(life.hours_high)
    ? `; band ${grouped(life.hours_low)} to ${hoursText(life.hours_high)}` : "";
  const words = life.reached ? `Worn out at ${life.limit}${band}.` : `Not worn out yet; the limit is ${life.limit}${band}.`;
  document.getElementById("answer").append(element("div", {class: "figures"}, ...figures),
    element("p", {class: "words"}, words + wearWords()));
}

const at = (id) => document.getElementById(id);

showAnswer();
fillList("description", data.description);
fillList("provenance-list", data.provenance);
fillHistory();
fillConservation();
fillWarnings();
drawProfilesOverTime(at("profiles-over-time"));
drawHeight(at("height-chart"));
drawWornShare(at("worn-chart"));
drawRoughness(at("roughness-chart"));
startCalibrated();
drawPower(at("power-chart"));
drawPowerSeries(at("power-series-chart"));
drawAngle(at("shoulder-chart"), "Shoulder", "shoulder", "shoulder_error");
drawAngle(at("toe-chart"), "Toe", "toe", "toe_error");
startMotion();
startLoad();
startImpacts();
drawBins(at("bins-drawing"), at("bins-caption"));
drawOriginalAndWorn(at("worn-drawing"), at("worn-caption"));

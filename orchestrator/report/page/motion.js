const motionOf = (key, turn) => data.motion.map((one) =>
  ({x: ageOfCycle(one.cycle), y: turn(one[key].value), error: turn(one[key].error)}));

function drawMotionShares(place, width) {
  const line = (name, key, colour) => ({name, colour, marks: true, points: motionOf(key, inPercent)});
  return courseChart(place, width, {name: "In flight and locked", value: "%", zero: true, text: (p) => withError(p, 1, "%"), series: [
      line("in flight", "airborne_share", predictedColour),
      line("ascending charge that moves with the mill", "dead_zone_share", "var(--accent)"),
      line("... packed between the lifters", "packed_share", "var(--ochre)")]});
}

function drawHitPower(place, width) {
  const scale = prefixed(data.motion.map((one) => one.bare_hit_power.value), "W");
  const per = (value) => known(value) ? value / scale.factor : null;
  return courseChart(place, width, {name: "Hits on the bare liner", value: scale.unit, zero: true, text: (p) => withError(p, 2, scale.unit),
    series: [{colour: predictedColour, marks: true, points: motionOf("bare_hit_power", per)}]});
}

/** The first cycle, the chosen and the last, each once. */
const newChosenAndWorn = () => data.motion.filter((one, i) => i === 0 || i === chosenCycle.index || i === data.motion.length - 1);

/** From twelve o'clock all around. */
function drawHitsAround(place, width) {
  const shown = newChosenAndWorn().filter((one) => one.hit_power.length);
  const scale = prefixed(d3.merge(shown.map((one) => one.hit_power)), "W");
  const arc = 360 / d3.max(shown.concat({hit_power: [0]}), (one) => one.hit_power.length);
  drawChart(place, width, {name: "Where hits land", x: "angle along the rotation", value: scale.unit + " per degree", zero: true,
    span: [90, 450], xTicks: d3.range(90, 451, 45), xText: aroundText, place: (angle) => fixed(1)(wholeTurn(angle - angleOrigin())) + "°", text: (p) => significant(3)(p.y) + " " + scale.unit + "/°",
    series: shown.map((one) => ({name: `cycle ${one.cycle}, ${hoursText(ageOfCycle(one.cycle))}`, label: "cycle " + one.cycle,
      colour: ageColour(ageOfCycle(one.cycle)), points: one.hit_power.map((power, i) =>
        ({x: 90 + arc * (i + 0.5), y: power / scale.factor}))}))});
}

/** Degrees from three o'clock in the chosen convention. */
const aroundText = (degrees) => fixed(0)(wholeTurn(degrees - angleOrigin())) + "°";

/** A figure of a cycle's charge and its error, of what is beside the motion. */
const ofCharge = (cycle, key, turn, turnError = turn) => {
  const charge = data.charges.find((one) => one.cycle === cycle) || {};
  return {value: turn(charge[key]), error: turnError(charge[key + "_error"])};
};

function fillNewChosenAndWorn() {
  const place = document.getElementById("motion-table");
  const cycles = newChosenAndWorn();
  if (!cycles.length) { place.remove(); return; }
  const power = prefixed(cycles.map((one) => ofCharge(one.cycle, "power", (value) => value).value), "W");
  const hits = prefixed(cycles.map((one) => one.bare_hit_power.value), "W");
  const per = (scale) => (value) => known(value) ? value / scale.factor : null;
  const motion = (key, turn) => (one) => ({value: turn(one[key].value), error: turn(one[key].error)});
  const share = (key, whole) => (one) => {
    const of = whole(one);
    const per = (value) => known(value) && of > 0 ? inPercent(value / of) : null;
    return {value: per(one[key].value), error: per(one[key].error)};
  };
  const allHits = (one) => one.bare_hit_power.value;
  const rows = [
    {name: "Power", unit: power.unit, of: (one) => ofCharge(one.cycle, "power", per(power))},
    {name: "Shoulder", unit: "°", of: (one) => ofCharge(one.cycle, "shoulder", inClockDegrees, inDegrees)},
    {name: "Toe", unit: "°", of: (one) => ofCharge(one.cycle, "toe", inClockDegrees, inDegrees)},
    {name: "In flight", unit: "% of the charge", of: motion("airborne_share", inPercent)},
    {name: "Hits on the bare liner", unit: hits.unit, of: motion("bare_hit_power", per(hits))},
    {name: "... as a share of power", unit: "% of the mill's power", of: share("bare_hit_power", (one) => ofCharge(one.cycle, "power", Number).value)},
    {name: "... as a share of mass", unit: "% of the charge a revolution", of: motion("bare_hit_mass_share", inPercent)},
    {name: "... where charge falls", unit: "% of their power", of: share("bare_hit_falling_power", allHits)},
    {name: "... on the plate", unit: "% of their power", of: share("bare_hit_plate_power", allHits)},
    {name: "Moves with the mill", unit: "% of the ascending charge", of: motion("dead_zone_share", inPercent)},
    {name: "... packed between the lifters", unit: "% of the ascending charge", of: motion("packed_share", inPercent)},
    {name: "... of what lies between them", unit: "%", of: motion("between_locked_share", inPercent)},
  ].filter((row) => cycles.some((one) => known(row.of(one).value)));
  const columns = [{head: "", text: (row) => row.name, unitOf: (row) => row.unit}];
  for (const one of cycles)
    columns.push({head: `Cycle ${one.cycle}`, unit: courseText(ageOfCycle(one.cycle)), text: (row) => significant(3)(row.of(one).value)},
      {head: "±", se: true, text: (row) => significant(2)(row.of(one).error)});
  fillTable("motion-table", "The charge in the first, the chosen and the last cycle", rows, columns, () => false);
}

function startMotion() {
  panel("shoulder-chart", (place, width) => drawAngle(place, width, "Shoulder", "shoulder"));
  panel("toe-chart", (place, width) => drawAngle(place, width, "Toe", "toe"));
  panel("motion-chart", drawMotionShares);
  panel("hit-power-chart", drawHitPower);
  cyclePanel("hits-around-chart", drawHitsAround);
  cyclePanel("motion-table", fillNewChosenAndWorn);
}

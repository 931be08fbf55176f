function drawPower(place, width) {
  const points = chargePoints("power", "power_error");
  const scale = prefixed(points.map((p) => p.y), "W");
  const scaled = points.map((p) => ({x: p.x, y: p.y / scale.factor, error: known(p.error) ? p.error / scale.factor : null}));
  return courseChart(place, width, {name: "Power draw", value: scale.unit, text: (p) => withError(p, 2, scale.unit),
    series: [{colour: predictedColour, marks: true, points: scaled}]});
}

/** Power over the time blocks of every measurement; the chosen cycle's stands out. */
function drawPowerSeries(place, width) {
  const scale = prefixed(d3.merge(data.power.map((one) => one.power)), "W");
  const chosen = data.loads.length ? chosenLoad().cycle : null;
  const line = (one) => ({label: "cycle " + one.cycle, colour: ageColour(ageOfCycle(one.cycle)),
    style: one.cycle === chosen ? "" : "thin", points: one.time.map((time, i) => ({x: time, y: one.power[i] / scale.factor}))});
  drawChart(place, width, {name: "Power within each measurement", x: "seconds since the measurement began",
    value: scale.unit, series: data.power.map(line), span: [0, d3.max(data.power, (one) => d3.max(one.time))],
    place: (time) => significant(3)(time) + " s", text: (p) => fixed(2)(p.y) + " " + scale.unit});
}

const powerOf = (lines) => d3.sum(lines, (line) => line.normal_power + line.shear_power);

/** What the collisions dissipate in a cycle [W]: of particles with the liner, and of all; null where not recorded. */
function dissipation(impacts) {
  const liner = impacts.liner.length ? powerOf(impacts.liner) : null;
  return {liner, all: known(liner) && impacts.particles.length ? liner + powerOf(impacts.particles) : null};
}

/** Power drawn against power dissipated. */
function drawBalance(place, width) {
  const drawn = chargePoints("power", "power_error");
  const scale = prefixed(drawn.map((p) => p.y), "W");
  const per = (value) => known(value) ? value / scale.factor : null;
  const dissipated = (key) => data.impacts.map((one) => ({x: ageOfCycle(one.cycle), y: per(dissipation(one)[key])}));
  const series = [
    {name: "drawn", colour: predictedColour, marks: true, points: drawn.map((p) => ({x: p.x, y: per(p.y), error: per(p.error)}))},
    {name: "dissipated in collisions", colour: "var(--accent)", marks: true, points: dissipated("all")},
    {name: "... with the liner", colour: "var(--ochre)", marks: true, points: dissipated("liner")},
  ].filter((one) => one.points.some((p) => known(p.y)));
  return courseChart(place, width, {name: "Power drawn and dissipated", value: scale.unit, zero: true, series,
    text: (p) => withError(p, 2, scale.unit)});
}

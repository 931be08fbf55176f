const steelColour = "#16365c";

const campaignHours = [0, d3.max(data.history.concat(data.measured), (row) => row.operating_hours) || 1];

const chargePoints = (value, error) => data.charges.map((charge) =>
  ({x: charge.operating_hours, y: charge[value], error: charge[error]}));

/** The straight line every prediction is held against: through the first two gauge readings, else through the
 *  first cycle, on to the end of the campaign or to where no lifter is left. */
function straightLine() {
  const readings = data.measured.map((m) => ({x: m.operating_hours, y: inMillimetres(m.height)}));
  const first = data.history.filter((row) => row.cycle === data.history[0].cycle)
    .map((row) => ({x: row.operating_hours, y: inMillimetres(row.lifter_height)}));
  const measured = readings.length > 1;
  const [a, b] = measured ? readings : [first[0], first[first.length - 1]];
  if (a.x === b.x || (!measured && data.charges.length < 2)) return [];
  const slope = (b.y - a.y) / (b.x - a.x);
  const last = slope < 0 ? Math.min(campaignHours[1], a.x - a.y / slope) : campaignHours[1];
  return [{name: measured ? "straight line through the first two readings" : "straight line through the first cycle",
    label: "straight line", colour: "#8b959e", style: "dashed",
    points: [a, {x: last, y: a.y + slope * (last - a.x)}]}];
}

function drawHeight(container) {
  if (!data.history.length) { nothing(container, "No step was published yet."); return; }
  const rules = known(data.height_limit)
    ? [{y: inMillimetres(data.height_limit), text: `limit ${Number(inMillimetres(data.height_limit).toPrecision(3))} mm`}] : [];
  const series = [{name: "predicted", colour: steelColour, marks: true, points: data.history.map((row) =>
    ({x: row.operating_hours, y: inMillimetres(row.lifter_height), error: inMillimetres(row.lifter_height_error)}))}]
    .concat(straightLine());
  if (data.measured.length)
    series.push({name: "measured", colour: "#a8431c", style: "dots", points: data.measured.map((m) =>
      ({x: m.operating_hours, y: inMillimetres(m.height), error: known(m.error) ? inMillimetres(m.error) : null}))});
  lineChart(container, {name: "Lifter height", span: campaignHours, x: "operating hours", value: "mm", zero: true, series, rules,
    place: hoursText, text: (p) => withError(p, 1, "mm")});
}

function drawWornShare(container) {
  lineChart(container, {name: "Worn share", span: campaignHours, x: "operating hours", value: "%", zero: true, place: hoursText,
    text: (p) => fixed(1)(p.y) + " %", series: [{name: "predicted", colour: steelColour, marks: true, points: data.history.map((row) =>
      ({x: row.operating_hours, y: inPercent(row.worn_fraction)}))}]});
}

function drawRoughness(container) {
  lineChart(container, {name: "Roughness", span: campaignHours, x: "operating hours", value: "mm", zero: true, place: hoursText,
    text: (p) => fixed(2)(p.y) + " mm", series: [{name: "predicted", colour: steelColour, marks: true, points: data.history.map((row) =>
      ({x: row.operating_hours, y: inMillimetres(row.roughness)}))}]});
}

const withError = (p, digits, unit) =>
  fixed(digits)(p.y) + (known(p.error) ? " ± " + significant(2)(p.error) : "") + " " + unit;

function drawPower(container) {
  const points = chargePoints("power", "power_error");
  const scale = prefixed(points.map((p) => p.y), "W");
  const scaled = points.map((p) => ({x: p.x, y: p.y / scale.factor, error: known(p.error) ? p.error / scale.factor : null}));
  lineChart(container, {name: "Power draw", span: campaignHours, x: "operating hours", value: scale.unit, place: hoursText,
    text: (p) => withError(p, 2, scale.unit), series: [{colour: steelColour, marks: true, points: scaled}]});
}

function drawPowerSeries(container) {
  const scale = prefixed(d3.merge(data.power.map((one) => one.power)), "W");
  const series = data.power.map((one) => ({label: "cycle " + one.cycle, colour: ageColour(ageOfCycle(one.cycle)),
    style: "thin", points: one.time.map((time, i) => ({x: time, y: one.power[i] / scale.factor}))}));
  lineChart(container, {name: "Power within each measurement", x: "seconds since the measurement began",
    value: scale.unit, series, span: [0, d3.max(data.power, (one) => d3.max(one.time))], place: (time) => significant(3)(time) + " s",
    text: (p) => fixed(2)(p.y) + " " + scale.unit});
}

function drawAngle(container, name, value, error) {
  const points = chargePoints(value, error).map((p) => ({x: p.x, y: inDegrees(p.y), error: inDegrees(p.error)}));
  lineChart(container, {name, span: campaignHours, x: "operating hours", value: "degrees", place: hoursText,
    text: (p) => withError(p, 1, "°"), height: 220, series: [{colour: steelColour, marks: true, points}]});
}

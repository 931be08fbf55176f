const predictedColour = "var(--predicted)";

/** The straight line every prediction is held against: through the first two gauge readings, else through the
 *  first cycle, on to the end of the campaign or to where no lifter is left. */
function straightLine() {
  const readings = data.measured.map((m) => ({x: m.operating_hours, y: inLength(m.height)}));
  const first = data.history.filter((row) => row.cycle === data.history[0].cycle)
    .map((row) => ({x: row.operating_hours, y: inLength(row.lifter_height)}));
  const measured = readings.length > 1;
  const [a, b] = measured ? readings : [first[0], first[first.length - 1]];
  if (a.x === b.x || (!measured && data.charges.length < 2)) return [];
  const slope = (b.y - a.y) / (b.x - a.x);
  const last = slope < 0 ? Math.min(campaignHours[1], a.x - a.y / slope) : campaignHours[1];
  return [{name: measured ? "straight line through the first two readings" : "straight line through the first cycle",
    label: "straight line", colour: "var(--grey)", style: "dashed",
    points: [a, {x: last, y: a.y + slope * (last - a.x)}]}];
}

/** A chart of one value of every step. */
const stepsChart = (place, width, name, unit, value, text) => courseChart(place, width, {name, value: unit, zero: true, text,
  series: [{name: "predicted", colour: predictedColour, marks: true, points: data.history.map((row) =>
    ({x: row.operating_hours, y: value(row)}))}]});

function drawHeight(place, width) {
  if (!data.history.length) { nothing(place, "No step was published yet."); return null; }
  const rules = known(data.height_limit)
    ? [{y: inLength(data.height_limit), text: `limit ${Number(inLength(data.height_limit).toPrecision(3))} ${lengthUnit()}`}] : [];
  const series = [{name: "predicted", colour: predictedColour, marks: true, points: data.history.map((row) =>
    ({x: row.operating_hours, y: inLength(row.lifter_height), error: inLength(row.lifter_height_error)}))}]
    .concat(straightLine());
  if (data.measured.length)
    series.push({name: "measured", colour: "var(--accent)", style: "dots", points: data.measured.map((m) =>
      ({x: m.operating_hours, y: inLength(m.height), error: inLength(m.error)}))});
  return courseChart(place, width, {name: "Lifter height", value: lengthUnit(), zero: true, series, rules,
    text: (p) => withError(p, isInch() ? 3 : 1, lengthUnit())});
}

const drawWornShare = (place, width) => stepsChart(place, width, "Worn share", "%", (row) => inPercent(row.worn_fraction),
  (p) => fixed(1)(p.y) + " %");

const drawRoughness = (place, width) => stepsChart(place, width, "Roughness", lengthUnit(), (row) => inLength(row.roughness),
  (p) => `${fixed(isInch() ? 4 : 2)(p.y)} ${lengthUnit()}`);

/** A chart of the charge's angle. */
const drawAngle = (place, width, name, value) => courseChart(place, width, {name, value: "degrees", text: (p) => withError(p, 1, "°"),
  height: 220, series: [{colour: predictedColour, marks: true, points: anglePoints(value)}]});

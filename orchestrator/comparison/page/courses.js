const lastHours = d3.max(campaigns, ({data: {history, life}}) => d3.max([life.hours, ...history.map((row) => row.operating_hours)])) || 1;

/** A chart against hours with a line a campaign. Returns what moves the chosen moments. */
const campaignsChart = (place, width, spec) => drawChart(place, width, {x: "operating hours", span: [0, lastHours], place: hoursText,
  now: () => ofEach((one) => ({x: (chosenCharge() || {}).operating_hours, colour: colourOf(one)})), ...spec});

const historyPoints = (value) => data.history.map((row) => ({x: row.operating_hours, ...value(row)}));
const scaled = (points, factor) => points.map((p) =>
  ({x: p.x, y: known(p.y) ? p.y / factor : null, error: known(p.error) ? p.error / factor : null}));
const byMetre = (points) => scaled(points, data.charge.slice_length);

const drawHeights = (place, width) => campaignsChart(place, width, {name: "Lifter height", value: lengthUnit(), zero: true,
  text: (p) => withError(p, isInch() ? 3 : 1, lengthUnit()), series: seriesOfEach(() => ({points: historyPoints((row) =>
    ({y: inLength(row.lifter_height), error: inLength(row.lifter_height_error)}))}))});

/** Of a campaign that is not worn out, what a straight line through its heights leaves. */
const drawRemaining = (place, width) => campaignsChart(place, width, {name: "Remaining life", value: "h", zero: true,
  text: (p) => hoursText(p.y), series: seriesOfEach(({data: {life}}) => ({style: life.reached ? "" : "dashed",
    points: life.reached ? historyPoints((row) => ({y: Math.max(0, life.hours - row.operating_hours)}))
      : historyPoints((row) => ({y: row.operating_hours > 0 ? straightRemainder(row) : null}))}))});

/** Steel of lifters and plate over the circumference [kg/m]. */
const drawWornSteel = (place, width) => campaignsChart(place, width, {name: "Steel worn", value: "kg/m", zero: true,
  text: (p) => withError(p, 1, "kg/m"), series: seriesOfEach(() => ({points: historyPoints((row) => {
    const kilograms = (volume) => known(volume) ? data.sector.rows * data.liner_density * volume : null;
    return {y: kilograms(row.worn_volume), error: kilograms(row.worn_volume_error)};
  })}))});

/** A chart of a power in every cycle by metre of the mill; points() are those of the slice. */
function drawPowers(place, width, name, points, zero) {
  const series = seriesOfEach(() => ({marks: true, points: byMetre(points())}));
  const scale = prefixed(d3.merge(series.map((one) => one.points)).map((p) => p.y), "W");
  for (const one of series) one.points = scaled(one.points, scale.factor);
  return campaignsChart(place, width, {name, value: scale.unit + "/m", zero, text: (p) => withError(p, 2, scale.unit + "/m"), series});
}

/** Of hits, which the history has with every step of a cycle. */
const hitPoints = () => data.charges.map(({cycle, operating_hours: hours}) => {
  const row = data.history.find((one) => one.cycle === cycle);
  return {x: hours, y: row.bare_hit_power, error: row.bare_hit_power_error};
});

const drawAngles = (place, width, name, value) => campaignsChart(place, width, {name, value: "degrees", height: 220,
  text: (p) => withError(p, 1, "°"), series: seriesOfEach(() => ({marks: true, points: anglePoints(value)}))});

function startCourses() {
  panel("height-chart", drawHeights);
  panel("life-chart", drawRemaining);
  panel("steel-chart", drawWornSteel);
  panel("power-chart", (place, width) => drawPowers(place, width, "Power draw", () => chargePoints("power", "power_error"), false));
  panel("shoulder-chart", (place, width) => drawAngles(place, width, "Shoulder", "shoulder"));
  panel("toe-chart", (place, width) => drawAngles(place, width, "Toe", "toe"));
  panel("hits-chart", (place, width) => drawPowers(place, width, "Hits on the bare liner", hitPoints, true));
}

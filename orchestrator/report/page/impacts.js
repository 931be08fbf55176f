const impactCharts = [
  {id: "liner-normal-chart", kind: "liner", direction: "normal"},
  {id: "liner-shear-chart", kind: "liner", direction: "shear"},
  {id: "particles-normal-chart", kind: "particles", direction: "normal"},
  {id: "particles-shear-chart", kind: "particles", direction: "shear"},
];
const shownDecades = 9;

/** Collisions a second with more than each lower limit of an energy class: [{x: energy, y: rate}]. The lowest
 *  class of all has no lower limit and is left out. */
function exceedances({first, rates}) {
  let sum = 0;
  const points = [];
  for (let i = rates.length - 1; i >= 0 && first + i > 0; --i) {
    sum += rates[i];
    points.unshift({x: data.energy_edges[first + i], y: sum});
  }
  return points;
}

/** All lines of one kind together, as {first, rates}. */
function summed(lines, direction) {
  const rates = data.energy_edges.slice(1).map(() => 0);
  for (const line of lines)
    line[direction].rates.forEach((rate, i) => { rates[line[direction].first + i] += rate; });
  const [first, last] = d3.extent(d3.range(rates.length).filter((i) => rates[i] > 0));
  return first === undefined ? {first: 0, rates: []} : {first, rates: rates.slice(first, last + 1)};
}

/** Colours for the lines of one kind, in their order. */
const lineColours = (count) => d3.scale.linear().domain([0, 0.35, 0.7, 1].map((share) => share * Math.max(count - 1, 1)))
  .range(isDark() ? ["#e5b550", "#f07f62", "#4fc3cb", "#8db8e8"] : ["#b8801c", "#a8321c", "#2c8a93", "#16365c"])
  .interpolate(d3.interpolateLab);

function drawImpacts(place, width, {kind, direction}) {
  const lines = data.impacts[chosenCycle.index][kind];
  const colours = lineColours(lines.length);
  const series = lines.map((line, i) => ({name: line.name, colour: colours(i), style: "thin", points: exceedances(line[direction])}))
    .filter((one) => one.points.length);
  if (lines.length > 1) series.unshift({name: "all", colour: "var(--ink)", points: exceedances(summed(lines, direction))});
  const most = d3.max(series, (one) => d3.max(one.points, (p) => p.x));
  for (const one of series) one.points = one.points.filter((p) => p.x > most / Math.pow(10, shownDecades));
  drawChart(place, width, {name: "Collisions above an energy", x: "energy dissipated by a collision", value: "collisions a second",
    series, log: true, xText: (energy) => withPrefix(energy, "J"), place: (energy) => "more than " + withPrefix(energy, "J"),
    text: (p) => significant(3)(p.y) + " 1/s", height: 300});
}

function fillImpacts() {
  const impacts = data.impacts[chosenCycle.index];
  const rows = impacts.liner.map((line) => ({...line, against: "liner"}))
    .concat(impacts.particles.map((line) => ({...line, against: "particles"})))
    .filter((line) => line.events_per_second > 0);
  const mean = (row) => row.events_per_second > 0 ? (row.normal_power + row.shear_power) / row.events_per_second : null;
  const columns = [
    {head: "Collisions of", text: (row) => row.name},
    {head: "with", text: (row) => row.against === "liner" ? "the liner" : "each other"},
    {head: "Rate", unit: "1/s", text: (row) => significant(3)(row.events_per_second)},
    {head: "Speed of impact", unit: "m/s, rms", text: (row) => significant(3)(row.impact_speed)},
    {head: "Mean energy dissipated", unit: "mJ", text: (row) => significant(3)(known(mean(row)) ? 1e3 * mean(row) : null)},
    {head: "Power, normal", unit: "W", text: (row) => significant(3)(row.normal_power)},
    {head: "Power, shear", unit: "W", text: (row) => significant(3)(row.shear_power)},
    {head: "Not seen whole", unit: "%", text: (row) => significant(2)(inPercent(row.unfinished_share))},
  ];
  fillTable("impacts-table", `Collisions in cycle ${impacts.cycle}`, rows, columns, (row, before) => row.against !== before.against);
}

function startImpacts() {
  if (!data.impacts.length) {
    nothing(document.getElementById("impacts-table"), "No load was published yet.");
    document.querySelectorAll("#impacts figure, #impacts .caption").forEach((part) => part.remove());
    return;
  }
  for (const chart of impactCharts) cyclePanel(chart.id, (place, width) => drawImpacts(place, width, chart));
  cyclePanel("impacts-table", fillImpacts);
}

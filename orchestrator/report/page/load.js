const secondsPerThousandHours = 3.6e6;
const measures = [
  {id: "contacts-chart", key: "contacts", name: "Contacts", unit: "contacts per metre"},
  {id: "normal-dissipation-chart", key: "normal_dissipation", name: "Normal dissipation", unit: "W/m²"},
  {id: "sliding-work-chart", key: "sliding_work", name: "Sliding work", unit: "W/m²"},
  {id: "depth-rate-chart", key: "depth_rate", name: "Rate of wear", unit: "", isDepth: true},
];
const loadView = {place: () => {}, leave: () => {}};
const isNormalised = () => document.getElementById("load-normalised").checked;

const depthRateUnit = () => lengthUnit() + " per 1000 h";

/** Arc lengths [m] where the outline turns sharply: the feet and corners of the lifter. */
function corners(load) {
  const headings = load.centres.slice(1).map((p, i) =>
    Math.atan2(p[1] - load.centres[i][1], p[0] - load.centres[i][0]));
  const turns = headings.map((heading, i) => i < 2 ? 0 : Math.abs(heading - headings[i - 2]));
  return d3.range(2, turns.length - 1)
    .filter((i) => turns[i] > 0.5 && turns[i] > turns[i - 1] && turns[i] >= turns[i + 1])
    .map((i) => load.arc_length[i]);
}

/** Height of the steel over the new plate along the arc length, under a chart and on its scale. */
function outlineStrip(load) {
  const height = 58;
  const over = load.centres.map((p) => data.sector.plate_radius - Math.hypot(p[0], data.sector.plate_radius - p[1]));
  return {height, draw: (svg, frame, x) => {
    const top = frame.bottom + 26;
    const y = d3.scale.linear().domain([Math.min(0, d3.min(over)), d3.max(over) || 1])
      .range([frame.bottom + height + 16, top]);
    const area = d3.svg.area().x((h, i) => x(inLength(load.arc_length[i]))).y1((h) => y(h))
      .y0(frame.bottom + height + 20);
    svg.append("path").datum(over).attr("class", "outline").attr("d", area);
    for (const corner of corners(load).map((s) => x(inLength(s))))
      svg.append("line").attr({class: "mark", x1: corner, x2: corner, y1: frame.top, y2: frame.bottom + height + 20});
    svg.append("text").attr({x: frame.left + 4, y: top + 10}).text("trailing");
    svg.append("text").attr({x: frame.right - 4, y: top + 10, "text-anchor": "end"}).text("leading");
  }};
}

/** Values of one measure in the unit shown: {raw, smoothed, error, unit}. */
function shownLoad(load, measure) {
  const line = load[measure.key];
  const per = measure.isDepth ? inLength(secondsPerThousandHours) : 1;
  const both = d3.merge([line.raw, line.smoothed]).filter(known);
  const whole = (d3.max(line.raw.length ? line.raw : line.smoothed) || 1) * per;
  const scale = isNormalised() ? {factor: whole, unit: "share of the highest bin"}
    : measure.unit[0] === "W" ? prefixed(both, measure.unit) : {factor: 1, unit: measure.isDepth ? depthRateUnit() : measure.unit};
  const shown = (values) => values.map((value) => known(value) ? value * per / scale.factor : null);
  return {raw: shown(line.raw), smoothed: shown(line.smoothed), error: shown(line.standard_error),
    smoothedError: shown(line.smoothed_error), unit: scale.unit};
}

function drawMeasure(place, width, measure) {
  const load = chosenLoad();
  const shown = shownLoad(load, measure);
  const points = (values, errors) => values.map((value, i) =>
    ({x: inLength(load.arc_length[i]), y: value, error: errors[i]}));
  const series = [];
  if (shown.raw.length)
    series.push({name: "accumulated in the bins", colour: "var(--faint)", style: "thin", points: points(shown.raw, shown.error)});
  if (shown.smoothed.length)
    series.push({name: "smoothed", colour: "var(--accent)", points: points(shown.smoothed, shown.smoothedError)});
  const end = load.arc_length.length - 1;
  drawChart(place, width, {name: measure.name, x: `arc length along the profile [${lengthUnit()}]`, value: shown.unit, zero: true,
    series, strip: outlineStrip(load), height: 250,
    span: [0, inLength(load.arc_length[end] + load.width[end] / 2)],
    place: (s) => `${fixed(isInch() ? 2 : 0)(s)} ${lengthUnit()} along the profile`, text: (p) => significant(3)(p.y) + (known(p.error) ? " ± " + significant(2)(p.error) : ""),
    onPlace: (s) => loadView.place(s / inLength(1)), onLeave: () => loadView.leave()});
}

function normalsOf(centres) {
  return centres.map((p, i) => {
    const before = centres[Math.max(i - 1, 0)];
    const after = centres[Math.min(i + 1, centres.length - 1)];
    const length = Math.hypot(after[0] - before[0], after[1] - before[1]) || 1;
    return [-(after[1] - before[1]) / length, (after[0] - before[0]) / length];
  });
}

/** The wear rate as lines standing on the profile, the longest a fifth of the pitch. */
function drawLoadOnProfile(place, width) {
  const load = chosenLoad();
  const line = load.depth_rate.smoothed.length ? load.depth_rate.smoothed : load.depth_rate.raw;
  if (!line.length) { nothing(place, "Not recorded in this run."); return; }
  const longest = d3.max(line) || 1;
  const normals = normalsOf(load.centres);
  const length = 0.2 * (plateArc()[64][0] - plateArc()[0][0]);
  const tops = load.centres.map((p, i) => [0, 1].map((k) => p[k] + normals[i][k] * length * line[i] / longest));
  const drawing = sectorDrawing(place, width, "Rate of wear on the profile", crestOf(tops), 24);
  const {svg, x, y, path} = drawing;
  svg.append("path").attr({class: "steel", d: drawing.closed(outlineOf(load))});
  svg.append("path").attr("class", "hair").attr("d", tops.map((p, i) =>
    `M${x(load.centres[i][0])},${y(load.centres[i][1])}L${x(p[0])},${y(p[1])}`).join(""));
  svg.append("path").attr({class: "profile end", d: path(outlineOf(load))})
    .style("stroke", ageColour(ageOfCycle(load.cycle)));
  const most = line.indexOf(longest);
  svg.append("text").attr({class: "label", x: x(tops[most][0]), y: y(tops[most][1]) - 7, "text-anchor": "middle"})
    .text(`${significant(3)(longest * inLength(secondsPerThousandHours))} ${depthRateUnit()}`);
  const dot = svg.append("circle").attr({class: "pointed", r: 6}).style("display", "none");
  loadView.place = (s) => {
    const bin = Math.min(d3.bisectLeft(load.arc_length, s - 1e-9), load.centres.length - 1);
    dot.style("display", null).attr({cx: x(load.centres[bin][0]), cy: y(load.centres[bin][1])});
  };
  loadView.leave = () => dot.style("display", "none");
}

function startLoad() {
  if (!data.loads.length) {
    nothing(document.getElementById("load-controls"), "No load was published yet.");
    document.querySelectorAll("#load figure").forEach((figure) => figure.remove());
    return;
  }
  for (const measure of measures) cyclePanel(measure.id, (place, width) => drawMeasure(place, width, measure));
  cyclePanel("load-drawing", drawLoadOnProfile);
  document.getElementById("load-normalised").addEventListener("change", () =>
    measures.forEach((measure) => redrawPanel(measure.id)));
}

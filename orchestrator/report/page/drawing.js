/** The place of a sector point (radius [m], angle [rad]) in the master frame [m]. */
const pointAt = (radius, angle) =>
  [radius * Math.sin(angle), data.sector.plate_radius - radius * Math.cos(angle)];

/** An arc about the mill's axis over one pitch, from the trailing to the leading sector edge. */
function arc(radius) {
  const pitch = 2 * Math.PI / data.sector.rows;
  return d3.range(0, 65).map((i) => pointAt(radius, pitch * (i / 64 - 0.5)));
}

const shellArc = () => arc(data.sector.shell_radius);
const plateArc = () => arc(data.sector.plate_radius);

/**
 * A drawing of one pitch with equal scales, as wide as `width` [px] allows: shell, sector edges and the
 * new plate are drawn. `crest` is the highest place shown [m]. Returns the svg, x and y scales (from metres) and
 * path(points).
 */
function sectorDrawing(container, width, name, crest, head) {
  const [shell, plate] = [shellArc(), plateArc()];
  const steel = data.sector.shell_radius - data.sector.plate_radius;
  const reach = d3.extent(d3.merge([shell, plate]), (p) => p[0]);
  const top = Math.max(crest, d3.max(plate, (p) => p[1])) + 0.04 * (reach[1] - reach[0]);
  const bottom = -steel - 0.025 * (reach[1] - reach[0]);
  const margin = {left: 46, right: 8, top: head + 6, bottom: 44};
  const pixels = Math.min((width - margin.left - margin.right) / (reach[1] - reach[0]), 700 / (top - bottom));
  const right = margin.left + pixels * (reach[1] - reach[0]);
  const frame = {left: margin.left, right, top: margin.top, bottom: margin.top + pixels * (top - bottom)};
  const x = d3.scale.linear().domain(reach).range([frame.left, right]);
  const y = d3.scale.linear().domain([bottom, top]).range([frame.bottom, frame.top]);
  const svg = canvas(container, width, frame.bottom + margin.bottom, name);
  axes(svg, frame, x.copy().domain(reach.map(inLength)), y.copy().domain([bottom, top].map(inLength)),
    {x: `along the direction of rotation → [${lengthUnit()}]`, value: "", y: frame.bottom + 38});
  svg.append("text").attr({x: 0, y: frame.top - 13}).text(`height over the new plate [${lengthUnit()}]`);

  const path = d3.svg.line().defined((p) => known(p[0]) && known(p[1])).x((p) => x(p[0])).y((p) => y(p[1]));
  const outside = arc(data.sector.shell_radius + 0.012 * (reach[1] - reach[0]));
  const paths = {svg, frame, x, y, pixels, path, right: width,
    closed: (points) => path(points.concat(shell.slice().reverse())) + "Z"};
  svg.append("path").attr({class: "shell", d: path(shell.concat(outside.reverse())) + "Z"});
  for (const side of [0, shell.length - 1])
    svg.append("line").attr({class: "edge", x1: x(shell[side][0]), y1: y(shell[side][1]),
      x2: x(plate[side][0]), y2: frame.top});
  return paths;
}

function drawPlate(drawing) {
  drawing.svg.append("path").attr({class: "plate", d: drawing.path(plateArc())});
}

function nameArcs(drawing) {
  const {svg, x, y} = drawing;
  svg.append("text").attr({x: x(0), y: y(0) + 15, "text-anchor": "middle"}).text("new plate");
  svg.append("text").attr({x: x(0), y: y(d3.min(shellArc(), (p) => p[1])) - 7, "text-anchor": "middle"}).text("shell");
}

/** A bar of colours with hours under it, drawn at the right end of the drawing's head. */
function ageLegend(drawing) {
  const {svg, frame} = drawing;
  const length = Math.min(240, (frame.right - frame.left) * 0.55);
  const left = frame.right - length;
  const last = d3.max(data.profiles, (row) => row.operating_hours) || 1;
  const steps = 60;
  svg.append("g").selectAll("rect").data(d3.range(steps)).enter().append("rect")
    .attr({x: (i) => left + length * i / steps, y: 2, width: length / steps + 0.5, height: 10})
    .style("fill", (i) => ageColour(last * (i + 0.5) / steps));
  const hours = d3.scale.linear().domain([0, last]).range([left, frame.right]);
  for (const [value, anchor] of [[0, "start"], [last, "end"]])
    svg.append("text").attr({x: hours(value), y: 26, "text-anchor": anchor}).text(value ? hoursText(value) : "new");
  const middle = d3.round(last / 2, last > 400 ? -2 : 0);
  svg.append("text").attr({x: hours(middle), y: 26, "text-anchor": "middle"}).text(hoursText(middle));
}

const crestOf = (points) => d3.max(points, (p) => p[1]);

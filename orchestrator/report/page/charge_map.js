/** A map of the page's data is {low, high, unit, values: base64}: a byte a cell, 0 where no particle was, 1 to 255 from
 *  low to high. */
const decodedMaps = new WeakMap();

/** The bytes of a map. */
function bytesOf(map) {
  if (!decodedMaps.has(map)) decodedMaps.set(map, Uint8Array.from(atob(map.values), (letter) => letter.charCodeAt(0)));
  return decodedMaps.get(map);
}

/** The values of a map, NaN where no particle was. */
function valuesOf(map) {
  const step = (map.high - map.low) / 254;
  return Float64Array.from(bytesOf(map), (byte) => byte ? map.low + step * (byte - 1) : NaN);
}

/** How values of a unit are shown: value * factor, with a unit; lengths and prefixes as they suit `largest`. */
function shownUnit(unit, largest) {
  if (unit === "m") return {factor: inLength(1), unit: lengthUnit()};
  if (unit.startsWith("W") || unit.startsWith("J")) {
    const scale = prefixed([largest], unit);
    return {factor: 1 / scale.factor, unit: scale.unit.replace("m2", "m²").replace("m3", "m³")};
  }
  return {factor: 1, unit: unit.replace("m2", "m²").replace("s2", "s²")};
}

/** From the least value to the one that 995 of 1000 cells stay below, so that a few cells do not take the colours from
 *  all others. `isCut` where some are above. */
function colourRange(fields) {
  const values = Float64Array.from(d3.merge(fields.map((field) => Array.from(field).filter((value) => value === value)))).sort();
  if (!values.length) return {low: 0, high: 1, isCut: false};
  const high = values[Math.floor(0.995 * (values.length - 1))];
  const low = Math.min(values[0], high);
  return {low, high: high > low ? high : low + 1, isCut: values[values.length - 1] > high * 1.001};
}

const mapColours = d3.scale.linear().domain([0, 0.2, 0.4, 0.6, 0.8, 1])
  .range(["#440154", "#414487", "#2a788e", "#22a884", "#7ad151", "#fde725"]).interpolate(d3.interpolateLab).clamp(true);
const mapColourBytes = d3.range(256).map((i) => d3.rgb(mapColours(i / 255)));

/** A canvas with a pixel a cell, `columns` of them in a row; rows are from the bottom up. */
function pixelCanvas(values, columns, {low, high}) {
  const rows = values.length / columns;
  const pixels = element("canvas", {width: columns, height: rows});
  const image = new ImageData(columns, rows);
  values.forEach((value, cell) => {
    if (value !== value) return;
    const colour = mapColourBytes[Math.max(0, Math.min(255, Math.round(255 * (value - low) / (high - low))))];
    const place = 4 * ((rows - 1 - Math.floor(cell / columns)) * columns + cell % columns);
    image.data.set([colour.r, colour.g, colour.b, 255], place);
  });
  pixels.getContext("2d").putImageData(image, 0, 0);
  return pixels;
}

/** An svg over a canvas of the same size; the canvas is drawn at the screen's resolution. */
function canvasUnderSvg(place, width, height, name) {
  const ratio = Math.max(2, window.devicePixelRatio || 1);
  const under = element("canvas", {width: Math.round(width * ratio), height: Math.round(height * ratio), "aria-hidden": "true"});
  const both = element("div", {class: "map"}, under);
  place.append(both);
  const context = under.getContext("2d");
  context.scale(ratio, ratio);
  context.imageSmoothingEnabled = false;
  return {context, svg: canvas(both, width, height, name)};
}

/** The colours of a range from left to right, with numbers in the unit shown. */
function colourBar(svg, {left, right, top}, range, shown) {
  const steps = 64;
  const step = (right - left) / steps;
  svg.append("g").selectAll("rect").data(d3.range(steps)).enter().append("rect")
    .attr({x: (i) => left + step * i, y: top, width: step + 0.5, height: 10}).style("fill", (i) => mapColours((i + 0.5) / steps));
  const scale = d3.scale.linear().domain([range.low * shown.factor, range.high * shown.factor]).range([left, right]);
  const ticks = scale.ticks(Math.max(2, Math.floor((right - left) / 80)));
  const text = scale.tickFormat(ticks.length);
  for (const tick of ticks)
    svg.append("text").attr({x: scale(tick), y: top + 24, "text-anchor": "middle"}).text(text(tick).replace("-", "−"));
  svg.append("text").attr({class: "label", x: left, y: top - 6}).text(shown.unit + (range.isCut ? " (last colour: this and above)" : ""));
}

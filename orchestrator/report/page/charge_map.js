/** A map of the page's data is {low, high, log, unit, values: packed bytes}: a byte a cell, 0 where no particle was, 1 to 255
 *  from low to high, in equal steps or, with log, in equal ratios. */
const readMaps = new WeakMap();

/** The d3 scale from a range's values to 0 ... 1. */
const scaleOf = ({low, high, log}) => (log ? d3.scale.log() : d3.scale.linear()).domain([low, high]).clamp(true);

function readMap(map) {
  const scale = scaleOf(map);
  const values = d3.range(255).map((step) => scale.invert(step / 254));
  return Float32Array.from(bytesOf(map.values), (byte) => byte ? values[byte - 1] : NaN);
}

/** The values of a map, NaN where no particle was. */
function valuesOf(map) {
  if (!readMaps.has(map)) readMaps.set(map, readMap(map));
  return readMaps.get(map);
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

const mapColours = d3.scale.linear().domain([0, 0.2, 0.4, 0.6, 0.8, 1])
  .range(["#440154", "#414487", "#2a788e", "#22a884", "#7ad151", "#fde725"]).interpolate(d3.interpolateLab).clamp(true);
/** The colours as pixels, red in the lowest byte. */
const mapPixels = Uint32Array.from(d3.range(256), (i) => {
  const {r, g, b} = d3.rgb(mapColours(i / 255));
  return (255 << 24) | (b << 16) | (g << 8) | r;
});

/** A canvas with a pixel a cell, `columns` of them in a row; rows are from the bottom up. */
function pixelCanvas(values, columns, range) {
  const scale = scaleOf(range);
  const rows = values.length / columns;
  const image = new ImageData(columns, rows);
  const pixels = new Uint32Array(image.data.buffer);
  for (let row = 0; row < rows; ++row)
    for (let column = 0; column < columns; ++column) {
      const value = values[column + columns * row];
      if (value === value)
        pixels[column + columns * (rows - 1 - row)] = mapPixels[Math.round(255 * scale(value))];
    }
  const drawn = element("canvas", {width: columns, height: rows});
  drawn.getContext("2d").putImageData(image, 0, 0);
  return drawn;
}

/** An svg over a canvas of the same size; the canvas is drawn at the resolution of the screen or of paper. */
function canvasUnderSvg(place, width, height, name) {
  const ratio = printing ? 3 : devicePixelRatio;
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
  const scale = scaleOf({...range, low: range.low * shown.factor, high: range.high * shown.factor}).range([left, right]);
  const count = Math.max(2, Math.floor((right - left) / 80));
  const ticks = range.log ? decades(scale.domain(), count) : scale.ticks(count);
  const text = range.log ? powerText : scale.tickFormat(ticks.length);
  for (const tick of ticks)
    svg.append("text").attr({x: scale(tick), y: top + 24, "text-anchor": "middle"}).text(text(tick).replace("-", "−"));
  svg.append("text").attr({class: "label", x: left, y: top - 6}).text(shown.unit);
}

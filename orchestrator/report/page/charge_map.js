/** A map of the page's data is {low, high, unit, values: base64}: a byte a cell, 0 where no particle was, 1 to 255 from
 *  low to high. */
const readMaps = new WeakMap();

function readMap({low, high, values}) {
  const bytes = atob(values);
  const step = (high - low) / 254;
  const read = new Float32Array(bytes.length);
  for (let cell = 0; cell < read.length; ++cell) {
    const byte = bytes.charCodeAt(cell);
    read[cell] = byte ? low + step * (byte - 1) : NaN;
  }
  return read;
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
  if (unit === "1") return {factor: 1, unit: "counts"};
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
function pixelCanvas(values, columns, {low, high}) {
  const rows = values.length / columns;
  const image = new ImageData(columns, rows);
  const pixels = new Uint32Array(image.data.buffer);
  for (let row = 0; row < rows; ++row)
    for (let column = 0; column < columns; ++column) {
      const value = values[column + columns * row];
      if (value === value)
        pixels[column + columns * (rows - 1 - row)] = mapPixels[Math.max(0, Math.min(255, Math.round(255 * (value - low) / (high - low))))];
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
  const scale = d3.scale.linear().domain([range.low * shown.factor, range.high * shown.factor]).range([left, right]);
  const ticks = scale.ticks(Math.max(2, Math.floor((right - left) / 80)));
  const text = scale.tickFormat(ticks.length);
  for (const tick of ticks)
    svg.append("text").attr({x: scale(tick), y: top + 24, "text-anchor": "middle"}).text(text(tick).replace("-", "−"));
  svg.append("text").attr({class: "label", x: left, y: top - 6}).text(shown.unit);
}

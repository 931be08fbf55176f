const tip = document.getElementById("tip");

/** Shows `title` and [label, value] lines beside the pointer, inside the window. */
function showTip(event, title, lines) {
  const table = element("table", {}, ...lines.map(([label, value]) =>
    element("tr", {}, element("td", {}, label), element("td", {}, value))));
  tip.replaceChildren(element("b", {}, title), table);
  tip.hidden = false;
  const box = tip.getBoundingClientRect();
  const right = event.clientX + 16 + box.width < innerWidth;
  tip.style.left = Math.max(4, right ? event.clientX + 16 : event.clientX - 16 - box.width) + "px";
  tip.style.top = Math.min(event.clientY + 14, innerHeight - box.height - 4) + "px";
}

const hideTip = () => { tip.hidden = true; };

/** Calls draw(container, width [px]) now and whenever the width of the container changes. */
function responsive(container, draw) {
  let drawn = 0;
  const redraw = () => {
    const width = Math.round(container.getBoundingClientRect().width);
    if (width < 50 || width === drawn) return;
    drawn = width;
    container.replaceChildren();
    draw(container, width);
  };
  redraw();
  new ResizeObserver(redraw).observe(container);
}

function nothing(container, words) {
  container.replaceChildren(element("p", {class: "nothing"}, words));
}

function canvas(container, width, height, name) {
  return d3.select(container).append("svg").attr("viewBox", `0 0 ${width} ${height}`)
    .attr("role", "img").attr("aria-label", name);
}

function key(container, series) {
  const named = series.filter((one) => one.name);
  if (!named.length) return;
  const line = container.appendChild(element("p", {class: "key"}));
  for (const one of named)
    line.append(element("span", {}, element("i", {class: one.style || "", style:
      one.style === "block" ? `background:${one.colour}` : `border-color:${one.colour}`}), one.name));
}

function drawErrors(svg, points, colour, x, y) {
  const bar = (p) => `M${x(p.x)},${Math.min(y(p.y - p.error), y.range()[0])}V${y(p.y + p.error)}`;
  const bars = points.filter((p) => known(p.error)).map(bar).join("");
  if (bars) svg.append("path").attr({class: "error", d: bars}).style("stroke", colour);
}

/** Between `y` and `top` of its points. */
function drawBetween(svg, points, colour, x, y) {
  svg.append("path").datum(points).style({fill: colour, stroke: "none"})
    .attr("d", d3.svg.area().x((p) => x(p.x)).y0((p) => y(p.y)).y1((p) => y(p.top)));
}

function drawSeries(svg, series, x, y) {
  const points = series.points.filter((point) => known(point.x) && known(point.y));
  if (series.style === "dots") {
    drawErrors(svg, points, series.colour, x, y);
    svg.append("g").selectAll("circle").data(points).enter().append("circle")
      .attr({cx: (p) => x(p.x), cy: (p) => y(p.y), r: 4.5, "stroke-width": 2})
      .style({fill: "var(--paper)", stroke: series.colour});
    return;
  }
  if (series.style === "block") { drawBetween(svg, points, series.colour, x, y); return; }
  svg.append("path").datum(series.points).attr("class", "series " + (series.style || ""))
    .style("stroke", series.colour)
    .attr("d", d3.svg.line().defined((p) => known(p.x) && known(p.y)).x((p) => x(p.x)).y((p) => y(p.y)));
  drawErrors(svg, points, series.colour, x, y);
  if (series.marks)
    svg.append("g").selectAll("circle").data(points).enter().append("circle")
      .attr({cx: (p) => x(p.x), cy: (p) => y(p.y), r: 2.6}).style("fill", series.colour);
}

/** Shows the values of every series at the place nearest to the pointer along x. */
function follow(svg, frame, x, y, spec) {
  let places = null;
  const cursor = svg.append("line").attr({class: "cursor", y1: frame.top, y2: frame.bottom})
    .style("display", "none");
  const leave = () => { cursor.style("display", "none"); hideTip(); if (spec.onLeave) spec.onLeave(); };
  svg.append("rect").attr({class: "catch", x: frame.left, y: frame.top, width: frame.right - frame.left,
    height: frame.bottom - frame.top}).on("mousemove", function () {
    places = places || d3.set(d3.merge(spec.series.map((series) => series.points.map((p) => p.x)))).values().map(Number)
      .sort(d3.ascending);
    const wanted = x.invert(d3.mouse(this)[0]);
    const after = d3.bisectLeft(places, wanted);
    const place = after > 0 && (after === places.length || wanted - places[after - 1] < places[after] - wanted)
      ? places[after - 1] : places[after];
    cursor.style("display", null).attr({x1: x(place), x2: x(place)});
    const lines = [];
    for (const series of spec.series) {
      const point = series.points.find((candidate) => candidate.x === place && known(candidate.y));
      if (point) lines.push([series.label || series.name || spec.name, spec.text(point)]);
    }
    showTip(d3.event, spec.place(place), lines);
    if (spec.onPlace) spec.onPlace(place);
  }).on("mouseleave", leave);
}

/** Lines at the chosen places along x, and what moves them. */
function markPlaces(svg, frame, x, chosen) {
  const group = svg.append("g");
  const move = () => {
    const lines = group.selectAll("line").data(chosen().filter((one) => known(one.x)));
    lines.enter().append("line").attr({class: "now", y1: frame.top, y2: frame.bottom});
    lines.exit().remove();
    lines.attr({x1: (one) => x(one.x), x2: (one) => x(one.x)}).style("stroke", (one) => one.colour || null);
  };
  move();
  return move;
}

/**
 * A chart of lines and points. spec: name, x and value (axis labels), series [{name, colour, style, marks,
 * points: [{x, y, error}]}] (in the style "block" [{x, y, top}]: what lies between is filled), rules [{y, text}],
 * zero (y from 0), span (x from, to), place(x), text(point); or log (both axes logarithmic, all values above 0) and
 * xText(x); xTicks: the places of the numbers along x, with xText; xScale(x): the scale whose numbers stand along x; now(): places along x to mark, [{x, colour}]. Returns what
 * moves the marks.
 */
function drawChart(place, width, spec) {
  const all = d3.merge(spec.series.map((series) => series.points)).filter((p) => known(p.x) && known(p.y));
  if (!all.length) { nothing(place, "Not recorded in this run."); return null; }
  key(place, spec.series);
  const strip = spec.strip ? spec.strip.height : 0;
  const height = (spec.height || 270) + strip;
  const frame = {left: 52, right: width - 6, top: 24, bottom: height - 44 - strip};
  const svg = canvas(place, width, height, spec.name);
  const scale = spec.log ? d3.scale.log : d3.scale.linear;
  const x = scale().domain(spec.span || d3.extent(all, (p) => p.x)).range([frame.left, frame.right]);
  const floor = spec.zero && d3.min(all, (p) => p.y) >= 0 ? 0 : -Infinity;
  const reach = d3.extent(d3.merge([all.map((p) => known(p.top) ? p.top : p.y + (p.error || 0)),
    all.map((p) => Math.max(floor, p.y - (p.error || 0))), (spec.rules || []).map((rule) => rule.y)]));
  const y = scale().domain(spec.log ? wholeDecades(reach) : padded(reach, spec.zero)).range([frame.bottom, frame.top]);
  axes(svg, frame, x, y, {x: spec.x, value: spec.value, y: frame.bottom + strip + 38, log: spec.log, xText: spec.xText,
    xScale: spec.xScale, xTicks: spec.xTicks});
  if (spec.strip) spec.strip.draw(svg, frame, x);
  for (const rule of spec.rules || []) {
    svg.append("line").attr({class: "rule", x1: frame.left, x2: frame.right, y1: y(rule.y), y2: y(rule.y)});
    svg.append("text").attr({x: frame.left + 6, y: y(rule.y) - 5}).text(rule.text);
  }
  const move = spec.now ? markPlaces(svg, frame, x, spec.now) : null;
  for (const series of spec.series) drawSeries(svg, series, x, y);
  follow(svg, frame, x, y, spec);
  return move;
}

/** The chart in a container of changing width. */
const lineChart = (container, spec) => responsive(container, (place, width) => drawChart(place, width, spec));

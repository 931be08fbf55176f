function padded(extent, zero) {
  let [low, high] = extent;
  if (zero) { low = Math.min(low, 0); high = Math.max(high, 0); }
  const room = (high - low || Math.abs(high) || 1) * 0.08;
  return [zero && low === 0 ? 0 : low - room, zero && high === 0 ? 0 : high + room];
}

/** Powers of ten in a span, no more than `count`. */
function decades([low, high], count) {
  const [first, last] = [Math.ceil(Math.log(low) / Math.LN10 - 1e-9), Math.floor(Math.log(high) / Math.LN10 + 1e-9)];
  return d3.range(first, last + 1, Math.max(1, Math.ceil((last - first + 1) / count))).map((power) => Number("1e" + power));
}

/** A power of ten: 0.01 to 1000 as they are, others as 10⁴. */
function powerText(value) {
  const power = Math.round(Math.log(value) / Math.LN10);
  return power >= -2 && power <= 3 ? d3.format(",")(value)
    : "10" + String(power).replace(/[-0-9]/g, (digit) => digit === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[digit]);
}

/** Whole decades around all values. */
function wholeDecades(values) {
  const [low, high] = d3.extent(values).map((value) => Math.log(value) / Math.LN10);
  const first = Math.floor(low + 1e-9);
  return [first, Math.max(Math.ceil(high - 1e-9), first + 1)].map((power) => Number("1e" + power));
}

function axes(svg, frame, x, y, labels) {
  const lying = d3.svg.axis().scale(labels.xScale ? labels.xScale(x) : x).orient("bottom").tickSize(5, 0).tickPadding(6);
  const upright = d3.svg.axis().scale(y).orient("left").tickSize(-(frame.right - frame.left), 0).tickPadding(8);
  const columns = Math.max(3, Math.floor((frame.right - frame.left) / 90));
  const lines = Math.max(3, Math.floor((frame.bottom - frame.top) / 45));
  if (labels.log) {
    lying.tickValues(decades(x.domain(), columns)).tickFormat(labels.xText);
    upright.tickValues(decades(y.domain(), lines)).tickFormat(powerText);
  } else {
    if (labels.xTicks) lying.tickValues(labels.xTicks).tickFormat(labels.xText);
    else lying.ticks(columns);
    upright.ticks(lines);
    if (y.domain()[1] >= 1e5) upright.tickFormat(d3.format("s"));
  }
  const below = svg.append("g").attr("class", "axis").attr("transform", `translate(0,${frame.bottom})`).call(lying);
  const left = svg.append("g").attr("class", "axis").attr("transform", `translate(${frame.left},0)`).call(upright);
  for (const axis of [below, left])
    axis.selectAll("text").each(function () { this.textContent = this.textContent.replace("-", "−"); });
  svg.append("line").attr({class: "baseline", x1: frame.left, x2: frame.right, y1: frame.bottom, y2: frame.bottom});
  svg.append("text").attr({x: frame.right, y: labels.y, "text-anchor": "end"}).text(labels.x);
  svg.append("text").attr({x: 0, y: 12}).text(labels.value);
}

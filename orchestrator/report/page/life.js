/** The limit that ends the life, in the chosen unit. */
function limitWords() {
  if (data.life.limit.startsWith("lifter height") && known(data.height_limit)) return `lifter height ${lengthText(data.height_limit, 0)}`;
  if (data.life.limit.startsWith("plate thickness") && known(data.plate_limit)) return `plate thickness ${lengthText(data.plate_limit, 0)}`;
  return data.life.limit;
}

/** Hours that a straight line through the new height and this one leaves until the height limit. */
function straightRemainder(row) {
  const lost = data.history[0].lifter_height - row.lifter_height;
  return lost > 0 && known(data.height_limit) ? Math.max(0, row.lifter_height - data.height_limit) / lost * row.operating_hours : null;
}

/** Remaining life against hours: of the prediction with its band, and of what an inspection would extrapolate. */
function drawRemainingLife(place, width) {
  const {life} = data;
  const remaining = (row, end) => Math.max(0, end - row.operating_hours);
  const worn = data.history.filter((row) => row.operating_hours > 0);
  const series = [];
  if (life.reached && known(life.hours_low))
    series.push({name: "95 % band", colour: "var(--band-fill)", style: "block", points: data.history.map((row) =>
      ({x: row.operating_hours, y: remaining(row, life.hours_low), top: remaining(row, life.hours_high)}))});
  if (life.reached)
    series.push({name: "predicted", colour: predictedColour, points: data.history.map((row) =>
      ({x: row.operating_hours, y: remaining(row, life.hours)}))});
  series.push({name: "straight line through new and this height", label: "straight line", colour: "var(--grey)",
    style: "dashed", marks: true, points: worn.map((row) => ({x: row.operating_hours, y: straightRemainder(row)}))});
  return courseChart(place, width, {name: "Remaining life", value: "h", zero: true, series,
    text: (p) => known(p.top) ? `${grouped(p.y)} to ${hoursText(p.top)}` : hoursText(p.y)});
}

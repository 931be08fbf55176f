const daysText = (hours) => fixed(0)(hours / 24);
const bandText = (banded, digits, factor) => known(banded.low)
  ? `${fixed(digits)(banded.low * factor)} to ${fixed(digits)(banded.high * factor)}` : "–";

/** The calibrated prediction with its band, the straight line, and the readings. */
function drawCalibrated(container, course) {
  const moment = (hours, metres) => ({x: hours, y: inMillimetres(metres)});
  const last = Math.max(course.curve[course.curve.length - 1].operating_hours,
    course.readings[course.readings.length - 1].operating_hours);
  const lineEnd = Math.min(last, course.fresh_height / course.line_rate);
  const readings = (wanted) => course.readings.filter((r) => known(r.height) && wanted(r.use === "held out")).map((r) =>
    Object.assign(moment(r.operating_hours, r.height), {error: inMillimetres(r.error)}));
  const series = [
    {name: "95 % band", colour: "#aebfd0", style: "block", points: course.curve.filter((m) => known(m.height.low)).map((m) =>
      ({x: m.operating_hours, y: inMillimetres(m.height.low), top: inMillimetres(m.height.high)}))},
    {name: "predicted", colour: steelColour, points: course.curve.map((m) => moment(m.operating_hours, m.height.value))},
    {name: "straight line", colour: "#8b959e", style: "dashed", points: [moment(0, course.fresh_height),
      moment(lineEnd, course.fresh_height - course.line_rate * lineEnd)]},
    {name: "measured, calibrated on", colour: "#2c8a93", style: "dots", points: readings((held) => !held)},
    {name: "measured, held out", colour: "#a8431c", style: "dots", points: readings((held) => held)},
  ].filter((one) => one.points.length);
  lineChart(container, {name: "Calibrated lifter height", span: [0, last], x: "operating hours", value: "mm", zero: true,
    height: 360, series, place: hoursText, text: (p) => known(p.top)
      ? `${fixed(1)(p.y)} to ${fixed(1)(p.top)} mm` : withError(p, 1, "mm")});
}

function fillCalibrated(course) {
  const off = (value, row) => known(value) && known(row.height) ? fixed(1)(inMillimetres(value - row.height)) : "–";
  const millimetres = (value) => fixed(1)(inMillimetres(value));
  const columns = [
    {head: "Operating time", unit: "h", text: (row) => grouped(row.operating_hours)},
    {head: "", unit: "days", text: (row) => daysText(row.operating_hours)},
    {head: "Measured", unit: "mm", text: (row) => millimetres(row.height)},
    {head: "±", unit: "mm", se: true, text: (row) => significant(2)(inMillimetres(row.error))},
    {head: "Predicted", unit: "mm", text: (row) => millimetres(row.predicted.value)},
    {head: "95 % band", unit: "mm", text: (row) => bandText(row.predicted, 1, 1e3)},
    {head: "Difference", unit: "mm", text: (row) => off(row.predicted.value, row)},
    {head: "Straight line", unit: "mm", text: (row) => millimetres(row.line)},
    {head: "Difference", unit: "mm", text: (row) => off(row.line, row)},
    {head: "Plate measured", unit: "mm", text: (row) => millimetres(row.plate)},
    {head: "predicted", unit: "mm", text: (row) => millimetres(row.predicted_plate.value)},
    {head: "95 % band", unit: "mm", text: (row) => bandText(row.predicted_plate, 1, 1e3)},
    {head: "", text: (row) => row.use},
  ];
  fillTable("calibrated-table", course.readings, columns, (row, before) => row.use !== before.use);
}

function startCalibrated() {
  const course = data.calibrated;
  if (!course) { document.getElementById("gauge").remove(); return; }
  const band = known(course.factor.low) ? ` (95 % band ${bandText(course.factor, 3, 1)})` : "";
  const life = known(course.life.value) ? ` Life to ${fixed(1)(inMillimetres(course.height_limit))} mm: ${hoursText(course.life.value)}` +
    (known(course.life.low) ? `, 95 % band ${bandText(course.life, 0, 1)} h.` : ".") : "";
  document.getElementById("calibrated-words").textContent = `Calibrated on the heights read up to ${hoursText(course.until)}: ` +
    `every coefficient of the wear law times ${significant(4)(course.factor.value)}${band}, the hours divided by it. ` +
    course.verdict + life;
  drawCalibrated(document.getElementById("calibrated-chart"), course);
  fillCalibrated(course);
  const list = document.getElementById("calibrated-remarks");
  for (const words of course.remarks) list.append(element("li", {}, words));
}

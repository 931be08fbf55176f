const daysText = (hours) => fixed(0)(hours / 24);
const bandText = (banded, digits) => known(banded.low) ? `${fixed(digits)(banded.low)} to ${fixed(digits)(banded.high)}` : "–";
const lengthBandText = (banded) => known(banded.low) ? `${lengthFigure(banded.low, 1)} to ${lengthFigure(banded.high, 1)}` : "–";

/** The calibrated prediction with its band, the straight line, and the readings. */
function drawCalibrated(place, width) {
  const course = data.calibrated;
  const moment = (hours, metres) => ({x: hours, y: inLength(metres)});
  const last = Math.max(course.curve[course.curve.length - 1].operating_hours,
    course.readings[course.readings.length - 1].operating_hours);
  const lineEnd = Math.min(last, course.fresh_height / course.line_rate);
  const readings = (wanted) => course.readings.filter((r) => known(r.height) && wanted(r.use === "held out")).map((r) =>
    Object.assign(moment(r.operating_hours, r.height), {error: inLength(r.error)}));
  const series = [
    {name: "95 % band", colour: "var(--band-fill)", style: "block", points: course.curve.filter((m) => known(m.height.low)).map((m) =>
      ({x: m.operating_hours, y: inLength(m.height.low), top: inLength(m.height.high)}))},
    {name: "predicted", colour: predictedColour, points: course.curve.map((m) => moment(m.operating_hours, m.height.value))},
    {name: "straight line", colour: "var(--grey)", style: "dashed", points: [moment(0, course.fresh_height),
      moment(lineEnd, course.fresh_height - course.line_rate * lineEnd)]},
    {name: "measured, calibrated on", colour: "var(--teal)", style: "dots", points: readings((held) => !held)},
    {name: "measured, held out", colour: "var(--accent)", style: "dots", points: readings((held) => held)},
  ].filter((one) => one.points.length);
  const digits = isInch() ? 3 : 1;
  return courseChart(place, width, {name: "Calibrated lifter height", span: [0, last], value: lengthUnit(), zero: true,
    height: 360, series, now: null, text: (p) => known(p.top)
      ? `${fixed(digits)(p.y)} to ${fixed(digits)(p.top)} ${lengthUnit()}` : withError(p, digits, lengthUnit())});
}

function fillCalibrated(course) {
  const off = (value, row) => known(value) && known(row.height) ? lengthFigure(value - row.height, 1) : "–";
  const length = (value) => lengthFigure(value, 1);
  const columns = [
    {head: "Operating time", unit: "h", text: (row) => grouped(row.operating_hours)},
    {head: "", unit: "days", text: (row) => daysText(row.operating_hours)},
    {head: "Measured", unit: lengthUnit(), text: (row) => length(row.height)},
    {head: "±", unit: lengthUnit(), se: true, text: (row) => significant(2)(inLength(row.error))},
    {head: "Predicted", unit: lengthUnit(), text: (row) => length(row.predicted.value)},
    {head: "95 % band", unit: lengthUnit(), text: (row) => lengthBandText(row.predicted)},
    {head: "Difference", unit: lengthUnit(), text: (row) => off(row.predicted.value, row)},
    {head: "Straight line", unit: lengthUnit(), text: (row) => length(row.line)},
    {head: "Difference", unit: lengthUnit(), text: (row) => off(row.line, row)},
    {head: "Plate measured", unit: lengthUnit(), text: (row) => length(row.plate)},
    {head: "predicted", unit: lengthUnit(), text: (row) => length(row.predicted_plate.value)},
    {head: "95 % band", unit: lengthUnit(), text: (row) => lengthBandText(row.predicted_plate)},
    {head: "", text: (row) => row.use},
  ];
  fillTable("calibrated-table", "Readings against the calibrated prediction", course.readings, columns,
    (row, before) => row.use !== before.use);
}

function sayCalibration(course) {
  const band = known(course.factor.low) ? ` (95 % band ${bandText(course.factor, 3)})` : "";
  const life = known(course.life.value) ? ` Life to ${lengthText(course.height_limit, 1)}: ${hoursText(course.life.value)}` +
    (known(course.life.low) ? `, 95 % band ${bandText(course.life, 0)} h.` : ".") : "";
  document.getElementById("calibrated-words").textContent = `Calibrated on the heights read up to ${hoursText(course.until)}: ` +
    `every coefficient of the wear law times ${significant(4)(course.factor.value)}${band}, the hours divided by it. ` +
    course.verdict + life;
}

/** Where nothing is calibrated, the section says whether readings stand in the chart of the heights. */
function startGauge() {
  const course = data.calibrated;
  if (!course) {
    document.querySelectorAll("#gauge figure, #calibrated-table, #calibrated-remarks").forEach((part) => part.remove());
    document.getElementById("calibrated-words").textContent = data.measured.length
      ? "The campaign is not calibrated on its readings; they stand beside the predicted lifter height above."
      : "No gauge reading was given to this campaign.";
    return;
  }
  panel("calibrated-chart", drawCalibrated);
  onSettings(() => { sayCalibration(course); fillCalibrated(course); });
  const list = document.getElementById("calibrated-remarks");
  for (const words of course.remarks) list.append(element("li", {}, words));
}

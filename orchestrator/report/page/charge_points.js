/** What the charge did in every cycle, against hours. */
const chargePoints = (value, error) => data.charges.map((charge) =>
  ({x: charge.operating_hours, y: charge[value], error: charge[error]}));

const withError = (p, digits, unit) =>
  fixed(digits)(p.y) + (known(p.error) ? " ± " + significant(2)(p.error) : "") + " " + unit;

/** An angle of the charge in degrees: a turn is taken off as often as it takes to show the first between 0° and 360°. */
function anglePoints(value) {
  const degrees = chargePoints(value, value + "_error").map((p) => ({x: p.x, y: inDegrees(p.y), error: inDegrees(p.error)}));
  const first = degrees.find((p) => known(p.y)) || {y: 0};
  const origin = first.y - inClockDegrees(first.y * Math.PI / 180);
  return degrees.map((p) => ({...p, y: known(p.y) ? p.y - origin : null}));
}

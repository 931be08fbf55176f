/** Colour of the liner's age: dark blue when new, over teal and ochre to rust when worn. */
const ageColour = d3.scale.linear()
  .domain([0, 0.33, 0.66, 1].map((share) => share * (d3.max(data.history, (row) => row.operating_hours) || 1)))
  .range(["#16365c", "#2c8a93", "#d9a032", "#a8321c"]).interpolate(d3.interpolateLab).clamp(true);

const historyOf = (cycle, step) => data.history.find((row) => row.cycle === cycle && row.step === step);
/** The outline that the load of this cycle was measured on, in (xi, eta) [m]. */
function outlineOf(load) {
  const before = data.profiles.filter((profile) => profile.operating_hours <= ageOfCycle(load.cycle) + 1e-6);
  return before.length ? before[before.length - 1].nodes : load.centres;
}

/** Hours on the liner when the load of this cycle was measured. */
const ageOfCycle = (cycle) => (data.charges.find((charge) => charge.cycle === cycle) || {operating_hours: 0}).operating_hours;

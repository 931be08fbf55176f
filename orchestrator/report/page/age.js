/** Colour of the liner's age: dark blue when new, over teal and ochre to rust when worn. */
const ageColour = (hours) => ageScale(isDark() ? agesOnDark : agesOnLight)(hours);
const ageScale = (colours) => d3.scale.linear()
  .domain([0, 0.33, 0.66, 1].map((share) => share * (d3.max(data.history, (row) => row.operating_hours) || 1)))
  .range(colours).interpolate(d3.interpolateLab).clamp(true);
const agesOnLight = ["#16365c", "#2c8a93", "#b8801c", "#a8321c"];
const agesOnDark = ["#8db8e8", "#4fc3cb", "#e5b550", "#f07f62"];

/** The liner when the load of this cycle was measured. */
const linerBefore = (load) => data.history.filter((row) => row.operating_hours <= ageOfCycle(load.cycle) + 1e-6).pop() || data.history[0];
const lastLiner = () => data.history[data.history.length - 1];

const historyOf = (cycle, step) => data.history.find((row) => row.cycle === cycle && row.step === step);
/** The outline that the load of this cycle was measured on, in (xi, eta) [m]. */
function outlineOf(load) {
  const before = data.profiles.filter((profile) => profile.operating_hours <= ageOfCycle(load.cycle) + 1e-6);
  return before.length ? before[before.length - 1].nodes : load.centres;
}

/** Hours on the liner when the load of this cycle was measured. */
const ageOfCycle = (cycle) => (data.charges.find((charge) => charge.cycle === cycle) || {operating_hours: 0}).operating_hours;

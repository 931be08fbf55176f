/** Hours on the liner as the reader wants them along an axis: hours, tonnes milled, or dates. */
const millisecondsPerHour = 3.6e6;
const campaignHours = [0, d3.max(data.history.concat(data.measured), (row) => row.operating_hours) || 1];

/** A value of every step at any operating hours: between two steps, and on behind the last, along a straight line. */
function alongHistory(value) {
  const rows = data.history.filter((row, i) => i === 0 || row.operating_hours > data.history[i - 1].operating_hours);
  return rows.length > 1 && rows.every((row) => known(value(row)))
    ? d3.scale.linear().domain(rows.map((row) => row.operating_hours)).range(rows.map(value)) : null;
}

const calendarAt = alongHistory((row) => row.calendar_hours) || ((hours) => hours);
/** Tonnes milled; null without a feed rate. */
const tonnesAt = alongHistory((row) => row.tonnes);

/** The date on which the liner has run so many hours. Known where the first day is. */
const dateAt = (hours) => new Date(new Date(settings.start + "T00:00").getTime() +
  calendarAt(hours) * millisecondsPerHour / (Number(settings.running) / 100));
const dateText = (hours) => d3.time.format("%-d %b %Y")(dateAt(hours));

function massScale() {
  const most = tonnesAt(campaignHours[1]);
  return most >= 1e6 ? {factor: 1e6, unit: "Mt"} : most >= 1e4 ? {factor: 1e3, unit: "kt"} : {factor: 1, unit: "t"};
}

/** Dates need a first day, and tonnes a feed rate. */
function offerAxes() {
  const offered = {hours: true, tonnes: tonnesAt !== null, dates: Boolean(settings.start)};
  const choice = settingsForm.elements.axis;
  for (const option of choice.options) option.disabled = !offered[option.value];
  if (!offered[settings.axis]) choice.value = settings.axis = "hours";
}

/** Who gives the first day wants dates. */
function startCourseAxis() {
  settingsForm.elements.start.addEventListener("change", ({target}) => {
    if (target.value) settingsForm.elements.axis.value = "dates";
  });
  onSettings(offerAxes);
}

/** The scale of other numbers beside one of hours: what valueOf(hours) is at the ends and at every step. */
function beside(x, scale, valueOf) {
  const [first, last] = x.domain();
  const hours = [first, ...data.history.map((row) => row.operating_hours).filter((one) => one > first && one < last), last];
  return scale.domain(hours.map(valueOf)).range(hours.map(x));
}

/** The label of the axis, and the scale of its numbers for a scale of hours. */
function courseAxis() {
  if (settings.axis === "dates") return {label: "date", scale: (x) => beside(x, d3.time.scale(), dateAt)};
  if (settings.axis === "tonnes") {
    const {factor, unit} = massScale();
    return {label: `milled [${unit}]`, scale: (x) => beside(x, d3.scale.linear(), (hours) => tonnesAt(hours) / factor)};
  }
  return {label: "operating hours", scale: (x) => x};
}

/** Hours with what the axis counts in front of them. */
function courseText(hours) {
  if (settings.axis === "dates") return `${dateText(hours)} (${hoursText(hours)})`;
  if (settings.axis === "tonnes") return `${massText(tonnesAt(hours)).join(" ")} (${hoursText(hours)})`;
  return hoursText(hours);
}

/** A chart over the campaign, with a line at the chosen cycle. Returns what moves this line. */
function courseChart(place, width, spec) {
  const axis = courseAxis();
  return drawChart(place, width, {span: campaignHours, place: courseText, x: axis.label, xScale: axis.scale,
    now: () => data.loads.length ? [{x: ageOfCycle(chosenLoad().cycle)}] : [], ...spec});
}

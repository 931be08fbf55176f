function figure(value, unit) {
  return element("span", {class: "figure"}, element("span", {class: "value"}, value),
    element("span", {class: "unit"}, unit));
}

/** Life or hours so far, with the date and the band where they are known. */
function lifeWords() {
  const {life} = data;
  const hasBand = known(life.hours_low) && known(life.hours_high);
  const band = hasBand ? ` (95 % band ${grouped(life.hours_low)} to ${hoursText(life.hours_high)})` : "";
  if (!life.reached) return `Not worn out after ${hoursText(life.hours)}; the limit is ${limitWords()}${band}.`;
  const dates = !settings.start ? "" : `, on ${dateText(life.hours)}` +
    (hasBand ? ` (${dateText(life.hours_low)} to ${dateText(life.hours_high)})` : "");
  return `Reline after ${hoursText(life.hours)}${band}${dates}: the limit is ${limitWords()}.`;
}

/** Height lost from new to the last step, per hours and, with a feed rate, per mass milled; and the steel. */
function wearWords() {
  const first = data.history[0];
  const last = lastLiner();
  if (!first || first === last || !(last.operating_hours > 0)) return "";
  const lost = inLength(first.lifter_height - last.lifter_height);
  const milled = known(last.tonnes) && last.tonnes > 0;
  const rate = milled ? `${significant(3)(lost / last.tonnes * 1e3)} ${lengthUnit()}/kt`
    : `${significant(3)(lost / last.operating_hours * 1e3)} ${lengthUnit()} per 1000 h`;
  const steel = milled ? `${steelPerTonne(last)} milled` : `${significant(3)(inSteel(wornSteel(last)))} ${steelUnit()}`;
  return ` The lifter went from ${lengthFigure(first.lifter_height, 0)} to ${lengthText(last.lifter_height, 0)}, ${rate} on average.` +
    ` Steel worn: ${steel}.`;
}

function showAnswer() {
  const {life} = data;
  const cycles = d3.set(data.history.map((row) => row.cycle)).size();
  const figures = [figure(grouped(life.hours), life.reached ? "hours of life" : "hours so far")];
  if (known(life.tonnes)) figures.push(figure(massText(life.tonnes)[0], massText(life.tonnes)[1] + " milled"));
  figures.push(figure(cycles, cycles === 1 ? "DEM cycle" : "DEM cycles"));
  document.getElementById("answer").replaceChildren(element("div", {class: "figures"}, ...figures),
    element("p", {class: "words"}, lifeWords() + wearWords()));
}

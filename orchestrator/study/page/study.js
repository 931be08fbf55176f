const at = (id) => document.getElementById(id);
const colours = ["#16365c", "#a8431c", "#2c8a93", "#d9a032", "#6a4c93", "#5c6670", "#8a9a2b", "#c2185b"];
const colourOf = (point) => colours[(point.point - 1) % colours.length];
const columnOf = (name) => data.columns.find((column) => column.name === name);
const figureOf = (point, name) => name === "objective" ? point.objective : point.figures[name];
const asNumber = (label) => label.trim() !== "" && isFinite(Number(label)) ? Number(label) : null;
const shortKey = (key) => key.slice(key.lastIndexOf(".") + 1);
const nameOf = (point) => data.axes.map((axis) => `${shortKey(axis)} ${point.values[axis]}`).join(", ");
const donePoints = data.points.filter((point) => point.done > 0);

/** Standard deviation of a point's mean: what is predicted, or what the replicates show if that is more. */
function deviation(point, name) {
  const figure = figureOf(point, name);
  return Math.max(known(figure.se) ? figure.se : 0, known(figure.scatter) ? figure.scatter / Math.sqrt(point.done) : 0);
}

/** Results that are known and are not the same everywhere. */
const outputs = data.columns.filter((column) => {
  const values = donePoints.map((point) => point.figures[column.name].mean).filter(known);
  return values.length && d3.min(values) !== d3.max(values);
});

function digitsFor(error) {
  return known(error) && error > 0 ? Math.max(0, Math.min(6, 1 - Math.floor(Math.log(error) / Math.LN10))) : null;
}
function figureText(figure) {
  const digits = digitsFor(figure.se);
  return digits === null ? significant(4)(figure.mean) : fixed(digits)(figure.mean);
}

function fillAnswer() {
  const done = d3.sum(data.points, (point) => point.done);
  const all = d3.sum(data.points, (point) => point.replicates);
  const failed = d3.sum(data.points, (point) => point.failed);
  const figures = element("div", {class: "figures"});
  const best = data.points[data.best - 1];
  if (best) {
    const digits = digitsFor(best.objective.se);
    figures.append(element("p", {class: "figure"}, element("span", {class: "value"},
      digits === null ? significant(4)(best.objective.mean) : fixed(digits)(best.objective.mean)),
      element("span", {class: "unit"}, `± ${significant(2)(deviation(best, "objective"))}, ${data.objective}`)));
    at("answer").append(figures, element("p", {class: "words"}, `Point ${best.point} (${nameOf(best)}) is the best, with a probability of ` +
      `${fixed(0)(100 * best.probability_of_best)} % given the noise.`));
  }
  const lines = [["Base case", data.base_case], ["Points", data.points.length], ["Campaigns", `${done} of ${all} done` + (failed ? `, ${failed} failed` : "")],
    ["Varied", data.axes.join(", ")]];
  for (const [name, value] of lines) at("description").append(element("div", {}, element("dt", {}, name), element("dd", {}, value)));
}

/** columns: [{head, unit, value(row), text(row), node(row)}]; the headings sort. */
function sortableTable(place, rows, columns) {
  let order = null;
  let upwards = true;
  const draw = () => {
    const sorted = rows.slice();
    if (order !== null) sorted.sort((a, b) => {
      const [x, y] = [columns[order].value(a), columns[order].value(b)];
      if (!known(x) && typeof x !== "string") return 1;
      if (!known(y) && typeof y !== "string") return -1;
      return (x < y ? -1 : x > y ? 1 : 0) * (upwards ? 1 : -1);
    });
    const head = element("tr", {}, ...columns.map((column, i) => {
      const sort = element("button", {type: "button"}, column.head + (order === i ? (upwards ? " ▲" : " ▼") : ""));
      sort.addEventListener("click", () => { upwards = order === i ? !upwards : true; order = i; draw(); });
      return element("th", {scope: "col", "aria-sort": order === i ? (upwards ? "ascending" : "descending") : "none"}, sort,
        element("small", {}, column.unit || "\u00a0"));
    }));
    const body = sorted.map((row) => element("tr", {}, ...columns.map((column) =>
      element("td", {class: (column.se ? "se" : "") + (column.clear && column.clear(row) ? " clear" : "")}, column.node ? column.node(row) : column.text(row)))));
    place.replaceChildren(element("table", {}, element("thead", {}, head), element("tbody", {}, ...body)));
  };
  draw();
}

function axisColumns() {
  return data.axes.map((axis) => ({head: shortKey(axis), unit: axis,
    value: (point) => asNumber(point.values[axis]) ?? point.values[axis], text: (point) => point.values[axis]}));
}

function pointLink(point) {
  const campaign = point.campaigns.find((one) => one.has_report);
  if (!campaign) return document.createTextNode(point.point);
  return element("a", {href: `points/${encodeURIComponent(campaign.folder)}/report.html`}, point.point);
}

function pointColumns() {
  const columns = [{head: "Point", value: (point) => point.point, text: (point) => point.point, node: pointLink}].concat(axisColumns(), [
    {head: "Done", unit: "replicates", value: (point) => point.done, text: (point) => `${point.done}/${point.replicates}`}]);
  if (data.objective) columns.push(
    {head: data.objective, value: (point) => point.objective.mean, text: (point) => figureText(point.objective)},
    {head: "±", se: true, value: (point) => point.objective.se, text: (point) => significant(2)(point.objective.se)},
    {head: "Best", unit: "%", value: (point) => point.probability_of_best, text: (point) => fixed(0)(inPercent(point.probability_of_best))});
  for (const column of data.columns) {
    const figure = (point) => point.figures[column.name];
    if (!donePoints.some((point) => known(figure(point).mean))) continue;
    columns.push({head: column.name, unit: column.unit, value: (point) => figure(point).mean, text: (point) => figureText(figure(point))});
    if (donePoints.some((point) => known(figure(point).se)))
      columns.push({head: "±", unit: column.unit, se: true, value: (point) => figure(point).se, text: (point) => significant(2)(figure(point).se)});
    if (donePoints.some((point) => known(figure(point).scatter) && figure(point).scatter > 0))
      columns.push({head: "scatter", unit: column.unit, se: true, value: (point) => figure(point).scatter, text: (point) => significant(2)(figure(point).scatter)});
  }
  return columns;
}

/** The table as tabs and lines, for a spreadsheet. */
function copyTable() {
  const rows = [...at("points-table").querySelectorAll("tr")].map((row) => [...row.children].map((cell) =>
    (cell.querySelector("button") || cell).textContent.trim()).join("\t"));
  navigator.clipboard.writeText(rows.join("\n")).then(() => { at("copied").textContent = "copied"; },
    () => { at("copied").textContent = "the browser allows no copying here"; });
}

/** How to see the best campaign and the nearest to it by the objective side by side; without an objective the first. */
function sayComparison() {
  const best = data.points[data.best - 1];
  const off = (point) => best ? Math.abs(point.objective.mean - best.objective.mean) : point.point;
  const campaigns = donePoints.slice().sort((a, b) => off(a) - off(b)).map((point) => point.campaigns.find((one) => one.has_report));
  const folders = campaigns.filter(Boolean).slice(0, 4).map(({folder}) => `points/${folder}`);
  if (folders.length < 2) return;
  at("comparison").append(`For a page that shows ${best ? "the best points" : "points"} side by side, give this in the study's folder: `,
    element("code", {}, `millwear compare ${folders.join(" ")}`));
}

function fillChoice(select, chosen) {
  select.replaceChildren(...outputs.map((column) => element("option", {value: column.name}, `${column.name} [${column.unit}]`)));
  if (outputs.some((column) => column.name === chosen)) select.value = chosen;
}

function drawEffects(name) {
  const place = at("effect-charts");
  place.replaceChildren();
  for (const axis of data.axes) {
    const isNumber = data.points.every((point) => asNumber(point.values[axis]) !== null);
    const labels = d3.set(data.points.map((point) => point.values[axis])).values();
    const x = (point) => isNumber ? asNumber(point.values[axis]) : labels.indexOf(point.values[axis]) + 1;
    const points = donePoints.filter((point) => known(figureOf(point, name).mean))
      .map((point) => ({x: x(point), y: figureOf(point, name).mean, error: deviation(point, name), point}));
    const means = d3.nest().key((p) => p.x).entries(points)
      .map((group) => ({x: Number(group.key), y: d3.mean(group.values, (p) => p.y)})).sort((a, b) => a.x - b.x);
    const box = element("div", {});
    place.append(element("figure", {}, element("h3", {}, `${name} against ${shortKey(axis)}`), box));
    lineChart(box, {name: `${name} against ${axis}`, x: isNumber ? axis : labels.map((label, i) => `${i + 1} ${label}`).join(", "),
      value: columnOf(name).unit, place: (value) => `${shortKey(axis)} ${isNumber ? value : labels[value - 1]}`,
      text: (p) => significant(4)(p.y) + (p.error ? ` ± ${significant(2)(p.error)}` : ""), height: 240,
      series: [{label: "mean", colour: "#8b959e", style: "thin", points: means}, {label: "point", colour: colours[0], style: "dots", points}]});
  }
}

/** Two axes as a map of the result; the others are averaged over. */
function drawMap(name) {
  at("map").replaceChildren();
  if (data.axes.length < 2) return;
  const [across, down] = data.axes;
  const order = (axis) => d3.set(data.points.map((point) => point.values[axis])).values()
    .sort((a, b) => (asNumber(a) ?? 0) - (asNumber(b) ?? 0) || d3.ascending(a, b));
  const cell = (a, b) => d3.mean(donePoints.filter((point) => point.values[across] === a && point.values[down] === b)
    .map((point) => figureOf(point, name).mean).filter(known));
  const values = d3.merge(order(down).map((b) => order(across).map((a) => cell(a, b)))).filter(known);
  if (values.length < 2) return;
  const shade = d3.scale.linear().domain(d3.extent(values)).range(["#f4f6f7", "#7fb3ba"]).interpolate(d3.interpolateLab);
  const head = element("tr", {}, element("th", {}, `${shortKey(down)} \\ ${shortKey(across)}`), ...order(across).map((a) => element("th", {scope: "col"}, a)));
  const body = order(down).map((b) => element("tr", {}, element("th", {scope: "row"}, b), ...order(across).map((a) => {
    const value = cell(a, b);
    return element("td", {style: known(value) ? `background:${shade(value)}` : ""}, significant(4)(value));
  })));
  at("map").append(element("table", {}, element("caption", {}, `${name} [${columnOf(name).unit}]`), element("thead", {}, head), element("tbody", {}, ...body)));
}

function drawDifferences() {
  const first = data.points[0];
  if (!first || !first.done || donePoints.length < 2) { at("difference-table").replaceChildren(); return; }
  const columns = [{head: "Point", value: (point) => point.point, text: (point) => point.point}].concat(axisColumns());
  for (const column of outputs) {
    const difference = (point) => point.figures[column.name].mean - first.figures[column.name].mean;
    const error = (point) => Math.hypot(deviation(point, column.name), deviation(first, column.name));
    columns.push({head: column.name, unit: column.unit, value: difference, clear: (point) => error(point) > 0 && Math.abs(difference(point)) > 2 * error(point),
      text: (point) => known(difference(point)) ? (difference(point) > 0 ? "+" : "") + significant(3)(difference(point)) +
        (error(point) > 0 ? ` ± ${significant(2)(error(point))}` : "") : "–"});
  }
  sortableTable(at("difference-table"), donePoints.filter((point) => point !== first), columns);
}

function drawTrade(cost, gain) {
  const points = donePoints.map((point) => ({x: figureOf(point, cost).mean, y: figureOf(point, gain).mean, error: deviation(point, gain), point}))
    .filter((p) => known(p.x) && known(p.y));
  const isBeaten = (p) => points.some((other) => other !== p && other.x <= p.x && other.y >= p.y && (other.x < p.x || other.y > p.y));
  const series = [{name: "Pareto set", label: "point", colour: colours[1], style: "dots", points: points.filter((p) => !isBeaten(p))},
    {name: "others", label: "point", colour: colours[5], style: "dots", points: points.filter(isBeaten)}].filter((one) => one.points.length);
  at("trade-chart").replaceChildren();
  lineChart(at("trade-chart"), {name: `${gain} against ${cost}`, x: `${cost} [${columnOf(cost).unit}]`, value: columnOf(gain).unit, series,
    place: (value) => significant(4)(value), text: (p) => `${significant(4)(p.y)} (point ${p.point.point}: ${nameOf(p.point)})`});
}

function drawCourses() {
  if (data.courses.length < donePoints.length) at("drawn").textContent =
    `Courses, hits and profiles are drawn of ${data.courses.length} of ${donePoints.length} points, those likeliest to be the best.`;
  const courses = data.courses.map((course) => ({...course, of: data.points[course.point - 1]}));
  const lines = (value) => courses.map((course) => ({label: `point ${course.point}`, name: courses.length <= 8 ? `${course.point}: ${nameOf(course.of)}` : null,
    colour: colourOf(course.of), points: course.hours.map((hours, i) => ({x: hours, y: course[value][i]}))}));
  const chart = (id, name, value, unit) => lineChart(at(id), {name, x: "operating hours", value: unit, series: lines(value), place: hoursText,
    text: (p) => significant(4)(p.y) + " " + unit});
  chart("height-chart", "Lifter height", "height_mm", "mm");
  chart("power-chart", "Power draw", "power_kw", "kW");
}

function drawImpacts() {
  const series = data.courses.filter((course) => course.impacts.length).map((course) => ({label: `point ${course.point}`,
    name: data.courses.length <= 8 ? `${course.point}: ${nameOf(data.points[course.point - 1])}` : null, colour: colourOf(data.points[course.point - 1]),
    points: course.impacts.map(([energy, rate]) => ({x: energy, y: rate}))}));
  lineChart(at("impact-chart"), {name: "Hits above an energy", x: "energy dissipated by a hit", value: "hits a second", series, log: true,
    xText: (energy) => withPrefix(energy, "J"), place: (energy) => "more than " + withPrefix(energy, "J"), text: (p) => significant(3)(p.y) + " 1/s", height: 300});
}

function drawProfiles() {
  const all = d3.merge(data.courses.map((course) => d3.merge(course.profiles.map((profile) => profile.nodes))));
  if (!all.length) { nothing(at("profile-charts"), "No campaign is done yet."); return; }
  const [left, right] = d3.extent(all, (p) => p[0]);
  const [low, high] = d3.extent(all, (p) => p[1]);
  for (const course of data.courses) {
    const box = element("div", {});
    at("profile-charts").append(element("figure", {}, element("h3", {}, `${course.point}: ${nameOf(data.points[course.point - 1])}`), box));
    responsive(box, (place, width) => {
      const pixels = width / (right - left);
      const svg = canvas(place, width, pixels * (high - low) + 4, `profiles of point ${course.point}`);
      const line = d3.svg.line().x((p) => pixels * (p[0] - left)).y((p) => 2 + pixels * (high - p[1]));
      course.profiles.forEach((profile, i) => svg.append("path").attr({class: "profile", d: line(profile.nodes)})
        .style("stroke", d3.interpolateLab("#16365c", "#d9772f")(i / Math.max(1, course.profiles.length - 1))));
    });
  }
}

/** Over all points with replicates: predicted standard error over scatter. */
function fillAgreement() {
  const repeated = donePoints.filter((point) => point.done > 1);
  if (!repeated.length) { nothing(at("agreement-table"), "A study with replicates shows here how far its predicted errors hold."); return; }
  if (data.coverage.length) {
    const rows = data.coverage.map((row) => element("tr", {}, element("td", {}, row.measure), element("td", {}, known(row.hours) ? grouped(row.hours) : ""),
      element("td", {}, significant(4)(row.mean)), element("td", {}, significant(3)(row.scatter)), element("td", {}, significant(3)(row.predicted)),
      element("td", {}, `${fixed(2)(row.ratio)} ± ${fixed(2)(row.ratio_error)}`)));
    at("agreement-table").append(element("div", {class: "scroll"}, element("table", {}, element("thead", {}, element("tr", {},
      ...["Measure", "At hours", "Mean", "Scatter", "Predicted", "Predicted / scatter"].map((head) => element("th", {scope: "col"}, head)))), element("tbody", {}, ...rows))));
    return;
  }
  const rows = data.columns.map((column) => {
    const figures = repeated.map((point) => ({...point.figures[column.name], n: point.done})).filter((figure) => known(figure.se) && known(figure.scatter));
    const predicted = Math.sqrt(d3.mean(figures, (figure) => figure.n * figure.se ** 2));
    const scatter = Math.sqrt(d3.mean(figures, (figure) => figure.scatter ** 2));
    const freedom = d3.sum(figures, (figure) => figure.n - 1);
    return {column, predicted, scatter, freedom};
  }).filter((row) => row.predicted > 0 && row.scatter > 0.01 * row.predicted);
  const cells = rows.map((row) => element("tr", {}, element("td", {}, row.column.name), element("td", {}, row.column.unit), element("td", {}, significant(3)(row.scatter)),
    element("td", {}, significant(3)(row.predicted)), element("td", {}, `${fixed(2)(row.predicted / row.scatter)} ± ${fixed(2)(row.predicted / row.scatter / Math.sqrt(2 * row.freedom))}`)));
  at("agreement-table").append(element("div", {class: "scroll"}, element("table", {}, element("thead", {}, element("tr", {},
    ...["Result", "Unit", "Scatter", "Predicted", "Predicted / scatter"].map((head) => element("th", {scope: "col"}, head)))), element("tbody", {}, ...cells))));
}

fillAnswer();
sortableTable(at("points-table"), data.points, pointColumns());
at("copy").addEventListener("click", copyTable);
sayComparison();
fillChoice(at("output"), "life_hours");
fillChoice(at("cost"), "power_w");
fillChoice(at("gain"), "life_hours");
const drawOutput = () => { if (outputs.length) { drawEffects(at("output").value); drawMap(at("output").value); } };
const drawChosenTrade = () => { if (outputs.length) drawTrade(at("cost").value, at("gain").value); };
at("output").addEventListener("change", drawOutput);
for (const id of ["cost", "gain"]) at(id).addEventListener("change", drawChosenTrade);
drawOutput();
drawDifferences();
drawChosenTrade();
drawCourses();
drawImpacts();
drawProfiles();
fillAgreement();

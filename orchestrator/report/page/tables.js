function fillOptions(id, names, titleOf) {
  document.getElementById(id).append(...names.map((name) => element("option", {value: name}, titleOf(name))));
}

function fillList(id, lines) {
  const list = document.getElementById(id);
  for (const [name, value] of lines)
    list.append(element("div", {}, element("dt", {}, name), element("dd", {}, value)));
}

/** columns: [{head, unit, text(row), unitOf(row)}], the first of which heads its row; a row where starts(row, before) is true gets
 *  a line above it. */
function fillTable(id, caption, rows, columns, starts = () => false) {
  const place = document.getElementById(id);
  if (!rows.length) { nothing(place, "Nothing was published yet."); return; }
  const heading = (column) => element(column.head ? "th" : "td", column.head ? {scope: "col"} : {}, column.head,
    element("small", {}, column.unit || "\u00a0"));
  const cell = (row) => (column, i) => element(i ? "td" : "th", i ? {class: column.se ? "se" : ""} : {scope: "row"}, column.text(row),
    ...column.unitOf ? [" ", element("small", {}, column.unitOf(row))] : []);
  const body = rows.map((row, i) => element("tr", {class: i && starts(row, rows[i - 1]) ? "first" : ""}, ...columns.map(cell(row))));
  const table = element("table", {}, element("caption", {class: "unseen"}, caption), element("thead", {}, element("tr", {}, ...columns.map(heading))),
    element("tbody", {}, ...body));
  place.replaceChildren(copyButton(table), element("div", {class: "scroll", tabindex: 0, role: "region", "aria-label": caption}, table));
}

function fillHistory() {
  const scale = prefixed(data.history.map((row) => row.power), "W");
  const per = (value) => known(value) ? value / scale.factor : null;
  const columns = [
    {head: "Cycle", text: (row) => row.cycle},
    {head: "Step", text: (row) => row.step},
    {head: "Operating time", unit: "h", text: (row) => fixed(0)(row.operating_hours)},
    {head: "Date", text: (row) => settings.start ? dateText(row.operating_hours) : "–"},
    {head: "Milled", unit: "t", text: (row) => fixed(0)(row.tonnes)},
    {head: "Lifter height", unit: lengthUnit(), text: (row) => lengthFigure(row.lifter_height, 1)},
    {head: "±", unit: lengthUnit(), se: true, text: (row) => significant(2)(inLength(row.lifter_height_error))},
    {head: "Leading face", unit: "°", text: (row) => fixed(1)(inDegrees(row.face_angle))},
    {head: "Thinnest plate", unit: lengthUnit(), text: (row) => lengthFigure(row.plate_thickness, 1)},
    {head: "±", unit: lengthUnit(), se: true, text: (row) => significant(2)(inLength(row.plate_thickness_error))},
    {head: "Worn section", unit: areaUnit(), text: (row) => fixed(1)(inArea(row.worn_volume))},
    {head: "Worn share", unit: "%", text: (row) => fixed(1)(inPercent(row.worn_fraction))},
    {head: "Roughness", unit: lengthUnit(), text: (row) => lengthFigure(row.roughness, 2)},
    {head: "Power", unit: scale.unit, text: (row) => fixed(2)(per(row.power))},
    {head: "±", unit: scale.unit, se: true, text: (row) => significant(2)(per(row.power_error))},
    {head: "Shoulder", unit: "°", text: (row) => fixed(1)(inClockDegrees(row.shoulder))},
    {head: "±", unit: "°", se: true, text: (row) => significant(2)(inDegrees(row.shoulder_error))},
    {head: "Toe", unit: "°", text: (row) => fixed(1)(inClockDegrees(row.toe))},
    {head: "±", unit: "°", se: true, text: (row) => significant(2)(inDegrees(row.toe_error))},
    {head: "In flight", unit: "%", text: (row) => fixed(1)(inPercent(row.airborne_share))},
    {head: "±", unit: "%", se: true, text: (row) => significant(2)(inPercent(row.airborne_share_error))},
    {head: "Bare hits", unit: scale.unit, text: (row) => significant(3)(per(row.bare_hit_power))},
    {head: "±", unit: scale.unit, se: true, text: (row) => significant(2)(per(row.bare_hit_power_error))},
    {head: "Moves with mill", unit: "%", text: (row) => fixed(1)(inPercent(row.dead_zone_share))},
    {head: "±", unit: "%", se: true, text: (row) => significant(2)(inPercent(row.dead_zone_share_error))},
    {head: "... between lifters", unit: "%", text: (row) => fixed(1)(inPercent(row.between_locked_share))},
    {head: "±", unit: "%", se: true, text: (row) => significant(2)(inPercent(row.between_locked_share_error))},
  ].filter((column) => column.head === "Cycle" || data.history.some((row) => column.text(row) !== "–"));
  fillTable("history-table", "Every step of the campaign", data.history, columns, (row, before) => row.cycle !== before.cycle);
}

function fillConservation() {
  const off = (row) => row.accounted ? Math.abs(row.removed - row.accounted) / row.accounted : null;
  fillTable("conservation-table", "Loads and conservation of every cycle", data.conservation, [
    {head: "Cycle", text: (row) => row.cycle},
    {head: "Removed from the profile", unit: areaUnit(), text: (row) => significant(7)(inArea(row.removed))},
    {head: "Accounted for by the load", unit: areaUnit(), text: (row) => significant(7)(inArea(row.accounted))},
    {head: "Difference", unit: "share", text: (row) => significant(2)(off(row))},
    {head: "Carried by smoothing", unit: "%", text: (row) => fixed(2)(inPercent(row.moved_by_smoothing))},
    {head: "Contacts in no bin", unit: "%", text: (row) => fixed(3)(inPercent(row.rejected))},
    {head: "Measured for", unit: "revolutions", text: (row) => significant(3)(row.revolutions)},
    {head: "Rate at its peaks", unit: "± %", text: (row) => significant(2)(inPercent(row.peak_error))},
    {head: "Path over slip", text: (row) => fixed(2)(row.path_over_slip)},
    {head: "Scatter of loads", text: (row) => fixed(2)(row.load_scatter)},
    {head: "Measurement ended", text: (row) => row.end},
  ]);
}

function fillWarnings() {
  const list = document.getElementById("warning-list");
  if (!data.warnings.length) { list.replaceWith(element("p", {class: "nothing"}, "None.")); return; }
  for (const words of data.warnings) list.append(element("li", {}, words));
  const many = data.warnings.length === 1 ? "One warning" : `${data.warnings.length} warnings`;
  document.getElementById("notice").append(element("a", {href: "#warnings"}, `${many} to read with these figures`));
}

/** A value of the operation, which holds from one step to the next. */
const drawOperation = (place, width, name, unit, value, text) => courseChart(place, width, {name, value: unit, zero: true, text, height: 220,
  series: [{colour: predictedColour, points: d3.merge(data.history.map((row, i) => [
    ...(i > 0 ? [{x: data.history[i - 1].operating_hours, y: value(row)}] : []), {x: row.operating_hours, y: value(row)}]))}]});

/** Charts of speed and filling where the operation of the mill changes. */
function startOperation() {
  const changes = (value) => d3.set(data.history.map(value)).size() > 1;
  document.getElementById("operation").hidden = !(changes((row) => row.speed) || changes((row) => row.total_filling));
  panel("speed-chart", (place, width) => drawOperation(place, width, "Speed", "1/min", (row) => row.speed, (p) => fixed(2)(p.y) + " 1/min"));
  panel("filling-chart", (place, width) => drawOperation(place, width, "Filling", "%", (row) => inPercent(row.total_filling),
    (p) => fixed(1)(p.y) + " %"));
}

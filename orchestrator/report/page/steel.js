/** The steel of the whole liner per metre of the mill: as mass where the case tells its density, else as volume.
 *  With the mill's length it is that of the whole mill. */
const millLength = () => Number(settings.length) || null;
const hasDensity = () => known(data.liner_density);
const steelUnit = () => (hasDensity() ? millLength() ? "t" : "t/m" : millLength() ? "m³" : "m³/m");
const inSteel = (volume) => known(volume) ? volume * (hasDensity() ? data.liner_density / 1e3 : 1) * (millLength() || 1) : null;

/** Twice the signed area inside a polygon. */
const doubleArea = (points) => d3.sum(points, (p, i) => {
  const next = points[(i + 1) % points.length];
  return p[0] * next[1] - next[0] * p[1];
});

/** Volume of the new liner [m3 per m of the mill]. */
const newSteel = () => data.profiles.length
  ? data.sector.rows * Math.abs(doubleArea(data.profiles[0].nodes.concat(shellArc().reverse()))) / 2 : null;
const wornSteel = (row) => data.sector.rows * row.worn_volume;
const steelOf = (row) => newSteel() - wornSteel(row);

/** Steel worn for each tonne milled: [value, unit]. */
function steelPerTonne(row) {
  const amount = inSteel(wornSteel(row)) / row.tonnes * 1e6;
  const unit = hasDensity() ? "g/t" : "cm³/t";
  return `${significant(3)(amount)} ${unit}${millLength() ? "" : " for each metre of the mill's length"}`;
}

/** Mass of the liner against hours. */
function drawSteel(place, width) {
  const points = data.history.map((row) => ({x: row.operating_hours, y: inSteel(steelOf(row)),
    error: inSteel(data.sector.rows * row.worn_volume_error)}));
  return courseChart(place, width, {name: "Steel of the liner", value: steelUnit(), zero: true,
    text: (p) => `${significant(4)(p.y)} ${known(p.error) ? `± ${significant(2)(p.error)} ` : ""}${steelUnit()}`,
    series: [{colour: predictedColour, marks: true, points}]});
}

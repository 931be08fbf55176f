/** The place at an angle from three o'clock on the rising side, along the rotation [m]. */
const placeAt = (radius, angle) => [-radius * Math.cos(angle), radius * Math.sin(angle)];

/** The named places of a cycle's charge: {name, x, z} [m] and, for what lies on the liner, its angle [rad]. */
function landmarksOf(charge) {
  const {shoulder, bulk_toe: bulkToe, head, centre} = charge.landmarks;
  const measured = data.charges.find((one) => one.cycle === charge.cycle) || {};
  const onLiner = [["shoulder", shoulder], ["bulk toe", bulkToe], ["toe", measured.toe]].filter(([, angle]) => known(angle))
    .map(([name, angle]) => {
      const [x, z] = placeAt(data.sector.plate_radius, angle);
      return {name, x, z, angle};
    });
  return onLiner.concat([["head", head], ["centre of circulation", centre]].filter(([, at]) => at && at.every(known))
    .map(([name, [x, z]]) => ({name, x, z})));
}

/** Labels of the same side are moved apart, so that none covers another. */
function labelPlaces(landmarks, frame) {
  const labels = landmarks.map((one) => {
    const isLeft = one.x < 0;
    return {...one, px: frame.x(one.x), py: frame.y(one.z), anchor: isLeft ? "start" : "end", side: isLeft ? 1 : -1,
      line: frame.y(one.z)};
  });
  const lineHeight = 17;
  for (const side of [1, -1]) {
    const column = labels.filter((one) => one.side === side).sort((a, b) => a.line - b.line);
    column.forEach((one, i) => { if (i) one.line = Math.max(one.line, column[i - 1].line + lineHeight); });
  }
  return labels;
}

function drawLandmarks(svg, landmarks, frame) {
  for (const one of labelPlaces(landmarks, frame)) {
    const x = one.px + one.side * 14;
    if (known(one.angle)) {
      const [innerX, innerZ] = placeAt(data.sector.plate_radius * 0.93, one.angle);
      svg.append("line").attr({class: "landmark", x1: one.px, y1: one.py, x2: frame.x(innerX), y2: frame.y(innerZ)});
    }
    if (Math.abs(one.line - one.py) > 3)
      svg.append("line").attr({class: "leader", x1: one.px, y1: one.py, x2: x - one.side * 2, y2: one.line});
    svg.append("circle").attr({class: "landmark", cx: one.px, cy: one.py, r: 4});
    svg.append("text").attr({class: "landmark-name", x, y: one.line + 4, "text-anchor": one.anchor}).text(one.name);
  }
}

function fillLandmarks() {
  const charge = chargeOf(chosenLoad());
  const place = document.getElementById("landmarks-table");
  if (!charge) { place.replaceChildren(); return; }
  fillTable("landmarks-table", `Landmarks of the charge in cycle ${charge.cycle}`, landmarksOf(charge), [
    {head: "Landmark", text: (row) => row.name},
    {head: "Angle", unit: "°", text: (row) => fixed(1)(inClockDegrees(known(row.angle) ? row.angle : Math.atan2(row.z, -row.x)))},
    {head: "Radius", text: (row) => placeText(Math.hypot(row.x, row.z))},
    {head: "x", text: (row) => placeText(row.x)},
    {head: "z", text: (row) => placeText(row.z)},
  ]);
}

/** What the section can show: the maps of a cycle and what follows from them. */
const mapNames = {occupied: "Occupancy", speed: "Speed", temperature: "Granular temperature",
  normal_power: "Collision power, normal", shear_power: "Collision power, tangential", mean_diameter: "Mean size"};
const chargeOf = (load) => load && data.charge ? data.charge.cycles.find((one) => one.cycle === load.cycle) || null : null;

const mapTitle = (name) => mapNames[name] || "Share of " + name.replace("share_of_", "");

/** Names of the maps that some cycle has. */
function offeredMaps() {
  const there = d3.set(d3.merge(data.charge.cycles.map((one) => Object.keys(one.maps)))).values();
  const shares = there.filter((name) => name.startsWith("share_of_"));
  const hasSpeed = there.includes("velocity_x") && there.includes("velocity_z");
  return Object.keys(mapNames).filter((name) => name === "speed" ? hasSpeed : there.includes(name))
    .concat(shares.length > 1 ? shares : []);
}

const unitOfMap = (maps, name) => name === "speed" ? maps.velocity_x.unit : maps[name].unit;

/** The values of a map where a particle came. */
function fieldOf(maps, name) {
  if (name !== "speed") {
    const occupied = valuesOf(maps.occupied);
    return valuesOf(maps[name]).map((value, cell) => occupied[cell] > 0 ? value : NaN);
  }
  const along = valuesOf(maps.velocity_z);
  return valuesOf(maps.velocity_x).map((value, cell) => Math.hypot(value, along[cell]));
}

const isShare = (name) => name === "occupied" || name.startsWith("share_of_");
const hasMap = (maps, name) => Boolean(name === "speed" ? maps.velocity_x && maps.velocity_z : maps[name]);

/** The range of colours, which is that of all cycles. */
function rangeOfMap(maps, name) {
  if (name !== "speed") return maps[name];
  return {low: 0, high: d3.max([maps.velocity_x, maps.velocity_z], ({low, high}) => Math.max(Math.abs(low), Math.abs(high)))};
}

/** The section on paper: as wide as `width`, x to the right, z up, the rising side on the left. */
function sectionFrame(width, halfWidth) {
  const margin = {side: 4, head: 4, foot: 54};
  const size = Math.min(width, 680) - 2 * margin.side;
  const left = (width - size) / 2;
  const pixels = size / (2 * halfWidth);
  return {left, top: margin.head, size, height: size + margin.head + margin.foot, pixels,
    x: (metres) => left + (metres + halfWidth) * pixels, y: (metres) => margin.head + (halfWidth - metres) * pixels};
}

const colourNamed = (name) => getComputedStyle(document.documentElement).getPropertyValue(name);

/** The steel of one sector around six o'clock, repeated for all rows. */
function drawLinerAround(context, liner, frame) {
  const {shell_radius: shell, plate_radius: plate, rows} = data.sector;
  const steel = new Path2D();
  for (const [xi, eta] of liner.concat(arc(shell).reverse())) steel.lineTo(-frame.pixels * xi, frame.pixels * (plate - eta));
  steel.closePath();
  context.save();
  context.translate(frame.x(0), frame.y(0));
  context.fillStyle = colourNamed("--steel");
  context.strokeStyle = colourNamed("--shell");
  context.lineWidth = 0.7;
  for (let row = 0; row < rows; ++row) {
    context.fill(steel);
    context.stroke(steel);
    context.rotate(2 * Math.PI / rows);
  }
  context.restore();
}

/** Arrows every few cells; the speed `fastest` is as long as the space between two arrows. */
function drawArrows(context, maps, section, frame, fastest) {
  const across = valuesOf(maps.velocity_x);
  const along = valuesOf(maps.velocity_z);
  const cell = frame.size / section.cells;
  const every = Math.max(1, Math.round(22 / cell));
  const longest = every * cell / fastest;
  context.beginPath();
  for (let row = every >> 1; row < section.cells; row += every)
    for (let column = every >> 1; column < section.cells; column += every) {
      const at = column + section.cells * row;
      if (across[at] !== across[at]) continue;
      const [dx, dy] = [across[at] * longest, -along[at] * longest];
      const [tipX, tipY] = [frame.left + (column + 0.5) * cell + dx, frame.top + frame.size - (row + 0.5) * cell + dy];
      context.moveTo(tipX - dx, tipY - dy);
      context.lineTo(tipX, tipY);
      for (const side of [0.18, -0.18]) {
        context.moveTo(tipX, tipY);
        context.lineTo(tipX - 0.3 * dx + side * dy, tipY - 0.3 * dy - side * dx);
      }
    }
  context.strokeStyle = "#fff";
  context.lineWidth = 1.2;
  context.stroke();
}

function tellCell(svg, section, frame, name, field, shown) {
  svg.append("rect").attr({class: "catch", x: frame.left, y: frame.top, width: frame.size, height: frame.size})
    .on("mousemove", function () {
      const [px, py] = d3.mouse(this);
      const [x, z] = [(px - frame.x(0)) / frame.pixels, (frame.y(0) - py) / frame.pixels];
      const column = Math.floor((px - frame.left) / frame.size * section.cells);
      const row = Math.floor((frame.top + frame.size - py) / frame.size * section.cells);
      const value = field[column + section.cells * row];
      showTip(d3.event, value === value ? `${significant(3)(value * shown.factor)} ${shown.unit}` : "no particle was here",
        [["map", mapTitle(name)], ["x, z", `${placeText(x)}, ${placeText(z)}`], ["radius", placeText(Math.hypot(x, z))],
          ["angle", fixed(0)(inClockDegrees(Math.atan2(z, -x))) + "°"]]);
    }).on("mouseleave", hideTip);
}

/** A map of a cycle's charge, with the colours of a range. */
function drawMap(place, width, charge, name, range) {
  const frame = sectionFrame(width, charge.section.half_width);
  const field = fieldOf(charge.maps, name);
  const shown = isShare(name) ? {factor: 100, unit: "%"} : shownUnit(unitOfMap(charge.maps, name), range.high);
  const {context, svg} = canvasUnderSvg(place, width, frame.height, `${mapTitle(name)} over the section, cycle ${charge.cycle}`);
  context.beginPath();
  context.arc(frame.x(0), frame.y(0), frame.pixels * data.sector.shell_radius, 0, 2 * Math.PI);
  context.clip();
  context.drawImage(pixelCanvas(field, charge.section.cells, range), frame.left, frame.top, frame.size, frame.size);
  if (name === "speed") drawArrows(context, charge.maps, charge.section, frame, range.high);
  drawLinerAround(context, charge.liner, frame);
  drawLandmarks(svg, landmarksOf(charge), frame);
  colourBar(svg, {left: frame.left + 12, right: frame.left + frame.size - 24, top: frame.top + frame.size + 24}, range, shown);
  tellCell(svg, charge.section, frame, name, field, shown);
}

/** The chosen map of the chosen cycle. */
function drawSection(place, width) {
  const load = chosenLoad();
  const charge = chargeOf(load);
  const name = document.getElementById("charge-map").value;
  if (!charge || !hasMap(charge.maps, name)) nothing(place, withoutCharge(load));
  else drawMap(place, width, charge, name, rangeOfMap(charge.maps, name));
}

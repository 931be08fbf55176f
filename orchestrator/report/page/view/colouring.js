const rampOf = (...colours) => d3.scale.linear().domain(colours.map((colour, i) => i / (colours.length - 1)))
  .range(colours).interpolate(d3.interpolateLab);
const speedRamp = rampOf("#3b3f8f", "#2a7fa5", "#35a884", "#a9cf4b", "#ffe25a");
const sizeRamp = rampOf("#f2c14e", "#e0703a", "#a9407a", "#4c62b8");
const materialColours = ["#6d8fb3", "#c58b45", "#5f9f62", "#a7619b", "#8a8a8a"];
const withMillColours = ["#8e98a1", "#d0582a"];

/** The 256 colours [red, green, blue, 255] of colourAt(index). */
function paletteOf(colourAt) {
  const bytes = new Uint8Array(1024).fill(255);
  for (let i = 0; i < 256; i++) {
    const {r, g, b} = d3.rgb(colourAt(i));
    bytes.set([r, g, b], 4 * i);
  }
  return bytes;
}

/** Particles by what `of` gives for their class, in the order of `values`. */
function colouringByClass(of, values, colours, text) {
  const colourOf = (one) => colours[values.indexOf(of(one))];
  return {entry: 0, fast: 1, palette: ({charge: {classes}}) => paletteOf((i) => classes[i] ? colourOf(classes[i]) : "#000"),
    legend: (place) => key(place, values.map((value, i) => ({name: text(value), style: "block", colour: colours[i]})))};
}

function colouringBySize(classes) {
  const diameters = [...new Set(classes.map((one) => one.diameter))].sort(d3.descending);
  const colours = diameters.map((diameter, i) => sizeRamp(diameters.length > 1 ? 1 - i / (diameters.length - 1) : 1));
  return colouringByClass((one) => one.diameter, diameters, colours, (diameter) => Number(inMillimetres(diameter).toPrecision(3)) + " mm");
}

function colouringByMaterial(classes) {
  const materials = [...new Set(classes.map((one) => one.material))];
  return colouringByClass((one) => one.material, materials, materials.map((one, i) => materialColours[i % materialColours.length]), String);
}

/** What speed(turning) [m/s] is in the cycles of the campaigns, whose mill turns with `turning` [rad/s]. */
const speedsText = (campaigns, speed) => [...new Set(campaigns.flatMap((one) => inCampaign(one, () =>
  data.charge.cycles.map(({speed: turning}) => significant(2)(speed(turning))))))].join(" and ") + " m/s";

/** From 0 to `fast` [m/s]; what is faster has the last colour. */
function colouringBySpeed(campaigns, fast) {
  const stops = d3.range(0, 9).map((i) => speedRamp(i / 8)).join(",");
  const plates = speedsText(campaigns, (turning) => turning * data.sector.plate_radius);
  const palette = paletteOf((i) => speedRamp(i / 255));
  return {entry: 1, fast, palette: () => palette, legend: (place) => place.append(element("p", {class: "key"},
    element("span", {}, "0 ", element("i", {class: "ramp", style: `background:linear-gradient(90deg,${stops})`}),
      `${significant(2)(fast)} m/s and more`), element("span", {}, `the new plate moves with ${plates}`)))};
}

function colouringByMill(campaigns) {
  const palette = paletteOf((i) => withMillColours[Math.min(i, 1)]);
  return {entry: 2, fast: 1, palette: () => palette, legend: (place) => key(place, [
    {name: `moves with the mill, to ${speedsText(campaigns, slipWithMill)}`, style: "block",
      colour: withMillColours[1]},
    {name: "does not", style: "block", colour: withMillColours[0]}])};
}

/** How the particles of campaigns can be coloured: name to {entry: code of the shader, palette(campaign), fast [m/s],
 *  legend(place)}. */
function colouringsOf(campaigns, fast) {
  const classes = campaigns.flatMap((one) => one.charge.classes);
  return {"speed": colouringBySpeed(campaigns, fast), "material": colouringByMaterial(classes), "size": colouringBySize(classes),
    "what moves with the mill": colouringByMill(campaigns)};
}

/** The liner at the chosen moment: the last profile that is no older. */
const chosenOutline = () => chosenCharge() && outlineOf({...chosenCharge(), centres: []});
const pitchOf = ({sector}) => sector.shell_radius * Math.PI / sector.rows;

/** The profiles over each other, thin when new, in the frame of the campaign with the widest pitch. */
function drawProfiles(place, width) {
  const drawn = campaigns.filter(({data: {profiles}}) => profiles.length);
  const caption = document.getElementById("profiles-caption");
  if (!drawn.length) { caption.textContent = ""; nothing(place, "No profile was published yet."); return; }
  const widest = drawn.reduce((best, one) => pitchOf(one.data) > pitchOf(best.data) ? one : best);
  const crest = d3.max(drawn, ({data: {profiles}}) => crestOf(profiles[0].nodes));
  key(place, drawn.map((one) => ({name: one.name, colour: colourOf(one)})));
  const {svg, path} = inCampaign(widest.data, () => {
    const drawing = sectorDrawing(place, width, "Profiles at the chosen moment", crest, 34);
    drawPlate(drawing);
    return drawing;
  });
  for (const one of drawn) inCampaign(one.data, () => {
    svg.append("path").attr({class: "profile", d: path(data.profiles[0].nodes)}).style({stroke: colourOf(one), "stroke-opacity": 0.5});
    svg.append("path").attr({class: "profile end", d: path(chosenOutline())}).style("stroke", colourOf(one));
  });
  caption.textContent = "Thin: new. Thick: the chosen moment. Equal scales, origin on the new plate under the middle of the lifter" +
    (drawn.length > 1 ? `; shell and plate are those of ${widest.name}.` : ".");
}

/** Arc length at the middle of the lifter, where xi is 0 [m]. */
function middleOf(load) {
  const over = load.centres.map((p, i) => i).filter((i) => i && load.centres[i - 1][0] <= 0 && load.centres[i][0] > 0);
  if (!over.length) return load.arc_length[Math.floor(load.arc_length.length / 2)];
  const highest = over.reduce((best, i) => load.centres[i][1] > load.centres[best][1] ? i : best);
  return (load.arc_length[highest - 1] + load.arc_length[highest]) / 2;
}

/** The smoothed measure of the chosen cycle from the lifter's middle, [{x, y, se}] in m and the measure's unit. */
function measurePoints(measure) {
  const load = chosenCharge() && data.loads.find(({cycle}) => cycle === chosenCharge().cycle);
  if (!load) return [];
  const middle = middleOf(load);
  const line = load[measure.key];
  return line.smoothed.map((value, i) => ({x: load.arc_length[i] - middle, y: value, se: line.smoothed_error[i]}));
}

function drawComparedMeasure(place, width, measure) {
  const series = seriesOfEach(() => ({points: measurePoints(measure)})).filter((one) => one.points.length);
  if (!series.length) { nothing(place, "No campaign has the load of this cycle here."); return; }
  const scale = measure.isDepth ? {factor: 1 / inLength(secondsPerThousandHours), unit: depthRateUnit()}
    : prefixed(d3.merge(series.map((one) => one.points)).map((p) => p.y), measure.unit);
  const per = (value) => known(value) ? value / scale.factor : null;
  for (const one of series) one.points = one.points.map((p) => ({x: inLength(p.x), y: per(p.y), se: per(p.se)}));
  drawChart(place, width, {name: measure.name, x: `arc length from the lifter's middle [${lengthUnit()}]`, value: scale.unit, zero: true,
    series, place: (s) => `${fixed(isInch() ? 2 : 0)(s)} ${lengthUnit()} from the middle`,
    text: (p) => significant(3)(p.y) + (known(p.se) ? ` ± ${significant(2)(p.se)}` : "")});
}

function startOverlays() {
  cyclePanel("profiles-drawing", drawProfiles);
  for (const measure of measures.filter(({key}) => key !== "contacts"))
    cyclePanel(measure.id, (place, width) => drawComparedMeasure(place, width, measure));
}

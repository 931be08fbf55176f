/** Lines for the tip of one profile. */
function profileFacts(profile) {
  const row = historyOf(profile.cycle, profile.step) || {};
  return [["cycle, step", `${profile.cycle}, ${profile.step}`],
    ["lifter height", lengthText(row.lifter_height, 1)],
    ["leading face", fixed(1)(inDegrees(row.face_angle)) + "°"],
    ["thinnest plate", lengthText(row.plate_thickness, 1)],
    ["worn share", fixed(1)(inPercent(row.worn_fraction)) + " %"]];
}

function nearestProfile(drawing, [px, py]) {
  let best = null;
  let least = 26 * 26;
  for (const profile of data.profiles)
    for (const [xi, eta] of profile.nodes) {
      const distance = Math.pow(drawing.x(xi) - px, 2) + Math.pow(drawing.y(eta) - py, 2);
      if (distance < least) { least = distance; best = profile; }
    }
  return best;
}

/** The profiles of gauges and scans: dashed, in the colour of their hours. */
function drawMeasured({svg, path}) {
  svg.append("g").selectAll("path").data(data.measured_profiles).enter().append("path")
    .attr("class", "gauge").attr("d", (profile) => path(profile.nodes))
    .style("stroke", (profile) => ageColour(profile.operating_hours))
    .append("title").text((profile) => "measured at " + hoursText(profile.operating_hours));
}

/** The profile of the chosen cycle stands out, but for the one that is pointed at. Returns show(profile), with null
 *  for the chosen cycle's. */
function outstandingProfile({svg, path}) {
  const halo = svg.append("path").attr("class", "halo");
  const line = svg.append("path").attr("class", "chosen");
  return (profile) => {
    const nodes = profile ? profile.nodes : data.loads.length ? outlineOf(chosenLoad()) : [];
    const hours = profile ? profile.operating_hours : data.loads.length ? ageOfCycle(chosenLoad().cycle) : 0;
    halo.attr("d", path(nodes));
    line.attr("d", path(nodes)).style("stroke", ageColour(hours));
  };
}

function drawProfilesOverTime(place, width) {
  if (!data.profiles.length) { nothing(place, "No profile was published yet."); return null; }
  const last = data.profiles.length - 1;
  const crest = d3.max(data.profiles, (profile) => crestOf(profile.nodes));
  const drawing = sectorDrawing(place, width, "Profiles over time", crest, 58);
  const {svg, path, frame} = drawing;
  svg.append("path").attr({class: "steel", d: drawing.closed(data.profiles[0].nodes)});
  drawPlate(drawing);
  nameArcs(drawing);
  svg.append("g").selectAll("path").data(data.profiles).enter().append("path")
    .attr("class", (profile, i) => "profile" + (i === 0 || i === last ? " end" : ""))
    .attr("d", (profile) => path(profile.nodes))
    .style("stroke", (profile) => ageColour(profile.operating_hours));
  drawMeasured(drawing);
  ageLegend(drawing);
  const show = outstandingProfile(drawing);
  show(null);
  svg.append("rect").attr({class: "catch", x: frame.left, y: frame.top, width: frame.right - frame.left,
    height: frame.bottom - frame.top}).on("mousemove", function () {
    const profile = nearestProfile(drawing, d3.mouse(this));
    show(profile);
    if (profile) showTip(d3.event, courseText(profile.operating_hours), profileFacts(profile));
    else hideTip();
  }).on("mouseleave", () => { show(null); hideTip(); });
  return () => show(null);
}

/** The surface moved along its normal by so many standard errors of its depth. */
function movedByErrors(profile, errors) {
  const normals = normalsOf(profile.nodes);
  return profile.nodes.map((p, i) => [0, 1].map((k) => p[k] + errors * (profile.depth_error[i] || 0) * normals[i][k]));
}

/** The new liner and the last one with its 95 % band; the steel that is gone is filled. */
function drawOriginalAndWorn(place, width) {
  const caption = document.getElementById("worn-caption");
  if (data.profiles.length < 2) { caption.textContent = ""; nothing(place, "The liner has not been worn yet."); return; }
  const fresh = data.profiles[0];
  const worn = data.profiles[data.profiles.length - 1];
  const row = historyOf(worn.cycle, worn.step) || {};
  const section = known(row.worn_volume) ? ` (${significant(3)(inArea(row.worn_volume))} ${areaUnit()} of section)` : "";
  caption.textContent = `New, and after ${courseText(worn.operating_hours)}; the filled steel${section} is gone, ` +
    "the shade on the worn profile is its 95 % band.";
  const drawing = sectorDrawing(place, width, "Original and worn profile", crestOf(fresh.nodes), 34);
  const {svg, path} = drawing;
  svg.append("path").attr({class: "lost", d: path(fresh.nodes.concat(worn.nodes.slice().reverse())) + "Z"});
  svg.append("path").attr({class: "steel", d: drawing.closed(worn.nodes)});
  const band = [1.96, -1.96].map((errors) => movedByErrors(worn, errors));
  svg.append("path").attr({class: "band", d: path(band[0].concat(band[1].reverse())) + "Z"});
  for (const profile of [fresh, worn])
    svg.append("path").attr({class: "profile end", d: path(profile.nodes)})
      .style("stroke", ageColour(profile.operating_hours));
  const heights = [fresh, worn].map((profile) => drawing.y(crestOf(profile.nodes)));
  label(drawing, heights[0] - 6, "new");
  label(drawing, heights[1] - heights[0] > 20 ? heights[1] - 6 : heights[1] + 20, hoursText(worn.operating_hours));
}

function label(drawing, y, words) {
  drawing.svg.append("text").attr({class: "label", x: drawing.x(0), y, "text-anchor": "middle"}).text(words);
}

/** The liner when new, under the chosen cycle's load, and after the last step. */
function fillLiner() {
  if (!data.history.length || !data.loads.length) { nothing(document.getElementById("liner-table"), "No step was published yet."); return; }
  const liners = [["New", data.history[0]], [`Cycle ${chosenLoad().cycle}`, linerBefore(chosenLoad())], ["Last step", lastLiner()]];
  const rows = [
    {name: "Lifter height", unit: lengthUnit(), of: (row) => lengthFigure(row.lifter_height, 1)},
    {name: "Leading face", unit: "° off upright", of: (row) => fixed(1)(inDegrees(row.face_angle))},
    {name: "Thinnest plate", unit: lengthUnit(), of: (row) => lengthFigure(row.plate_thickness, 1)},
    {name: "Worn share of the new lifter", unit: "%", of: (row) => fixed(1)(inPercent(row.worn_fraction))},
    {name: "Worn section of a lifter", unit: areaUnit(), of: (row) => fixed(1)(inArea(row.worn_volume))},
    {name: "Liner", unit: steelUnit(), of: (row) => significant(4)(inSteel(steelOf(row)))},
    {name: "Roughness", unit: lengthUnit(), of: (row) => lengthFigure(row.roughness, 2)},
  ];
  fillTable("liner-table", "The liner when new, in the chosen cycle, and after the last step", rows,
    [{head: "", text: (row) => row.name, unitOf: (row) => row.unit}].concat(liners.map(([head, row]) =>
      ({head, unit: courseText(row.operating_hours), text: (line) => line.of(row)}))));
}

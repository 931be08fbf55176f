/** Lines for the tip of one profile. */
function profileFacts(profile) {
  const row = historyOf(profile.cycle, profile.step) || {};
  return [["cycle, step", `${profile.cycle}, ${profile.step}`],
    ["lifter height", fixed(1)(inMillimetres(row.lifter_height)) + " mm"],
    ["leading face", fixed(1)(inDegrees(row.face_angle)) + "°"],
    ["thinnest plate", fixed(1)(inMillimetres(row.plate_thickness)) + " mm"],
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

function drawProfilesOverTime(container) {
  if (!data.profiles.length) { nothing(container, "No profile was published yet."); return; }
  const last = data.profiles.length - 1;
  responsive(container, (place, width) => {
    const crest = d3.max(data.profiles, (profile) => crestOf(profile.nodes));
    const drawing = sectorDrawing(place, width, "Profiles over time", crest, 58);
    const {svg, path} = drawing;
    svg.append("path").attr({class: "steel", d: drawing.closed(data.profiles[0].nodes)});
    drawPlate(drawing);
    nameArcs(drawing);
    svg.append("g").selectAll("path").data(data.profiles).enter().append("path")
      .attr("class", (profile, i) => "profile" + (i === 0 || i === last ? " end" : ""))
      .attr("d", (profile) => path(profile.nodes))
      .style("stroke", (profile) => ageColour(profile.operating_hours));
    drawMeasured(drawing);
    ageLegend(drawing);
    const halo = svg.append("path").attr("class", "halo");
    const chosen = svg.append("path").attr("class", "chosen");
    const show = (profile) => {
      const shape = profile ? path(profile.nodes) : null;
      halo.attr("d", shape);
      chosen.attr("d", shape).style("stroke", profile ? ageColour(profile.operating_hours) : null);
    };
    const frame = drawing.frame;
    svg.append("rect").attr({class: "catch", x: frame.left, y: frame.top, width: frame.right - frame.left,
      height: frame.bottom - frame.top}).on("mousemove", function () {
      const profile = nearestProfile(drawing, d3.mouse(this));
      show(profile);
      if (profile) showTip(d3.event, hoursText(profile.operating_hours), profileFacts(profile));
      else hideTip();
    }).on("mouseleave", () => { show(null); hideTip(); });
  });
}

/** The first cycle's bins on the new profile: a dot a bin centre. */
function drawBins(container, caption) {
  const load = data.loads[0];
  if (!load || !load.centres.length || !data.profiles.length) {
    nothing(container, "No load was published yet.");
    return;
  }
  const widths = load.width.map(inMillimetres);
  caption.textContent = `${load.centres.length} bins of ${significant(3)(d3.min(widths))} to ` +
    `${significant(3)(d3.max(widths))} mm; a dot is the centre of a bin.`;
  responsive(container, (place, width) => {
    const nodes = data.profiles[0].nodes;
    const drawing = sectorDrawing(place, width, "Bins of the new lifter", crestOf(nodes), 34);
    const {svg, x, y, path} = drawing;
    svg.append("path").attr({class: "steel", d: drawing.closed(nodes)});
    svg.append("path").attr({class: "profile", d: path(nodes)}).style("stroke", ageColour(0));
    svg.append("g").attr("class", "bins").selectAll("circle").data(load.centres).enter().append("circle")
      .attr({cx: (p) => x(p[0]), cy: (p) => y(p[1]), r: 2.1, fill: ageColour(0)});
  });
}

/** The surface moved along its normal by so many standard errors of its depth. */
function movedByErrors(profile, errors) {
  const normals = normalsOf(profile.nodes);
  return profile.nodes.map((p, i) => [0, 1].map((k) => p[k] + errors * (profile.depth_error[i] || 0) * normals[i][k]));
}

/** The new liner and the last one with its 95 % band; the steel that is gone is filled. */
function drawOriginalAndWorn(container, caption) {
  if (data.profiles.length < 2) { nothing(container, "The liner has not been worn yet."); return; }
  const fresh = data.profiles[0];
  const worn = data.profiles[data.profiles.length - 1];
  const row = historyOf(worn.cycle, worn.step) || {};
  const section = known(row.worn_volume) ? ` (${significant(3)(1e4 * row.worn_volume)} cm² of section)` : "";
  caption.textContent = `New, and after ${hoursText(worn.operating_hours)}; the filled steel${section} is gone, ` +
    "the shade on the worn profile is its 95 % band.";
  responsive(container, (place, width) => {
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
  });
}

function label(drawing, y, words) {
  drawing.svg.append("text").attr({class: "label", x: drawing.x(0), y, "text-anchor": "middle"}).text(words);
}

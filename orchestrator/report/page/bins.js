/** The chosen cycle's bins on its profile: a dot a bin centre. */
function drawBins(place, width) {
  const caption = document.getElementById("bins-caption");
  const load = chosenLoad();
  if (!load || !load.centres.length || !data.profiles.length) {
    caption.textContent = "";
    nothing(place, "No load was published yet.");
    return;
  }
  const widths = load.width.map(inLength);
  caption.textContent = `${load.centres.length} bins of ${significant(3)(d3.min(widths))} to ` +
    `${significant(3)(d3.max(widths))} ${lengthUnit()}; a dot is the centre of a bin.`;
  const drawing = sectorDrawing(place, width, "Bins of the lifter", crestOf(data.profiles[0].nodes), 34);
  const {svg, x, y, path} = drawing;
  const colour = ageColour(ageOfCycle(load.cycle));
  svg.append("path").attr({class: "steel", d: drawing.closed(outlineOf(load))});
  svg.append("path").attr({class: "profile", d: path(outlineOf(load))}).style("stroke", colour);
  svg.append("g").attr("class", "bins").selectAll("circle").data(load.centres).enter().append("circle")
    .attr({cx: (p) => x(p[0]), cy: (p) => y(p[1]), r: 2.1}).style("fill", colour);
}

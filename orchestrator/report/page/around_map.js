const aroundMeasures = {contacts: "Contacts", normal_dissipation: "Normal dissipation", sliding_work: "Sliding work"};

/** The places of the clock along the turn from six o'clock on [degrees behind six o'clock]. */
const clockPlaces = [[0, "6 o'clock"], [90, "rising"], [180, "12 o'clock"], [270, "descending"], [360, "6 o'clock"]];

function aroundAxes(svg, frame, x, y, load) {
  const isWide = frame.right - frame.left > 380;
  for (const [degrees, name] of clockPlaces) {
    const anchor = degrees === 0 ? "start" : degrees === 360 ? "end" : "middle";
    svg.append("line").attr({class: "mark", x1: x(degrees), x2: x(degrees), y1: frame.top, y2: frame.bottom + 5});
    svg.append("text").attr({x: x(degrees), y: frame.bottom + 18, "text-anchor": anchor})
      .text(aroundText(270 + degrees));
    if (isWide) svg.append("text").attr({x: x(degrees), y: frame.bottom + 33, "text-anchor": anchor}).text(name);
  }
  const upright = d3.svg.axis().scale(y.copy().domain(y.domain().map(inLength))).orient("left").ticks(6).tickSize(5, 0).tickPadding(6);
  svg.append("g").attr({class: "axis", transform: `translate(${frame.left},0)`}).call(upright);
  svg.append("text").attr({x: 0, y: 12}).text(`along the profile [${lengthUnit()}]`);
  for (const corner of corners(load))
    svg.append("line").attr({class: "mark corner", x1: frame.left, x2: frame.right, y1: y(corner), y2: y(corner)});
}

function tellAround(svg, frame, x, y, load, around, name, values, range, shown) {
  svg.append("rect").attr({class: "catch", x: frame.left, y: frame.top, width: frame.right - frame.left, height: frame.bottom - frame.top})
    .on("mousemove", function () {
      const [px, py] = d3.mouse(this);
      const degrees = Math.max(0, Math.min(359.999, x.invert(px)));
      const place = y.invert(py);
      const bin = Math.min(d3.bisectLeft(load.arc_length.map((s, i) => s + load.width[i] / 2), place), load.arc_length.length - 1);
      const value = values[Math.floor(degrees / 360 * around.angles) + around.angles * bin];
      const words = (number) => `${significant(3)(number * shown.factor)} ${shown.unit}`;
      showTip(d3.event, value === value ? words(value) : "less than " + words(range.low),
        [["measure", aroundMeasures[name]], ["angle", aroundText(270 + degrees)],
          ["along the profile", lengthText(place, 0)]]);
      loadView.place(load.arc_length[bin]);
    }).on("mouseleave", () => { hideTip(); loadView.leave(); });
}

/** The chosen measure of the chosen cycle, around the turn and along the profile. */
function drawAround(place, width) {
  const load = chosenLoad();
  const charge = chargeOf(load);
  const name = document.getElementById("around-measure").value;
  if (!charge || !charge.around) { nothing(place, charge ? "The load around the turn was not recorded in this cycle." : withoutCharge(load)); return; }
  const {around} = charge;
  const range = around.maps[name];
  const values = valuesOf(range);
  const shown = shownUnit(range.unit, range.high);
  const end = load.arc_length.length - 1;
  const frame = {left: 46, right: width - 6, top: 24, bottom: 324};
  const x = d3.scale.linear().domain([0, 360]).range([frame.left, frame.right]);
  const y = d3.scale.linear().domain([0, load.arc_length[end] + load.width[end] / 2]).range([frame.bottom, frame.top]);
  const {context, svg} = canvasUnderSvg(place, width, frame.bottom + 90, `${aroundMeasures[name]} around the turn, cycle ${charge.cycle}`);
  const pixels = pixelCanvas(values, around.angles, range);
  load.arc_length.forEach((s, bin) => {
    const top = y(s + load.width[bin] / 2);
    context.drawImage(pixels, 0, end - bin, around.angles, 1, frame.left, top, frame.right - frame.left, y(s - load.width[bin] / 2) - top + 0.3);
  });
  aroundAxes(svg, frame, x, y, load);
  colourBar(svg, {left: frame.left, right: frame.right - 20, top: frame.bottom + 60}, range, shown);
  tellAround(svg, frame, x, y, load, around, name, values, range, shown);
}

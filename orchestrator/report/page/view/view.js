const viewKeys = "Drag to turn the mill. Click a picture first to zoom with the wheel. Two fingers move and zoom. Keys: the arrows turn, " +
  "Shift and arrows move, + and − zoom, 0 looks along the axis again, and so does a double click.";

/** A choice of what the particles' colours tell: {control, legend, chosen(), update() after the cycles have changed}. */
function colouringChoice(viewed, panes, changed) {
  const campaigns = [...new Set(viewed.map(({campaign}) => campaign))];
  const names = Object.keys(colouringsOf(campaigns, 1));
  const choice = element("select", {}, ...names.map((name) => element("option", {}, name)));
  const legend = element("div", {class: "legend"});
  let colouring = null;
  const update = () => {
    colouring = colouringsOf(campaigns, d3.max(panes, (pane) => pane.one.movement().fast))[choice.value];
    legend.replaceChildren();
    colouring.legend(legend);
    for (const pane of panes) pane.describe();
    changed();
  };
  choice.addEventListener("change", update);
  return {control: element("label", {class: "control"}, "Colour ", choice), legend, update, chosen: () => colouring};
}

/** Draws on the next frame of the browser, once for all calls before; again and again while it plays in sight. */
function drawingLoop(draw, goesOn) {
  let asked = false;
  const request = () => {
    if (asked) return;
    asked = true;
    requestAnimationFrame((now) => {
      asked = false;
      draw(now);
      if (goesOn()) request();
    });
  };
  return request;
}

/** Calls start() when an element first comes near, and tells `seen` whenever it comes and goes. */
function whenNear(watched, start, seen) {
  let started = false;
  new IntersectionObserver((entries) => {
    const near = entries[entries.length - 1].isIntersecting;
    if (near && !started) { started = true; start(); }
    seen(near);
  }, {rootMargin: "300px"}).observe(watched);
}

function fillChargeView(section, viewed, shown) {
  const camera = cameraFor(d3.max(viewed, ({campaign: {charge, sector}}) => charge.slice_length / (2 * sector.shell_radius)));
  const playback = playbackOf(d3.min(viewed, ({charge: {frames: {times}}}) => times[times.length - 1] - times[0]));
  let near = false;
  const redraw = drawingLoop((now) => {
    playback.advance(now);
    controls.show();
    if (near) for (const pane of panes) pane.draw(playback.time, camera, colouring.chosen());
  }, () => near && playback.playing);
  const controls = playbackControls(playback, redraw);
  const panes = shown.map((first) => viewPane(viewed, first, redraw, () => colouring.update()));
  const colouring = colouringChoice(viewed, panes, redraw);
  for (const pane of panes) steer(pane.canvas, camera, redraw);
  const front = element("button", {type: "button"}, "Look along the axis");
  front.addEventListener("click", () => { lookAlongAxis(camera); redraw(); });
  section.append(
    element("form", {class: "controls", autocomplete: "off"}, ...controls.parts, colouring.control, front),
    colouring.legend, element("div", {class: "pair"}, ...panes.map((pane) => pane.figure)),
    element("p", {class: "caption on-screen", id: "charge-view-keys"}, viewKeys));
  whenNear(section, () => {
    section.classList.toggle("flat", !panes.map((pane) => pane.start()).every(Boolean));
    colouring.update();
  }, (seen) => {
    near = seen;
    redraw();
  });
  onSettings(redraw);
}

/** Builds the view in an empty section: the mill in space, which turns and plays. `shown` are the viewed charges, by
 *  their numbers, that the pictures begin with. */
function buildChargeView(section, viewed, shown) {
  section.classList.add("charge-view");
  section.append(element("h3", {}, "In the mill"));
  if (!viewed.length) {
    section.append(element("p", {class: "nothing"}, "No frames of the charge were kept in this run."));
    return;
  }
  const slices = [...new Set(viewed.map(({campaign}) => Number(campaign.charge.slice_length.toPrecision(3))))];
  section.append(element("p", {class: "on-screen"}, `The first moments of a measurement, ${slowedDown} times slower than the mill ` +
    `turns. Between two frames the particles move on straight lines. The slice is ${slices.join(" or ")} m long; the pictures show it ` +
    "without end walls."));
  fillChargeView(section, viewed, shown);
}

/** The charges of a campaign that have frames. */
const viewedCharges = (campaign, nameOf) => ((campaign.charge || {}).cycles || [])
  .filter(({frames}) => frames && frames.times.length > 1).map((charge) => viewedCharge(campaign, charge, nameOf(charge)));

/** The view of one campaign, new beside worn. */
function startChargeView(section) {
  const viewed = viewedCharges(data, ({cycle}) => cycleText(cycle));
  buildChargeView(section, viewed, viewed.length > 1 ? [0, viewed.length - 1] : [0]);
}

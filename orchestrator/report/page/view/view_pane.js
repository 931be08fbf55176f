/** What a view needs of a cycle's charge, each worked out when it is first asked for. */
function viewedCharge(charge) {
  const once = (make) => { let made = null; return () => made || (made = make()); };
  const load = data.loads.find((one) => one.cycle === charge.cycle) || {cycle: charge.cycle, centres: []};
  const frames = once(() => decodedFrames(charge.frames));
  return {charge, frames, mesh: once(() => sectorMesh(outlineOf(load))), fast: once(() => fastSpeed(frames())),
    withMill: once(() => sharesWithMill(frames()))};
}

const cycleText = (cycle) => `cycle ${cycle}, from ${hoursText(ageOfCycle(cycle))}`;

function paneWords({charge, withMill}) {
  const shown = charge.frames.thinning > 1
    ? `One particle in ${charge.frames.thinning} is shown, ${grouped(charge.frames.particles)} in all.`
    : `${grouped(charge.frames.particles)} particles.`;
  const moving = withMill().map(([material, share]) => `${fixed(0)(inPercent(share))} % of the ${material}`).join(" and ");
  return `${shown} By mass ${moving} moves with the mill, the mean over the frames.`;
}

/** What stands for the picture in print and where the browser has no WebGL 2. */
function standIn({cycle, pictures}) {
  const picture = (pictures || {}).section;
  return picture ? element("img", {src: picture, alt: "Section of the mill with its charge, " + cycleText(cycle)})
    : element("p", {class: "nothing"}, "This picture turns and moves in a browser with WebGL 2.");
}

/**
 * One picture with the choice of its cycle: figure, one (the viewedCharge that is shown), draw(time, camera, colouring).
 * Calls redraw() where it has to be drawn anew, and cycleChosen() where it shows another cycle.
 */
function viewPane(viewed, first, redraw, cycleChosen) {
  const choice = element("select", {}, ...viewed.map(({charge}, i) => element("option", {value: i}, cycleText(charge.cycle))));
  const canvas = element("canvas", {tabindex: 0, role: "img", "aria-describedby": "charge-view-keys"});
  const instead = element("div", {class: "stand-in"});
  const caption = element("figcaption", {});
  const pane = {canvas, figure: element("figure", {}, element("label", {class: "control"}, "DEM ", choice), canvas, instead, caption)};
  let scene = null;
  const choose = (i) => {
    pane.one = viewed[i];
    choice.value = i;
    canvas.setAttribute("aria-label", "The charge in the mill, " + cycleText(pane.one.charge.cycle));
    instead.replaceChildren(standIn(pane.one.charge));
  };
  const start = () => {
    scene = chargeScene(canvas);
    pane.figure.classList.toggle("flat", !scene);
    redraw();
  };
  choice.addEventListener("change", () => { choose(Number(choice.value)); cycleChosen(); });
  canvas.addEventListener("webglcontextlost", (event) => { event.preventDefault(); scene = null; });
  canvas.addEventListener("webglcontextrestored", start);
  new ResizeObserver(() => {
    const pixels = Math.min(devicePixelRatio || 1, 2);
    canvas.width = Math.max(1, Math.round(canvas.clientWidth * pixels));
    canvas.height = Math.max(1, Math.round(canvas.clientHeight * pixels));
    redraw();
  }).observe(canvas);
  choose(first);
  pane.start = start;
  pane.draw = (time, camera, colouring) => {
    if (!scene) return;
    scene.draw(pane.one, time, camera, colouring);
    caption.textContent = paneWords(pane.one);
  };
  return pane;
}

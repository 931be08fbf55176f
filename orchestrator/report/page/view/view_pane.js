/** What a view needs of a cycle's charge in a campaign, each worked out when it is first asked for. */
function viewedCharge(campaign, charge, name) {
  const once = (make) => { let made = null; return () => made || (made = inCampaign(campaign, make)); };
  const frames = once(() => decodedFrames(charge.frames));
  return {campaign, charge, name, frames, mesh: once(() => sectorMesh(charge.liner)), movement: once(() => movementOf(frames(), charge.speed))};
}

const cycleText = (cycle) => `cycle ${cycle}, from ${hoursText(ageOfCycle(cycle))}`;

function paneWords({charge, movement}) {
  const shown = charge.frames.thinning > 1
    ? `One particle in ${charge.frames.thinning} is shown, ${grouped(charge.frames.particles)} in all.`
    : `${grouped(charge.frames.particles)} particles.`;
  const moving = movement().withMill.map(([material, share]) => `${fixed(0)(inPercent(share))} % of the ${material}`).join(", ");
  return `${shown} Moves with the mill, by mass: ${moving} (mean over the frames).`;
}

/** What stands for the picture in print and where the browser has no WebGL 2. */
function standIn({charge, name}) {
  const picture = (charge.pictures || {}).section;
  return picture ? element("img", {src: picture, alt: "Section of the mill with its charge, " + name})
    : element("p", {class: "nothing"}, "The charge is shown on a screen, by a browser with WebGL 2.");
}

/**
 * One picture with the choice of its cycle: figure, canvas, one (the viewedCharge that is shown); start() tells whether
 * it can draw, describe() and draw(time, camera, colouring) show. Calls redraw() where it has to be drawn anew, and
 * chosen() where it shows another cycle.
 */
function viewPane(viewed, first, redraw, chosen) {
  const choice = element("select", {}, ...viewed.map(({name}, i) => element("option", {value: i}, name)));
  const canvas = element("canvas", {tabindex: 0, role: "img", "aria-describedby": "charge-view-keys"});
  const instead = element("div", {class: "stand-in"});
  const caption = element("figcaption", {});
  const label = element("label", {class: "control"}, "Shown ", choice);
  const pane = {canvas, figure: element("figure", {}, label, canvas, instead, caption)};
  let scene = null;
  const choose = (i) => {
    pane.one = viewed[i];
    choice.value = i;
    canvas.setAttribute("aria-label", "The charge in the mill, " + pane.one.name);
    instead.replaceChildren(standIn(pane.one));
  };
  const start = () => {
    scene = chargeScene(canvas);
    redraw();
    return scene !== null;
  };
  choice.addEventListener("change", () => { choose(Number(choice.value)); chosen(); });
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
  pane.describe = () => { caption.textContent = paneWords(pane.one); };
  pane.draw = (time, camera, colouring) => { if (scene) inCampaign(pane.one.campaign, () => scene.draw(pane.one, time, camera, colouring)); };
  return pane;
}

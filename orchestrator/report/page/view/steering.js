/** Keys of the focused picture: [yaw, tilt] by arrows, with the shift key the picture moves. */
const arrowKeys = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]};

function steerByKeys(canvas, camera, changed) {
  canvas.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const arrow = arrowKeys[event.key];
    if (arrow && event.shiftKey) moveCamera(camera, 0.1 * arrow[0], 0.1 * arrow[1]);
    else if (arrow) turnCamera(camera, 0.1 * arrow[0], 0.1 * arrow[1]);
    else if (event.key === "+" || event.key === "=") zoomCamera(camera, 1.2, 0, 0);
    else if (event.key === "-") zoomCamera(camera, 1 / 1.2, 0, 0);
    else if (event.key === "0") lookAlongAxis(camera);
    else if (event.key === "Escape") canvas.blur();
    else return;
    event.preventDefault();
    changed();
  });
}

/** Places of an event from the middle of the picture, in halves of its height. */
function placeInPicture(canvas, event) {
  const box = canvas.getBoundingClientRect();
  return [(event.clientX - box.left - box.width / 2) * 2 / box.height, (box.top + box.height / 2 - event.clientY) * 2 / box.height];
}

/** One finger or the mouse turns, two fingers move and zoom, and so does the mouse with the shift key. */
function steerByPointers(canvas, camera, changed) {
  const held = new Map();
  const middleAndSpread = () => {
    const [a, b] = [...held.values()];
    return {middle: [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2], spread: Math.hypot(a[0] - b[0], a[1] - b[1])};
  };
  canvas.addEventListener("pointerdown", (event) => {
    if (event.button) return;
    canvas.setPointerCapture(event.pointerId);
    held.set(event.pointerId, placeInPicture(canvas, event));
  });
  canvas.addEventListener("pointermove", (event) => {
    if (!held.has(event.pointerId) || held.size > 2) return;
    const before = held.get(event.pointerId);
    const place = placeInPicture(canvas, event);
    const fingers = held.size === 2 ? middleAndSpread() : null;
    held.set(event.pointerId, place);
    if (fingers) {
      const {middle, spread} = middleAndSpread();
      moveCamera(camera, fingers.middle[0] - middle[0], fingers.middle[1] - middle[1]);
      zoomCamera(camera, spread / fingers.spread, ...middle);
    } else if (event.shiftKey) moveCamera(camera, before[0] - place[0], before[1] - place[1]);
    else turnCamera(camera, -1.5 * (place[0] - before[0]), -1.5 * (place[1] - before[1]));
    changed();
  });
  for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, (event) => held.delete(event.pointerId));
}

/** The wheel zooms where the pointer is. It belongs to the page until the picture is clicked. */
function steerByWheel(canvas, camera, changed) {
  canvas.addEventListener("wheel", (event) => {
    if (document.activeElement !== canvas && !event.ctrlKey) return;
    event.preventDefault();
    const pixels = event.deltaY * (event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 30 : 1);
    zoomCamera(camera, Math.exp(-pixels * (event.ctrlKey ? 0.01 : 0.0015)), ...placeInPicture(canvas, event));
    changed();
  }, {passive: false});
}

/** Lets the pointer, the wheel and the keys move the camera; calls changed() after each. */
function steer(canvas, camera, changed) {
  steerByKeys(canvas, camera, changed);
  steerByPointers(canvas, camera, changed);
  steerByWheel(canvas, camera, changed);
  canvas.addEventListener("click", () => canvas.focus({preventScroll: true}));
  canvas.addEventListener("dblclick", () => { lookAlongAxis(camera); changed(); });
}

/** A panel is a place that is drawn as wide as it is. Those in the window come first; the others follow one by one
 *  while nothing else happens. */
const panels = new Map();
const pauseBeforeOthers = 150;
let timerOfOthers = 0;
let frameOfWindow = 0;

/** 0 while a place is too narrow to draw on. */
function widthOf(place) {
  const width = Math.round(place.getBoundingClientRect().width);
  return width < 50 ? 0 : width;
}

function drawPanel(place) {
  const panel = panels.get(place);
  if (!panel.width) panel.width = widthOf(place);
  if (!panel.width) return;
  place.classList.remove("waiting");
  place.replaceChildren();
  panel.move = panel.draw(place, panel.width) || null;
  panel.stale = panel.moved = false;
}

function bringUpToDate(place) {
  const panel = panels.get(place);
  if (panel.stale) drawPanel(place);
  else if (panel.moved) { panel.moved = false; panel.move(); }
}

const isBehind = (panel) => panel.stale || panel.moved;
const placesBehind = () => [...panels].filter(([, panel]) => isBehind(panel)).map(([place]) => place);

function drawOthers() {
  const place = placesBehind().find((one) => panels.get(one).width || widthOf(one));
  if (!place) return;
  bringUpToDate(place);
  timerOfOthers = setTimeout(drawOthers);
}

/** Draws what is in the window before the next frame, and the rest later. */
function drawSoon() {
  cancelAnimationFrame(frameOfWindow);
  clearTimeout(timerOfOthers);
  frameOfWindow = requestAnimationFrame(() => placesBehind().filter((place) => panels.get(place).inWindow).forEach(bringUpToDate));
  timerOfOthers = setTimeout(drawOthers, pauseBeforeOthers);
}

const panelsInWindow = new IntersectionObserver((entries) => {
  for (const {target, isIntersecting} of entries) {
    panels.get(target).inWindow = isIntersecting;
    if (isIntersecting) bringUpToDate(target);
  }
});

const panelWidths = new ResizeObserver((entries) => {
  for (const {target} of entries) {
    const width = widthOf(target);
    const panel = panels.get(target);
    if (width && width !== panel.width) Object.assign(panel, {width, stale: true});
  }
  if (placesBehind().length) drawSoon();
});

function addPanel(id, draw, drawnAnew) {
  const place = document.getElementById(id);
  place.classList.add("waiting");
  panels.set(place, {draw, drawnAnew, width: 0, move: null, stale: true, moved: false, inWindow: false});
  panelsInWindow.observe(place);
  panelWidths.observe(place);
}

/** draw(place, width [px]) may return a function that follows the chosen cycle without drawing anew. */
const panel = (id, draw) => addPanel(id, draw, "settings");

/** A panel that is drawn anew for every chosen cycle. */
const cyclePanel = (id, draw) => addPanel(id, draw, "cycle");

function moveToChosenCycle() {
  for (const panel of panels.values())
    if (panel.drawnAnew === "cycle") panel.stale = true;
    else if (panel.move) panel.moved = true;
  drawSoon();
}

function redrawPanel(id) {
  panels.get(document.getElementById(id)).stale = true;
  drawSoon();
}

function redrawPanels() {
  for (const panel of panels.values()) panel.stale = true;
  drawSoon();
}

function drawAllPanels() {
  placesBehind().forEach(bringUpToDate);
}

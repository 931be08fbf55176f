/** The DEM cycle that the page shows; one choice for all panels. */
const chosenCycle = {index: 0, shown: []};
const chosenLoad = () => data.loads[chosenCycle.index];

/** Calls show() now, and whenever another cycle is chosen. */
function onCycle(show) {
  chosenCycle.shown.push(show);
  show();
}

function chooseCycle(index) {
  const wanted = Math.max(0, Math.min(index, data.loads.length - 1));
  if (wanted === chosenCycle.index) return;
  chosenCycle.index = wanted;
  for (const show of chosenCycle.shown) show();
  moveToChosenCycle();
}

/** The cycle that the fragment of the address names; the first where it names none. */
function chooseCycleOf(fragment) {
  chooseCycle(data.loads.findIndex((load) => String(load.cycle) === fragment.get("cycle")));
}

function chosenCycleText() {
  const {cycle} = chosenLoad();
  return `Cycle ${cycle} (${chosenCycle.index + 1} of ${data.loads.length}): ${courseText(ageOfCycle(cycle))}`;
}

function keepChosenCycle(kept) {
  if (chosenCycle.index) kept.set("cycle", chosenLoad().cycle);
}

/** The slider over the campaign. */
function startCycleChoice() {
  const bar = document.getElementById("cycle-choice");
  if (!data.loads.length) { bar.remove(); return; }
  const [previous, slider, next] = ["previous", "slider", "next"].map((part) => document.getElementById(`cycle-${part}`));
  const words = document.getElementById("cycle-words");
  slider.max = data.loads.length - 1;
  bar.addEventListener("submit", (event) => event.preventDefault());
  slider.addEventListener("input", () => chooseCycle(Number(slider.value)));
  slider.addEventListener("change", writeFragment);
  for (const [button, step] of [[previous, -1], [next, 1]])
    button.addEventListener("click", () => { chooseCycle(chosenCycle.index + step); writeFragment(); });
  const show = () => {
    slider.value = chosenCycle.index;
    slider.setAttribute("aria-valuetext", `cycle ${chosenLoad().cycle}`);
    words.textContent = chosenCycleText();
    previous.disabled = chosenCycle.index === 0;
    next.disabled = chosenCycle.index === data.loads.length - 1;
  };
  onCycle(show);
  onSettings(show);
}

/** The DEM cycle that the panels below show; one choice for all of them. */
const chosenCycle = {index: 0, shown: []};

function onCycle(show) {
  chosenCycle.shown.push(show);
  show();
}

function chooseCycle(index) {
  chosenCycle.index = index;
  for (const show of chosenCycle.shown) show();
}

/** Makes NAME-previous, NAME-cycle and NAME-next choose the cycle. */
function offerCycles(name) {
  const [previous, choice, next] = ["previous", "cycle", "next"].map((part) => document.getElementById(`${name}-${part}`));
  data.loads.forEach((load, i) =>
    choice.append(element("option", {value: i}, `${load.cycle}, from ${hoursText(ageOfCycle(load.cycle))}`)));
  choice.addEventListener("change", () => chooseCycle(Number(choice.value)));
  previous.addEventListener("click", () => chooseCycle(chosenCycle.index - 1));
  next.addEventListener("click", () => chooseCycle(chosenCycle.index + 1));
  onCycle(() => {
    choice.value = chosenCycle.index;
    previous.disabled = chosenCycle.index === 0;
    next.disabled = chosenCycle.index === data.loads.length - 1;
  });
}

/** What the reader chose in the settings bar, by the names of its fields. The fragment of the page's address keeps
 *  what is not the default, and the chosen cycle. */
const settingsForm = document.getElementById("settings");
const settingFields = [...settingsForm.elements].filter((field) => field.name);
const settings = {};
const settingsActs = [];

const defaultOf = (field) => field.options ? field.options[0].value : field.defaultValue;

function readSettings() {
  for (const field of settingFields) settings[field.name] = field.checkValidity() ? field.value : defaultOf(field);
}

/** An unknown value in the address gives way to the default. */
function readFragment() {
  const given = new URLSearchParams(location.hash.slice(1));
  for (const field of settingFields) {
    field.value = given.has(field.name) ? given.get(field.name) : defaultOf(field);
    if (field.value === "" || !field.checkValidity()) field.value = defaultOf(field);
  }
  readSettings();
  return given;
}

function writeFragment() {
  const kept = new URLSearchParams();
  for (const field of settingFields) if (settings[field.name] !== defaultOf(field)) kept.set(field.name, settings[field.name]);
  if (chosenCycle.index) kept.set("cycle", data.loads[chosenCycle.index].cycle);
  history.replaceState(null, "", "#" + kept);
}

/** Calls act() now, and whenever a setting changes. */
function onSettings(act) {
  settingsActs.push(act);
  act();
}

function settingsChanged() {
  for (const act of settingsActs) act();
  redrawPanels();
}

/** Dates need a first day, and tonnes a feed rate. */
function offerAxes() {
  const offered = {hours: true, tonnes: tonnesPerHour > 0, dates: Boolean(settings.start)};
  const choice = settingsForm.elements.axis;
  for (const option of choice.options) option.disabled = !offered[option.value];
  if (!offered[settings.axis]) choice.value = settings.axis = "hours";
}

function startSettings() {
  onSettings(offerAxes);
  settingsForm.addEventListener("submit", (event) => event.preventDefault());
  settingsForm.addEventListener("change", (event) => {
    readSettings();
    if (event.target.name === "start" && settings.start) settings.axis = settingsForm.elements.axis.value = "dates";
    settingsChanged();
    writeFragment();
  });
  addEventListener("hashchange", () => {
    if (!location.hash.includes("=")) { writeFragment(); return; }
    chooseCycleOf(readFragment());
    settingsChanged();
  });
}

readFragment();

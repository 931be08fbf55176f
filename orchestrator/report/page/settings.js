/** What the reader chose in the settings bar, by the names of its fields. The fragment of the page's address keeps
 *  what is not the default, and what the page adds. */
const settingsForm = document.getElementById("settings");
const settingFields = [...settingsForm.elements].filter((field) => field.name);
const settings = {};
const settingsActs = [];
const fragmentParts = [];

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
  for (const {write} of fragmentParts) write(kept);
  history.replaceState(null, "", "#" + kept);
}

/** What else stands in the fragment, URLSearchParams: read(given) now and whenever the address changes, write(kept). */
function onFragment(read, write) {
  fragmentParts.push({read, write});
  read(new URLSearchParams(location.hash.slice(1)));
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

function startSettings() {
  settingsForm.addEventListener("submit", (event) => event.preventDefault());
  settingsForm.addEventListener("change", () => {
    readSettings();
    settingsChanged();
    writeFragment();
  });
  addEventListener("hashchange", () => {
    if (!location.hash.includes("=")) { writeFragment(); return; }
    const given = readFragment();
    for (const {read} of fragmentParts) read(given);
    settingsChanged();
  });
}

readFragment();

/** The page is light or dark, as the reader chose or as the system is; paper is always light. */
const systemIsDark = matchMedia("(prefers-color-scheme: dark)");
let printing = false;

const isDark = () => !printing && (settings.theme === "dark" || (settings.theme === "system" && systemIsDark.matches));

function applyTheme() {
  document.documentElement.dataset.theme = isDark() ? "dark" : "light";
}

function startTheme() {
  onSettings(applyTheme);
  systemIsDark.addEventListener("change", settingsChanged);
  const print = (state) => () => { printing = state; settingsChanged(); if (printing) drawAllPanels(); };
  addEventListener("beforeprint", print(true));
  addEventListener("afterprint", print(false));
}

/** A link of the contents moves to its section; the address keeps the choices. */
function startContents() {
  for (const link of document.querySelectorAll('a[href^="#"]')) link.addEventListener("click", (event) => {
    event.preventDefault();
    const section = document.querySelector(link.getAttribute("href"));
    section.scrollIntoView();
    const heading = section.querySelector("h2, h3");
    heading.tabIndex = -1;
    heading.focus({preventScroll: true});
  });
}

fillList("description", data.description);
fillList("provenance-list", data.provenance);
fillTrust();
fillWarnings();
chooseCycleOf(readFragment());
startTheme();
startSettings();
onSettings(sayAngles);
onSettings(showAnswer);
startCycleChoice();
panel("profiles-over-time", drawProfilesOverTime);
cyclePanel("liner-table", fillLiner);
panel("height-chart", drawHeight);
panel("worn-chart", drawWornShare);
panel("roughness-chart", drawRoughness);
panel("life-chart", drawRemainingLife);
panel("steel-chart", drawSteel);
cyclePanel("bins-drawing", drawBins);
panel("worn-drawing", drawOriginalAndWorn);
panel("history-table", fillHistory);
startCharge();
startMotion();
startLoad();
panel("power-chart", drawPower);
cyclePanel("power-series-chart", drawPowerSeries);
panel("balance-chart", drawBalance);
startImpacts();
startGauge();
panel("conservation-table", fillConservation);
startContents();
drawSoon();

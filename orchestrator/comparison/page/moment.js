/** The moment that the page shows, as a share of each campaign's life [%]. */
const moment = {share: 0, shown: []};

/** The cycles of the campaign whose liner is on the page, as `data.charges` has them. */
const shownCycles = () => data.charges.filter((charge) =>
  data.profiles.some((profile) => Math.abs(profile.operating_hours - charge.operating_hours) < 1e-6));

/** The shown cycle nearest to the chosen share of the campaign's life; null where none is published. */
function chosenCharge() {
  const hours = moment.share / 100 * data.life.hours;
  const distance = (charge) => Math.abs(charge.operating_hours - hours);
  return shownCycles().reduce((best, charge) => best && distance(best) <= distance(charge) ? best : charge, null);
}

function chooseMoment(share) {
  const wanted = Math.max(0, Math.min(Math.round(share), 100));
  if (wanted === moment.share) return;
  moment.share = wanted;
  for (const show of moment.shown) show();
  moveToChosenCycle();
}

function readMoment(given) {
  const share = Number(given.get("moment"));
  chooseMoment(known(share) ? share : 0);
}

function keepMoment(kept) {
  if (moment.share) kept.set("moment", moment.share);
}

const momentText = (charge) => charge ? `cycle ${charge.cycle}, ${hoursText(charge.operating_hours)}` : "no cycle yet";

/** The slider from new to worn. */
function startMoment() {
  const [previous, slider, next] = ["previous", "slider", "next"].map((part) => document.getElementById(`cycle-${part}`));
  document.getElementById("cycle-choice").addEventListener("submit", (event) => event.preventDefault());
  slider.addEventListener("input", () => chooseMoment(Number(slider.value)));
  slider.addEventListener("change", writeFragment);
  for (const [button, step] of [[previous, -5], [next, 5]])
    button.addEventListener("click", () => { chooseMoment(moment.share + step); writeFragment(); });
  const show = () => {
    slider.value = moment.share;
    slider.setAttribute("aria-valuetext", `${moment.share} % of the life`);
    document.getElementById("cycle-words").textContent = `${moment.share} % of the life`;
    document.getElementById("moments").replaceChildren(...ofEach((one) => namedColour(one, `: ${momentText(chosenCharge())}`)));
    previous.disabled = moment.share === 0;
    next.disabled = moment.share === 100;
  };
  moment.shown.push(show);
  onSettings(show);
}

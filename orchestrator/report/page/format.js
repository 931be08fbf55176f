"use strict";

/** The campaign that is shown. */
let data = JSON.parse(document.getElementById("data").textContent);

/** What act() gives while `data` is this campaign's: a page of several draws one after the other. */
function inCampaign(campaign, act) {
  const before = data;
  data = campaign;
  try { return act(); } finally { data = before; }
}

const known = (value) => value !== null && value !== undefined && isFinite(value);
const grouped = d3.format(",.0f");
const fixed = (digits) => (value) => {
  if (!known(value)) return "–";
  const text = d3.format(",." + digits + "f")(value);
  return text.replace("-", /[1-9]/.test(text) ? "−" : "");
};
const significant = (digits) => (value) => {
  if (!known(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size < 1e-3 || size >= 1e7) return value.toExponential(digits - 1).replace(/-/g, "−");
  return fixed(Math.max(0, digits - 1 - Math.floor(Math.log(size) / Math.LN10)))(value);
};
const hoursText = (hours) => grouped(hours) + " h";
const inMillimetres = (metres) => known(metres) ? 1e3 * metres : null;
const inDegrees = (radians) => known(radians) ? radians * 180 / Math.PI : null;
const inPercent = (share) => known(share) ? 1e2 * share : null;

/** Mass with the unit that keeps it short: [value, unit]. */
function massText(tonnes) {
  if (tonnes >= 1e6) return [significant(3)(tonnes / 1e6), "Mt"];
  if (tonnes >= 1e4) return [significant(3)(tonnes / 1e3), "kt"];
  return [grouped(tonnes), "t"];
}

/** The prefixed unit in which the largest of `values` has one to three digits before the point. */
function prefixed(values, unit) {
  const largest = d3.max(values.filter(known), Math.abs) || 1;
  const steps = [[1e9, "G"], [1e6, "M"], [1e3, "k"], [1, ""], [1e-3, "m"], [1e-6, "µ"], [1e-9, "n"]];
  const [factor, prefix] = steps.find(([size]) => largest >= size) || steps[steps.length - 1];
  return {factor, unit: prefix + unit};
}

function element(name, attributes, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes || {})) made.setAttribute(key, value);
  made.append(...children.map((child) => child instanceof Node ? child : String(child)));
  return made;
}

/** A number with the prefix that keeps it short: 1e-4 J is 100 µJ. */
function withPrefix(value, unit) {
  const scale = prefixed([value], unit);
  return Number((value / scale.factor).toPrecision(3)) + " " + scale.unit;
}

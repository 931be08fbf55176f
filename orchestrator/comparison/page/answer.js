const errorText = (error, factor) => known(error) ? ` ± ${significant(2)(factor * error)}` : "";
const plusMinus = (campaign, name, text, factor = 1) => text(campaign[name]) + errorText(campaign[name + "_se"], factor);

/** {name, unit, of(campaign)} of every line of the table, with `data` being the campaign's. */
function answerLines() {
  const power = prefixed(campaigns.map((one) => one.power_w_per_m), "W");
  const hits = prefixed(campaigns.map((one) => one.bare_hit_power_w_per_m), "W");
  const per = ({factor}) => (value) => fixed(2)(known(value) ? value / factor : null);
  const angle = (degrees) => fixed(1)(known(degrees) ? inClockDegrees(degrees * Math.PI / 180) : null);
  const length = (metres) => lengthFigure(metres, 1);
  return [
    {name: "Life", unit: "h", of: (one) => (one.worn_out ? "" : "over ") + grouped(one.life_hours)},
    {name: "95 % band of the life", unit: "h", of: (one) => known(one.life_hours_low)
      ? `${grouped(one.life_hours_low)} to ${grouped(one.life_hours_high)}` : "–"},
    {name: "Limit", unit: "", of: limitWords},
    {name: "Milled", unit: "t", of: (one) => known(one.tonnes) ? grouped(one.tonnes) : "–"},
    {name: "DEM cycles", unit: "", of: (one) => one.cycles},
    {name: "New lifter", unit: lengthUnit(), of: (one) => length(one.new_height_m)},
    {name: "Lifter at the end", unit: lengthUnit(), of: (one) => length(one.height_m)},
    {name: "Thinnest plate at the end", unit: lengthUnit(), of: (one) => length(one.plate_thickness_m)},
    {name: "Steel worn", unit: "kg/m", of: (one) => plusMinus(one, "worn_steel_kg_per_m", significant(4))},
    {name: "Power", unit: power.unit + "/m", of: (one) => plusMinus(one, "power_w_per_m", per(power), 1 / power.factor)},
    {name: "Hits on the bare liner", unit: hits.unit + "/m",
      of: (one) => plusMinus(one, "bare_hit_power_w_per_m", per(hits), 1 / hits.factor)},
    {name: "Shoulder", unit: "°", of: (one) => plusMinus(one, "shoulder_deg", angle)},
    {name: "Toe", unit: "°", of: (one) => plusMinus(one, "toe_deg", angle)},
  ];
}

/** The campaign's name, a link where its report lies below the page. */
const campaignHead = (campaign) => campaign.report
  ? element("a", {href: campaign.report.split("/").map(encodeURIComponent).join("/")}, campaign.name) : campaign.name;

/** A column a campaign; text(line, campaign, its number). */
const columnOfEach = (text) => campaigns.map((one, i) => ({head: campaignHead(one),
  text: (line) => inCampaign(one.data, () => text(line, one, i))}));

function fillAnswers() {
  fillTable("answer-table", "The answers of the campaigns", answerLines(),
    [{head: "", text: (line) => line.name, unitOf: (line) => line.unit}].concat(columnOfEach((line, one) => line.of(one))));
}

function fillDiffering() {
  if (!data.differing.length) { nothing(document.getElementById("differing-table"), "The cases are the same."); return; }
  fillTable("differing-table", "Keys that differ between the cases", data.differing,
    [{head: "Key", text: ({key}) => key.replace(/`/g, "")}].concat(columnOfEach(({values}, one, i) => values[i])));
}

function sayMissing() {
  document.getElementById("missing").append(...campaigns.flatMap((one) => one.missing.map((words) =>
    element("li", {}, `${one.name}: ${words}.`))));
}

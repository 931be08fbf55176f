/** The campaigns side by side: {name, report, missing, data, and the figures by their names}, data as the campaign's own
 *  report has it. */
const campaigns = data.campaigns;
const coloursOnLight = ["#16365c", "#c2501f", "#2c8a93", "#b07c14", "#6a4c93", "#6f7d1f", "#c2185b", "#5c6670"];
const coloursOnDark = ["#8db8e8", "#f08a5d", "#4fc3cb", "#e5b550", "#b79ce0", "#b8c95a", "#f06a9b", "#a3adb6"];
const colourOf = (campaign) => (isDark() ? coloursOnDark : coloursOnLight)[campaigns.indexOf(campaign)];

/** What of(campaign) gives for each, with `data` being the campaign's. */
const ofEach = (of) => campaigns.map((one) => inCampaign(one.data, () => of(one)));

/** The same, for the series of a chart: their name and colour are the campaign's. */
const seriesOfEach = (of) => ofEach((one) => ({name: one.name, label: one.name, colour: colourOf(one), ...of(one)}));

/** A campaign's name behind its colour. */
const namedColour = (campaign, ...words) =>
  element("span", {}, element("i", {class: "block", style: `background:${colourOf(campaign)}`}), campaign.name, ...words);

const worst = (rows, value) => rows.filter((row) => known(value(row))).sort((a, b) => value(b) - value(a))[0];

/** The largest share of the new lifter that one load wore. */
function largestStep() {
  const ends = data.conservation.map(({cycle}) => data.history.filter((row) => row.cycle === cycle).pop());
  const steps = ends.map((row, i) => row.worn_fraction - (i ? ends[i - 1].worn_fraction : 0));
  return d3.max(steps);
}

const notConserved = (row) => row.accounted ? Math.abs(row.removed - row.accounted) / row.accounted : null;

function noiseWords() {
  const peak = worst(data.conservation, (row) => row.peak_error);
  const {life} = data;
  const band = life.reached && known(life.hours_low) && life.hours > 0
    ? ` The life's 95 % band is ${fixed(1)(inPercent(life.hours_low / life.hours - 1))} to +${fixed(1)(inPercent(life.hours_high / life.hours - 1))} %.` : "";
  return (peak ? `A load knows the rate of wear at its peaks to ± ${significant(2)(inPercent(peak.peak_error))} % at worst (cycle ${peak.cycle}).`
    : "The error of the loads is not known.") + band;
}

function chatterWords() {
  const most = worst(data.conservation, (row) => row.path_over_slip);
  if (!most) return "Not recorded.";
  return `Path over slip is ${fixed(2)(most.path_over_slip)} at most (cycle ${most.cycle}). ` + (most.path_over_slip > 1.5
    ? "Above 1.5 jammed particles chatter: repeat a load with half the rayleigh_fraction." : "Near 1 no contact chatters.");
}

function truncationWords() {
  const unbalanced = worst(data.conservation, notConserved);
  return `One load wears ${fixed(1)(inPercent(largestStep()))} % of the new lifter at most; halve it to see the error of the steps.` +
    (unbalanced ? ` The steel removed is that of the loads to ${significant(1)(inPercent(notConserved(unbalanced)))} %.` : "");
}

function lawWords() {
  const line = data.description.find(([name]) => name === "Wear law");
  return (line ? line[1] + ". " : "") + (data.calibrated ? "Its coefficient is calibrated on gauge readings."
    : "The life is inversely proportional to its coefficient, which is not calibrated on gauge readings here.");
}

function fillTrust() {
  if (!data.conservation.length) { document.getElementById("trust-list").remove(); return; }
  fillList("trust-list", [["Noise of the loads", noiseWords()], ["Chatter of contacts", chatterWords()],
    ["Steps in time", truncationWords()], ["Wear law", lawWords()]]);
}

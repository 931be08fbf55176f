const pictureNames = {section: "The section, coloured by speed", section_by_size: "The section, coloured by size",
  close_up: "Between the lifters where the charge rises", slice: "The slice, with the liner cut open",
  streaks: "Paths of the particles"};

const shadesOfMaterials = ["blue", "brown", "green", "violet"];

/** What a picture's colours mean, and of the close-up how much of the packing it shows was measured. */
function pictureWords(name, cycle) {
  if (name === "section_by_size") {
    const materials = d3.set(data.charge.classes.map((one) => one.material)).values();
    return materials.map((material, i) => `${material}: ${shadesOfMaterials[i % shadesOfMaterials.length]}`).join(", ") +
      "; the smaller the brighter.";
  }
  const colours = `Dark is at rest, yellow ${significant(2)(data.charge.fastest)} m/s and more.`;
  const motion = data.motion.find((one) => one.cycle === cycle);
  if (name !== "close_up" || !motion || !known(motion.packed_share.value)) return colours;
  const share = (one) => `${fixed(1)(inPercent(one.value))} %` + (known(one.error) ? ` ± ${significant(2)(inPercent(one.error))} %` : "");
  return `${colours} Packed between the lifters and moving with the mill: ${share(motion.packed_share)} of the ascending charge, ` +
    `${share(motion.between_locked_share)} of what ascends between them.`;
}

/** The pictures of a cycle's charge that there are. */
const pictureFigures = (charge) => Object.entries(pictureNames).filter(([name]) => charge && charge.pictures && charge.pictures[name])
  .map(([name, title]) => element("figure", {}, element("h3", {}, title),
    element("img", {src: charge.pictures[name], alt: `${title}, cycle ${charge.cycle}`}),
    element("figcaption", {}, pictureWords(name, charge.cycle))));

const pictureNames = {section: "The section, coloured by speed", section_by_size: "The section, coloured by size",
  close_up: "Between the lifters where the charge rises", slice: "The slice, with the liner cut open",
  streaks: "Paths of the particles"};

/** The pictures of a cycle's charge that there are. */
const pictureFigures = (charge) => Object.entries(pictureNames).filter(([name]) => charge && charge.pictures && charge.pictures[name])
  .map(([name, title]) => element("figure", {}, element("h3", {}, title),
    element("img", {src: charge.pictures[name], alt: `${title}, cycle ${charge.cycle}`})));

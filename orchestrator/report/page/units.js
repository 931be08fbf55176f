const isInch = () => settings.units === "inch";
const lengthUnit = () => isInch() ? "in" : "mm";
const areaUnit = () => isInch() ? "in²" : "cm²";
const inLength = (metres) => known(metres) ? metres * (isInch() ? 1 / 0.0254 : 1e3) : null;
const inArea = (squareMetres) => known(squareMetres) ? squareMetres * (isInch() ? 1 / 0.0254 ** 2 : 1e4) : null;
/** A length without its unit; `digits` are those of millimetres. */
const lengthFigure = (metres, digits) => fixed(digits + (isInch() ? 2 : 0))(inLength(metres));
const lengthText = (metres, digits) => `${lengthFigure(metres, digits)} ${lengthUnit()}`;
/** A place in the mill, in metres or feet. */
const placeText = (metres) => isInch() ? `${fixed(2)(metres / 0.3048)} ft` : `${fixed(3)(metres)} m`;

/** Degrees that the chosen angle convention starts behind three o'clock on the rising side. */
const angleOrigin = () => settings.angles === "twelve" ? 90 : 0;
const wholeTurn = (degrees) => degrees - 360 * Math.floor(degrees / 360);
/** An angle from three o'clock on the rising side [rad], in degrees of the chosen convention, 0 to 360. */
const inClockDegrees = (radians) => known(radians) ? wholeTurn(inDegrees(radians) - angleOrigin()) : null;

const angleWords = () => settings.angles === "twelve"
  ? "Angles from twelve o'clock, along the rotation; six o'clock is 180°."
  : "Angles from three o'clock on the rising side, along the rotation; six o'clock is 270°.";

function sayAngles() {
  for (const place of document.querySelectorAll(".angle-words")) place.textContent = angleWords();
}

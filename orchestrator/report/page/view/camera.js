/** Focal length over half the height of the picture. */
const focalLength = 4;

/** A camera in shell radii about the middle of a mill, which looks along the axis; `halfSlice` is half of the longest
 *  slice that it shows. */
const cameraFor = (halfSlice) => lookAlongAxis({halfSlice});

/** Looks along the axis at the whole mill, as the section is drawn: x to the right, z up. */
const lookAlongAxis = (camera) =>
  Object.assign(camera, {yaw: 0, tilt: 0, distance: 1.06 * focalLength + camera.halfSlice, target: [0, 0, 0]});

/** Directions to the right, up and back to the eye, in the mill's frame. */
function cameraAxes({yaw, tilt}) {
  const [cy, sy, ct, st] = [Math.cos(yaw), Math.sin(yaw), Math.cos(tilt), Math.sin(tilt)];
  return [[cy, sy, 0], [-sy * st, cy * st, ct], [sy * ct, -cy * ct, st]];
}

/** Moves the camera and its target by parts of half the picture's height at the target's depth. */
function moveCamera(camera, right, up) {
  const [toRight, upwards] = cameraAxes(camera);
  const length = camera.distance / focalLength;
  camera.target = camera.target.map((value, i) => value + length * (right * toRight[i] + up * upwards[i]));
}

function turnCamera(camera, yaw, tilt) {
  camera.yaw += yaw;
  camera.tilt = Math.max(-1.5, Math.min(camera.tilt + tilt, 1.5));
}

/** Brings the target nearer by `factor`; the point at (right, up) of half the picture stays where it is. */
function zoomCamera(camera, factor, right, up) {
  const distance = Math.max(0.15, Math.min(camera.distance / factor, 12));
  moveCamera(camera, right * (1 - distance / camera.distance), up * (1 - distance / camera.distance));
  camera.distance = distance;
}

/** What the shaders need: eye [m], the turn into the camera's frame by columns, the lens of their `seen`. */
function cameraUniforms(camera, aspect) {
  const axes = cameraAxes(camera);
  const {sector: {shell_radius: radius}, charge: {slice_length: slice}} = data;
  const fromMiddle = camera.target.map((value, i) => radius * (value + camera.distance * axes[2][i]));
  const eye = [fromMiddle[0], fromMiddle[1] + slice / 2, fromMiddle[2]];
  const reach = 1.1 * Math.hypot(radius, slice);
  const toMiddle = d3.sum(axes[2], (value, i) => value * fromMiddle[i]);
  const near = Math.max(0.02 * radius, toMiddle - reach);
  const far = Math.max(2 * near, toMiddle + reach);
  return {eye, turn: d3.transpose(axes).flat(),
    lens: [focalLength / aspect, focalLength, (far + near) / (near - far), 2 * far * near / (near - far)]};
}

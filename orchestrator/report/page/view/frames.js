/** Where the particles are at first: x, y, z of one after the other [m]. */
function placeFirstFrame(frames, places) {
  const bytes = bytesOf(frames.first);
  [frames.across, frames.along, frames.across].forEach(([low, high], axis) => {
    const unit = (high - low) / 65535;
    for (let i = 0; i < frames.particles; i++) {
      const at = 2 * (axis * frames.particles + i);
      places[3 * i + axis] = low + unit * (bytes[at] | bytes[at + 1] << 8);
    }
  });
}

function placeLaterFrames(frames, places) {
  const row = 3 * frames.particles;
  // They are kept as what they change by from frame to frame, modulo 256.
  const moves = Int8Array.from(bytesOf(frames.changes));
  for (let i = row; i < moves.length; i++) moves[i] += moves[i - row];
  for (let frame = 1; frame < frames.times.length; frame++)
    for (let axis = 0; axis < 3; axis++)
      for (let i = 0; i < frames.particles; i++) {
        const to = frame * row + 3 * i + axis;
        places[to] = places[to - row] + frames.step * moves[(frame - 1) * row + axis * frames.particles + i];
      }
}

/**
 * The frames of a cycle: particles, times from the first [s], millAngles [rad], by particle the classes and the
 * radii [m], places [m]: of frame after frame, of particle after particle, x, y and z; low end of the slice [m].
 */
function decodedFrames(frames) {
  const places = new Float32Array(frames.times.length * frames.particles * 3);
  placeFirstFrame(frames, places);
  placeLaterFrames(frames, places);
  const classes = bytesOf(frames.classes);
  return {particles: frames.particles, times: frames.times.map((time) => time - frames.times[0]),
    millAngles: frames.mill_angles, classes, places, low: frames.along[0],
    radii: Float32Array.from(classes, (one) => data.charge.classes[one].diameter / 2)};
}

/** The interval between two frames that `time` lies in, and the share of it that has passed. */
function intervalAt(frames, time) {
  const interval = Math.max(0, Math.min(d3.bisectRight(frames.times, time) - 1, frames.times.length - 2));
  const [start, end] = [frames.times[interval], frames.times[interval + 1]];
  return {interval, duration: end - start, share: Math.max(0, Math.min((time - start) / (end - start), 1))};
}

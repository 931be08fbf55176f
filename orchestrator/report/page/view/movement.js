/** A particle moves with the mill where its velocity differs from the wall's rotation by less than this share of it. */
const slipOfWall = 0.2;

/** A difference along the axis [m] by the shorter way: what leaves the slice at one end comes back at the other. */
const shorterWay = (along) => along - data.charge.slice_length * Math.round(along / data.charge.slice_length);

/** Calls visit(particle, speed [m/s], whether it moves with the mill) for every particle between all frames. */
function eachMovement(frames, visit) {
  const {places, particles, times} = frames;
  const turning = data.charge.speed;
  for (let frame = 1; frame < times.length; frame++) {
    const duration = times[frame] - times[frame - 1];
    for (let i = 0; i < particles; i++) {
      const to = 3 * (frame * particles + i);
      const from = to - 3 * particles;
      const vx = (places[to] - places[from]) / duration;
      const vy = shorterWay(places[to + 1] - places[from + 1]) / duration;
      const vz = (places[to + 2] - places[from + 2]) / duration;
      const x = (places[to] + places[from]) / 2;
      const z = (places[to + 2] + places[from + 2]) / 2;
      const slip = Math.hypot(vx - turning * z, vy, vz + turning * x);
      visit(i, Math.hypot(vx, vy, vz), slip < slipOfWall * turning * Math.hypot(x, z));
    }
  }
}

/** The speed [m/s] that 99 of 100 particles stay under. */
function fastSpeed(frames) {
  const speeds = new Float32Array(frames.particles * (frames.times.length - 1));
  let next = 0;
  eachMovement(frames, (particle, speed) => { speeds[next++] = speed; });
  return speeds.sort()[Math.floor(0.99 * speeds.length)];
}

/** By material the share of its mass that moves with the mill, the mean over the frames: [material, share]. */
function sharesWithMill(frames) {
  const sums = new Map();
  eachMovement(frames, (particle, speed, withMill) => {
    const {material} = data.charge.classes[frames.classes[particle]];
    const sum = sums.get(material) || sums.set(material, [0, 0]).get(material);
    const volume = Math.pow(frames.radii[particle], 3);
    sum[0] += volume;
    if (withMill) sum[1] += volume;
  });
  return [...sums].map(([material, [all, moving]]) => [material, moving / all]);
}

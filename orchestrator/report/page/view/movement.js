/** A particle moves with the mill where its velocity differs from the mill's rotation, `turning` [rad/s], by less than
 *  this [m/s]. */
const slipWithMill = (turning) => data.charge.locked_slip * turning * data.sector.plate_radius;

/** Calls visit(particle, speed [m/s], whether it moves with the mill) for every particle between all frames. */
function eachMovement({places, particles, times}, turning, visit) {
  const slice = data.charge.slice_length;
  const most = slipWithMill(turning);
  for (let frame = 1; frame < times.length; frame++) {
    const duration = times[frame] - times[frame - 1];
    for (let i = 0; i < particles; i++) {
      const to = 3 * (frame * particles + i);
      const from = to - 3 * particles;
      // What leaves the slice at one end comes back at the other: along the axis it went the shorter way.
      const along = places[to + 1] - places[from + 1];
      const vx = (places[to] - places[from]) / duration;
      const vy = (along - slice * Math.round(along / slice)) / duration;
      const vz = (places[to + 2] - places[from + 2]) / duration;
      const wallX = turning * (places[to + 2] + places[from + 2]) / 2;
      const wallZ = -turning * (places[to] + places[from]) / 2;
      const slip = (vx - wallX) * (vx - wallX) + vy * vy + (vz - wallZ) * (vz - wallZ);
      visit(i, Math.sqrt(vx * vx + vy * vy + vz * vz), slip < most * most);
    }
  }
}

/**
 * Of all frames: fast, the speed [m/s] that 99 of 100 particles stay under; withMill, by material the share of its
 * mass that moves with the mill, [material, share].
 */
function movementOf(frames, turning) {
  const speeds = new Float32Array(frames.particles * (frames.times.length - 1));
  const sums = data.charge.classes.map(() => ({all: 0, moving: 0}));
  let next = 0;
  eachMovement(frames, turning, (particle, speed, withMill) => {
    speeds[next++] = speed;
    const sum = sums[frames.classes[particle]];
    sum.all++;
    if (withMill) sum.moving++;
  });
  const volume = (count) => d3.sum(data.charge.classes, (one, i) => count(one, sums[i]) * Math.pow(one.diameter, 3));
  const materials = d3.set(data.charge.classes.filter((one, i) => sums[i].all).map((one) => one.material)).values();
  const withMill = materials.map((material) => [material, volume((one, sum) => one.material === material ? sum.moving : 0) /
    volume((one, sum) => one.material === material ? sum.all : 0)]);
  return {fast: speeds.sort()[Math.floor(0.99 * speeds.length)], withMill};
}

/** Twice the area of a triangle in the section, above 0 where a, b, c go around anticlockwise. */
const turnOf = (a, b, c) => (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);

/** Triangles of a polygon that goes around anticlockwise and does not cross itself, by cutting off ears. */
function trianglesOf(polygon) {
  const left = polygon.slice();
  const triangles = [];
  const isEar = (a, b, c) => turnOf(a, b, c) > 0 && !left.some((p) => p !== a && p !== b && p !== c &&
    turnOf(a, b, p) >= 0 && turnOf(b, c, p) >= 0 && turnOf(c, a, p) >= 0);
  const cornerAt = (i) => [left.length - 1, 0, 1].map((step) => left[(i + step) % left.length]);
  while (left.length > 2) {
    const ear = left.findIndex((p, i) => isEar(...cornerAt(i)));
    // Without an ear three corners lie on one line: nothing is lost where the middle one goes.
    const cut = ear >= 0 ? ear : left.findIndex((p, i) => turnOf(...cornerAt(i)) <= 0);
    if (ear >= 0) triangles.push(cornerAt(ear));
    left.splice(Math.max(cut, 0), 1);
  }
  return triangles;
}

/** A place in the section turned by an angle the way that the mill turns. */
const turnedAlong = ([x, z], angle) =>
  [x * Math.cos(angle) + z * Math.sin(angle), z * Math.cos(angle) - x * Math.sin(angle)];

/** The shell of a sector, from the last node to the first, in the section. */
function shellBehind(nodes) {
  const angles = [nodes[nodes.length - 1], nodes[0]].map(([x, z]) => Math.atan2(-x, -z));
  return d3.range(0, 13).map((i) => angles[0] + (angles[1] - angles[0]) * i / 12)
    .map((angle) => [-data.sector.shell_radius * Math.sin(angle), -data.sector.shell_radius * Math.cos(angle)]);
}

/** The strip between two lines of the section, one of them at each end of the slice. */
function addStrip(add, line, ends) {
  for (let i = 1; i < line.length; i++) {
    const [[ax, az], [bx, bz]] = [line[i - 1], line[i]];
    const length = Math.hypot(bx - ax, bz - az) || 1;
    const corners = [[ax, ends[0], az], [ax, ends[1], az], [bx, ends[1], bz], [bx, ends[0], bz]];
    for (const corner of [0, 1, 2, 0, 2, 3]) add(corners[corner], [(bz - az) / length, 0, (ax - bx) / length]);
  }
}

/**
 * The steel of the lifter at six o'clock and its share of the plate: the worn surface of `outline` (xi, eta) [m],
 * the shell, and the faces where the slice ends. A vertex is six numbers, place [m] and normal in the mill's frame.
 * Triangles go around anticlockwise where they are seen from outside of the steel.
 */
function sectorMesh(outline) {
  const nodes = outline.map(([xi, eta]) => [-xi, eta - data.sector.plate_radius]);
  // Sectors overlap by a hair, so that nothing shines through between two of them.
  for (const [end, angle] of [[0, -1e-4], [nodes.length - 1, 1e-4]]) nodes[end] = turnedAlong(nodes[end], angle);
  const shell = shellBehind(nodes);
  const ends = [0, data.charge.slice_length];
  const vertices = [];
  const add = (place, normal) => vertices.push(...place, ...normal);
  // The nodes run to the left over the steel and the shell runs back under it: anticlockwise.
  for (const line of [nodes, shell]) addStrip(add, line, ends);
  for (const [a, b, c] of trianglesOf([...nodes, ...shell])) {
    for (const [x, z] of [a, b, c]) add([x, ends[0], z], [0, -1, 0]);
    for (const [x, z] of [a, c, b]) add([x, ends[1], z], [0, 1, 0]);
  }
  return new Float32Array(vertices);
}

// The triangle of a query as engines take it, and a second one beside it in the same mesh.

export const vertices = (q) => [q.subarray(0, 3), q.subarray(3, 6), q.subarray(6, 9)];
export const centre = (q) => q.subarray(9, 12);
export const radius = (q) => q[q.length - 1];
export const motion = (q) => q.subarray(12, 15);  // of moving-sphere
// Where the centre ends, rounded: some engines take this and not the displacement. Null where float has no such place.
export function end(q) {
  const p = centre(q), to = Float32Array.from(motion(q), (d, k) => p[k] + d);
  return to.every(Number.isFinite) ? to : null;
}
// A vector of length 1 in the direction of v, or against it where `sign` is -1; NaN where v has none.
export function unit(v, sign = 1) {
  const length = sign * Math.hypot(...v);
  return v.map((x) => x / length);
}

// What a library says that gives the triangle's point next to the centre, in double: the direction from there to the centre, and the
// distance, which is that of the point where it has none of its own.
export function ofNearest(q, point, distance) {
  const away = [...centre(q)].map((x, k) => x - point[k]), from = distance ?? Math.hypot(...away);
  return {separation: from - radius(q), normal: unit(away), point};
}

// A triangle that the sphere does not touch, of the first one's size and at least 1 (a metre, to most engines), beyond
// the triangle and the sphere in the direction of x; null where float has no room for it. Engines drop a triangle with
// too little area from a mesh, and refuse a mesh that has no other: with this one it is not refused.
export function beside(q) {
  const [a, b, c] = vertices(q), p = centre(q);
  let size = 1, low = [Infinity, Infinity, Infinity];
  for (let k = 0; k < 3; ++k) {
    const high = Math.max(a[k], b[k], c[k]);
    low[k] = Math.min(a[k], b[k], c[k]);
    size = Math.max(size, high - low[k]);
  }
  const x = Math.max(a[0], b[0], c[0], p[0] + radius(q));
  // A thousandth of a coordinate, so that no rounding brings it to the sphere.
  size = Math.max(size, Math.abs(x) / 1024, Math.abs(low[1]) / 1024, Math.abs(low[2]) / 1024);
  const start = [x + size, low[1], low[2]];
  const second = [start, [start[0] + size, start[1], start[2]], [start[0], start[1] + size, start[2]]];
  return second.flat().every((v) => Number.isFinite(Math.fround(v))) ? second : null;
}

// Vertices and indices of the mesh of the query's triangle, with a second one where `two`; null where that has no room.
export function mesh(q, two) {
  const triangles = [vertices(q)];
  if (two) {
    const second = beside(q);
    if (second === null) return null;
    triangles.push(second);
  }
  const positions = new Float32Array(9 * triangles.length);
  triangles.flat().forEach((v, i) => positions.set(v, 3 * i));
  return {triangles, positions, indices: Uint32Array.from({length: 3 * triangles.length}, (_, i) => i)};
}

// The form that the program was started with, one of the names of `forms`.
export function form(forms) {
  const given = process.argv[2];
  if (process.argv.length === 3 && given in forms) return forms[given];
  console.error(`${process.argv[1]}: give one of ${Object.keys(forms).join(', ')}; not '${process.argv.slice(2).join(' ')}'`);
  process.exit(2);
}

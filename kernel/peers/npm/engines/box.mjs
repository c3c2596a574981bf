// The boxes of a query as engines take them.
import {UNDECIDED} from './frame.mjs';

// A box of the entry matrix: centre, half extents and axes, from column `k` on; or null. Engines take a rotation, and the
// axes need not be one: those within 2^-10 of orthonormal are given as they stand, the third with its sign changed where
// they are left-handed, which is the same box. Peers in C++ do the same (../../boxes/box_pair.h).
export function placed(q, k = 0) {
  const at = (i) => [q[k + i], q[k + i + 1], q[k + i + 2]];
  const box = {m: at(0), s: at(3), axes: [at(6), at(9), at(12)]}, [x, y, z] = box.axes;
  const dot = (u, v) => u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
  for (let i = 0; i < 3; ++i) {
    for (let j = 0; j <= i; ++j) {
      if (!(Math.abs(dot(box.axes[i], box.axes[j]) - (i === j ? 1 : 0)) <= 2 ** -10)) return null;
    }
  }
  const cross = [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]];
  if (dot(cross, z) < 0) box.axes[2] = z.map((v) => -v);
  return box;
}

// A box of the entry quaternion. Engines take one of length 1: it is made so in double, and rounded by an engine of floats.
export function turned(q, k = 0) {
  const length = Math.hypot(...q.subarray(k + 6, k + 10));
  const [w, x, y, z] = [...q.subarray(k + 6, k + 10)].map((v) => v / length);
  return {m: [...q.subarray(k, k + 3)], s: [...q.subarray(k + 3, k + 6)], turn: {x, y, z, w}};
}

// A point of a box that stands at `m` and may be turned, from its own frame; in double.
export function placedAt(v, m, {x, y, z, w} = {x: 0, y: 0, z: 0, w: 1}) {
  const cross = (s, t) => [s[1] * t[2] - s[2] * t[1], s[2] * t[0] - s[0] * t[2], s[0] * t[1] - s[1] * t[0]];
  const once = cross([x, y, z], v), twice = cross([x, y, z], once);
  return v.map((c, k) => m[k] + c + 2 * (w * once[k] + twice[k]));
}

// The answers of `ask` about both boxes of a query, each as `read` makes it; undecided where one is none to engines.
const answers = (read, columns, ask) => (q) => {
  const a = read(q), b = read(q, columns);
  return a && b ? ask(a, b) : UNDECIDED;
};
export const matrices = (ask) => ({'box-box/matrix': answers(placed, 15, ask)});
export const quaternions = (ask) => ({'box-box/quaternion': answers(turned, 10, ask)});

// The triangle of a query of box-triangle, its numbers from column `k` on.
export const corners = (q, k) => [q.subarray(k, k + 3), q.subarray(k + 3, k + 6), q.subarray(k + 6, k + 9)];
// The same as mesh() of triangle.mjs makes one.
export function single(q, k) {
  return {triangles: [corners(q, k)], positions: Float32Array.from(q.subarray(k, k + 9)), indices: Uint32Array.of(0, 1, 2)};
}

// The published sixteen comparisons, strict, in the order of operations of kernel/sphere_triangle/formulae.h, as a
// reader would write them. Nothing keeps a compiler from another order.
fn vertex(at: vec3f, square: f32, one: f32, other: f32, rr: f32) -> bool {
  return square > rr && one > square && other > square;
}

fn edge(from_: vec3f, to: vec3f, opposite: vec3f, d: f32, rr: f32) -> bool {
  let along = to - from_;
  let e = dot(along, along);
  let Q = from_ * e - along * d;
  return dot(Q, Q) > rr * e * e && dot(Q, opposite * e - Q) > 0.0;
}

fn separated(a: vec3f, b: vec3f, c: vec3f, p: vec3f, r: f32) -> u32 {
  let A = a - p;
  let B = b - p;
  let C = c - p;
  let rr = r * r;
  let V = cross(B - A, C - A);
  let d = dot(A, V);
  let aa = dot(A, A);
  let ab = dot(A, B);
  let ac = dot(A, C);
  let bb = dot(B, B);
  let bc = dot(B, C);
  let cc = dot(C, C);
  return u32(d * d > rr * dot(V, V) || vertex(A, aa, ab, ac, rr) || vertex(B, bb, ab, bc, rr) || vertex(C, cc, ac, bc, rr) ||
             edge(A, B, C, ab - aa, rr) || edge(B, C, A, bc - bb, rr) || edge(C, A, B, ac - cc, rr));
}

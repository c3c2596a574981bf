// The reduced comparisons with >= in the sides, right for every triangle over the reals: kernel/sphere_triangle/
// forms/reduced.h.
fn vertex(square: f32, one: f32, other: f32, rr: f32) -> bool {
  return square > rr && one >= square && other >= square;
}

fn edge(N: vec3f, V: vec3f, along: vec3f, rr: f32) -> bool {
  return dot(N, N) > rr * dot(along, along) && 0.0 >= dot(N, V);
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
  return u32(d * d > rr * dot(V, V) || vertex(aa, ab, ac, rr) || vertex(bb, ab, bc, rr) || vertex(cc, ac, bc, rr) ||
             edge(cross(A, B), V, B - A, rr) || edge(cross(B, C), V, C - B, rr) || edge(cross(C, A), V, A - C, rr));
}

// The twenty axes of a moving sphere with >= in sides and headings, right for every query over the reals:
// kernel/moving_sphere/twenty.h, as a reader would write them.

// An axis of a vertex at `at`, and of an edge from `at`, of a sphere that stands still; `heading` is closing, and must
// not be positive.
fn vertex(square: f32, one: f32, other: f32, heading: f32, rr: f32) -> bool {
  return square > rr && one >= square && other >= square && 0.0 >= heading;
}
fn edge(at: vec3f, along: vec3f, across: vec3f, V: vec3f, sign: f32, rr: f32) -> bool {
  let N = cross(at, along);
  return dot(N, N) > rr * dot(along, along) && 0.0 >= dot(N, V) && 0.0 >= sign * dot(N, across);
}

// The seven axes with the centre at the origin. sign: 1 at the start of the motion, -1 at its end.
fn still(A: vec3f, B: vec3f, C: vec3f, D: vec3f, V: vec3f, sign: f32, rr: f32) -> bool {
  let AB = B - A;
  let BC = C - B;
  let CA = A - C;
  let offset = dot(A, V);
  let aa = dot(A, A);
  let ab = dot(A, B);
  let ac = dot(A, C);
  let bb = dot(B, B);
  let bc = dot(B, C);
  let cc = dot(C, C);
  return (offset * offset > rr * dot(V, V) && 0.0 >= sign * (offset * dot(D, V))) ||
    vertex(aa, ab, ac, sign * dot(A, D), rr) || vertex(bb, ab, bc, sign * dot(B, D), rr) ||
    vertex(cc, ac, bc, sign * dot(C, D), rr) ||
    edge(A, AB, cross(D, AB), V, sign, rr) || edge(B, BC, cross(D, BC), V, sign, rr) || edge(C, CA, cross(D, CA), V, sign, rr);
}

fn swept_vertex(square: f32, one: f32, other: f32, limit: f32) -> bool {
  return square > limit && one >= square && other >= square;
}
fn swept_edge(at: vec3f, along: vec3f, D: vec3f, m: f32, rr: f32) -> bool {
  let M = cross(D, along);
  let delta = dot(at, M);
  return delta * delta > rr * dot(M, M) && delta * m >= 0.0;
}

fn separated(a: vec3f, b: vec3f, c: vec3f, p: vec3f, D: vec3f, r: f32) -> u32 {
  let A = a - p;
  let B = b - p;
  let C = c - p;
  let rr = r * r;
  let V = cross(B - A, C - A);
  let m = dot(D, V);
  let WA = cross(A, D);
  let WB = cross(B, D);
  let WC = cross(C, D);
  let limit = rr * dot(D, D);
  let ab = dot(WA, WB);
  let ac = dot(WA, WC);
  let bc = dot(WB, WC);
  return u32(still(A, B, C, D, V, 1.0, rr) || still(A - D, B - D, C - D, D, V, -1.0, rr) ||
    swept_vertex(dot(WA, WA), ab, ac, limit) || swept_vertex(dot(WB, WB), ab, bc, limit) || swept_vertex(dot(WC, WC), ac, bc, limit) ||
    swept_edge(A, B - A, D, m, rr) || swept_edge(B, C - B, D, m, rr) || swept_edge(C, A - C, D, m, rr));
}

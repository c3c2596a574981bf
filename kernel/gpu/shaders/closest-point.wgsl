// The closest point of the triangle by its Voronoi regions, as kernel/sphere_triangle/forms/methods.h has it.
fn closest(A: vec3f, B: vec3f, C: vec3f) -> vec3f {
  let AB = B - A;
  let AC = C - A;
  let one_a = -dot(AB, A);
  let two_a = -dot(AC, A);
  if (!(one_a > 0.0) && !(two_a > 0.0)) { return A; }
  let one_b = -dot(AB, B);
  let two_b = -dot(AC, B);
  if (one_b >= 0.0 && one_b >= two_b) { return B; }
  let weight_c = one_a * two_b - one_b * two_a;
  if (0.0 >= weight_c && one_a >= 0.0 && 0.0 >= one_b) { return A + AB * (one_a / (one_a - one_b)); }
  let one_c = -dot(AB, C);
  let two_c = -dot(AC, C);
  if (two_c >= 0.0 && two_c >= one_c) { return C; }
  let weight_b = one_c * two_a - one_a * two_c;
  if (0.0 >= weight_b && two_a >= 0.0 && 0.0 >= two_c) { return A + AC * (two_a / (two_a - two_c)); }
  let weight_a = one_b * two_c - one_c * two_b;
  let past_b = two_b - one_b;
  let past_c = one_c - two_c;
  if (0.0 >= weight_a && past_b >= 0.0 && past_c >= 0.0) { return B + (C - B) * (past_b / (past_b + past_c)); }
  let all = (weight_a + weight_b) + weight_c;
  return (A + AB * (weight_b / all)) + AC * (weight_c / all);
}

fn separated(a: vec3f, b: vec3f, c: vec3f, p: vec3f, r: f32) -> u32 {
  let Q = closest(a - p, b - p, c - p);
  return u32(dot(Q, Q) > r * r);
}

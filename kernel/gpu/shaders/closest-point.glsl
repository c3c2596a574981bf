// The closest point of the triangle by its Voronoi regions, as kernel/sphere_triangle/forms/methods.h has it.
vec3 closest(vec3 A, vec3 B, vec3 C) {
  vec3 AB = B - A;
  vec3 AC = C - A;
  float one_a = -dot(AB, A);
  float two_a = -dot(AC, A);
  if (!(one_a > 0.0) && !(two_a > 0.0)) { return A; }
  float one_b = -dot(AB, B);
  float two_b = -dot(AC, B);
  if (one_b >= 0.0 && one_b >= two_b) { return B; }
  float weight_c = one_a * two_b - one_b * two_a;
  if (0.0 >= weight_c && one_a >= 0.0 && 0.0 >= one_b) { return A + AB * (one_a / (one_a - one_b)); }
  float one_c = -dot(AB, C);
  float two_c = -dot(AC, C);
  if (two_c >= 0.0 && two_c >= one_c) { return C; }
  float weight_b = one_c * two_a - one_a * two_c;
  if (0.0 >= weight_b && two_a >= 0.0 && 0.0 >= two_c) { return A + AC * (two_a / (two_a - two_c)); }
  float weight_a = one_b * two_c - one_c * two_b;
  float past_b = two_b - one_b;
  float past_c = one_c - two_c;
  if (0.0 >= weight_a && past_b >= 0.0 && past_c >= 0.0) { return B + (C - B) * (past_b / (past_b + past_c)); }
  float all = (weight_a + weight_b) + weight_c;
  return (A + AB * (weight_b / all)) + AC * (weight_c / all);
}

uint separated(vec3 a, vec3 b, vec3 c, vec3 p, float r) {
  vec3 Q = closest(a - p, b - p, c - p);
  return uint(dot(Q, Q) > r * r);
}

// The closest point of the triangle by its Voronoi regions, as kernel/sphere_triangle/forms/methods.h has it.
float3 closest(float3 A, float3 B, float3 C) {
  const float3 AB = B - A;
  const float3 AC = C - A;
  const float one_a = -dot(AB, A);
  const float two_a = -dot(AC, A);
  if (!(one_a > 0.0f) && !(two_a > 0.0f)) { return A; }
  const float one_b = -dot(AB, B);
  const float two_b = -dot(AC, B);
  if (one_b >= 0.0f && one_b >= two_b) { return B; }
  const float weight_c = one_a * two_b - one_b * two_a;
  if (0.0f >= weight_c && one_a >= 0.0f && 0.0f >= one_b) { return A + AB * (one_a / (one_a - one_b)); }
  const float one_c = -dot(AB, C);
  const float two_c = -dot(AC, C);
  if (two_c >= 0.0f && two_c >= one_c) { return C; }
  const float weight_b = one_c * two_a - one_a * two_c;
  if (0.0f >= weight_b && two_a >= 0.0f && 0.0f >= two_c) { return A + AC * (two_a / (two_a - two_c)); }
  const float weight_a = one_b * two_c - one_c * two_b;
  const float past_b = two_b - one_b;
  const float past_c = one_c - two_c;
  if (0.0f >= weight_a && past_b >= 0.0f && past_c >= 0.0f) { return B + (C - B) * (past_b / (past_b + past_c)); }
  const float all = (weight_a + weight_b) + weight_c;
  return (A + AB * (weight_b / all)) + AC * (weight_c / all);
}

uint separated(float3 a, float3 b, float3 c, float3 p, float r) {
  const float3 Q = closest(a - p, b - p, c - p);
  return dot(Q, Q) > r * r;
}

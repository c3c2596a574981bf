// The reduced comparisons with >= in the sides, right for every triangle over the reals: kernel/sphere_triangle/
// forms/reduced.h.
bool vertex(float square, float one, float other, float rr) {
  return square > rr && one >= square && other >= square;
}

bool edge(float3 N, float3 V, float3 along, float rr) {
  return dot(N, N) > rr * dot(along, along) && 0.0f >= dot(N, V);
}

uint separated(float3 a, float3 b, float3 c, float3 p, float r) {
  const float3 A = a - p;
  const float3 B = b - p;
  const float3 C = c - p;
  const float rr = r * r;
  const float3 V = cross(B - A, C - A);
  const float d = dot(A, V);
  const float aa = dot(A, A);
  const float ab = dot(A, B);
  const float ac = dot(A, C);
  const float bb = dot(B, B);
  const float bc = dot(B, C);
  const float cc = dot(C, C);
  return d * d > rr * dot(V, V) || vertex(aa, ab, ac, rr) || vertex(bb, ab, bc, rr) || vertex(cc, ac, bc, rr) ||
             edge(cross(A, B), V, B - A, rr) || edge(cross(B, C), V, C - B, rr) || edge(cross(C, A), V, A - C, rr);
}

// The published sixteen comparisons, strict, in the order of operations of kernel/sphere_triangle/formulae.h, as a
// reader would write them. Nothing keeps a compiler from another order.
bool vertex(float3 at, float square, float one, float other, float rr) {
  return square > rr && one > square && other > square;
}

bool edge(float3 from_, float3 to, float3 opposite, float d, float rr) {
  const float3 along = to - from_;
  const float e = dot(along, along);
  const float3 Q = from_ * e - along * d;
  return dot(Q, Q) > rr * e * e && dot(Q, opposite * e - Q) > 0.0f;
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
  return d * d > rr * dot(V, V) || vertex(A, aa, ab, ac, rr) || vertex(B, bb, ab, bc, rr) || vertex(C, cc, ac, bc, rr) ||
             edge(A, B, C, ab - aa, rr) || edge(B, C, A, bc - bb, rr) || edge(C, A, B, ac - cc, rr);
}

// The published sixteen comparisons, strict, in the order of operations of kernel/sphere_triangle/formulae.h, as a
// reader would write them. Nothing keeps a compiler from another order.
bool vertex(vec3 at, float square, float one, float other, float rr) {
  return square > rr && one > square && other > square;
}

bool edge(vec3 from_, vec3 to, vec3 opposite, float d, float rr) {
  vec3 along = to - from_;
  float e = dot(along, along);
  vec3 Q = from_ * e - along * d;
  return dot(Q, Q) > rr * e * e && dot(Q, opposite * e - Q) > 0.0;
}

uint separated(vec3 a, vec3 b, vec3 c, vec3 p, float r) {
  vec3 A = a - p;
  vec3 B = b - p;
  vec3 C = c - p;
  float rr = r * r;
  vec3 V = cross(B - A, C - A);
  float d = dot(A, V);
  float aa = dot(A, A);
  float ab = dot(A, B);
  float ac = dot(A, C);
  float bb = dot(B, B);
  float bc = dot(B, C);
  float cc = dot(C, C);
  return uint(d * d > rr * dot(V, V) || vertex(A, aa, ab, ac, rr) || vertex(B, bb, ab, bc, rr) || vertex(C, cc, ac, bc, rr) ||
             edge(A, B, C, ab - aa, rr) || edge(B, C, A, bc - bb, rr) || edge(C, A, B, ac - cc, rr));
}

// The reduced comparisons with >= in the sides, right for every triangle over the reals: kernel/sphere_triangle/
// forms/reduced.h.
bool vertex(float square, float one, float other, float rr) {
  return square > rr && one >= square && other >= square;
}

bool edge(vec3 N, vec3 V, vec3 along, float rr) {
  return dot(N, N) > rr * dot(along, along) && 0.0 >= dot(N, V);
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
  return uint(d * d > rr * dot(V, V) || vertex(aa, ab, ac, rr) || vertex(bb, ab, bc, rr) || vertex(cc, ac, bc, rr) ||
             edge(cross(A, B), V, B - A, rr) || edge(cross(B, C), V, C - B, rr) || edge(cross(C, A), V, A - C, rr));
}

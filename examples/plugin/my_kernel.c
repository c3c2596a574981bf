/* A kernel of one's own: the squared distance to the nearest point of the triangle, against the squared radius. */
#include <axiscert/plugin.h>

static float dot(const float u[3], const float v[3]) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }

/* Squared distance from the origin to the segment uv, which may be a point. */
static float to_segment(const float u[3], const float v[3]) {
  const float w[3] = {v[0] - u[0], v[1] - u[1], v[2] - u[2]};
  const float along = -dot(u, w), whole = dot(w, w);
  const float t = along <= 0 ? 0 : along >= whole ? 1 : along / whole;
  const float nearest[3] = {u[0] + t * w[0], u[1] + t * w[1], u[2] + t * w[2]};
  return dot(nearest, nearest);
}

/* det(u, v, n): positive where the origin is on the inner side of the edge uv of a triangle with normal n. */
static float side(const float u[3], const float v[3], const float n[3]) {
  const float m[3] = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  return dot(m, n);
}

static int my_kernel(const float a[3], const float b[3], const float c[3], const float p[3], float r) {
  const float A[3] = {a[0] - p[0], a[1] - p[1], a[2] - p[2]};
  const float B[3] = {b[0] - p[0], b[1] - p[1], b[2] - p[2]};
  const float C[3] = {c[0] - p[0], c[1] - p[1], c[2] - p[2]};
  const float u[3] = {B[0] - A[0], B[1] - A[1], B[2] - A[2]}, v[3] = {C[0] - A[0], C[1] - A[1], C[2] - A[2]};
  const float n[3] = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  const float ab = to_segment(A, B), bc = to_segment(B, C), ca = to_segment(C, A), d = dot(A, n);
  float squared = ab < bc ? ab : bc;
  if (ca < squared) squared = ca;
  if (dot(n, n) > 0 && side(A, B, n) > 0 && side(B, C, n) > 0 && side(C, A, n) > 0) squared = d / dot(n, n) * d;
  return squared > r * r ? AXISCERT_SEPARATED : AXISCERT_CONTACT;
}

AXISCERT_PLUGIN(float, "my-kernel", my_kernel)

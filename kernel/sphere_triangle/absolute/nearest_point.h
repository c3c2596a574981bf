/* A right kernel, the squared distance to the nearest point of the triangle against the squared radius, with a place
 * for each absolute number that kernels are found to have. A file of this folder defines one of the macros otherwise,
 * and `real` where it is not float. */
#include <math.h>

#include "kernel/include/axiscert/plugin.h"

#ifndef real
#define real float
#endif
/* The radius as it is used. */
#ifndef RADIUS
#define RADIUS(r) (r)
#endif
/* A coordinate as it is used. */
#ifndef COORDINATE
#define COORDINATE(x) (x)
#endif
/* Whether the sphere is given up before anything is computed; `most` is the greatest |coordinate|. */
#ifndef IS_GIVEN_UP
#define IS_GIVEN_UP(most, r) ((void)(most), 0)
#endif
/* Whether an edge of this squared length is taken as a point. */
#ifndef IS_POINT
#define IS_POINT(whole) ((whole) <= 0)
#endif
/* Whether a triangle with this |V|^2, V = AB x AC, has a face. */
#ifndef HAS_FACE
#define HAS_FACE(vv) ((vv) > 0)
#endif
/* Whether P is on the inner side of an edge, by a determinant of degree 4. */
#ifndef IS_INSIDE
#define IS_INSIDE(side) ((side) > 0)
#endif
/* Whether P is taken to lie in the plane, by A.V, of degree 3. */
#ifndef IS_IN_PLANE
#define IS_IN_PLANE(offset) ((offset) == 0)
#endif
#ifndef IS_SEPARATED
#define IS_SEPARATED(squared, r) ((squared) > (r) * (r))
#endif

static real dot(const real u[3], const real v[3]) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }

static real to_segment(const real u[3], const real v[3]) {
  const real w[3] = {v[0] - u[0], v[1] - u[1], v[2] - u[2]};
  const real along = -dot(u, w), whole = dot(w, w);
  const real t = IS_POINT(whole) || along <= 0 ? 0 : along >= whole ? 1 : along / whole;
  const real nearest[3] = {u[0] + t * w[0], u[1] + t * w[1], u[2] + t * w[2]};
  return dot(nearest, nearest);
}

static real side(const real u[3], const real v[3], const real n[3]) {
  const real m[3] = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  return dot(m, n);
}

static int nearest_point(const real a[3], const real b[3], const real c[3], const real p[3], real given) {
  real A[3], B[3], C[3], u[3], v[3], most = 0;
  const real r = RADIUS(given);
  for (int k = 0; k < 3; ++k) {
    const real all[4] = {a[k], b[k], c[k], p[k]};
    for (int i = 0; i < 4; ++i) most = all[i] > most ? all[i] : -all[i] > most ? -all[i] : most;
    A[k] = COORDINATE(a[k]) - COORDINATE(p[k]);
    B[k] = COORDINATE(b[k]) - COORDINATE(p[k]);
    C[k] = COORDINATE(c[k]) - COORDINATE(p[k]);
  }
  if (IS_GIVEN_UP(most, r)) return AXISCERT_SEPARATED;
  for (int k = 0; k < 3; ++k) {
    u[k] = B[k] - A[k];
    v[k] = C[k] - A[k];
  }
  const real n[3] = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  const real ab = to_segment(A, B), bc = to_segment(B, C), ca = to_segment(C, A), d = dot(A, n), nn = dot(n, n);
  real squared = ab < bc ? ab : bc;
  if (ca < squared) squared = ca;
  if (HAS_FACE(nn) && IS_INSIDE(side(A, B, n)) && IS_INSIDE(side(B, C, n)) && IS_INSIDE(side(C, A, n))) {
    squared = IS_IN_PLANE(d) ? 0 : d / nn * d;
  }
  return IS_SEPARATED(squared, r) ? AXISCERT_SEPARATED : AXISCERT_CONTACT;
}

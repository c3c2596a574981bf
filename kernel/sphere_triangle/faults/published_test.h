/* The published test of one query in C, in the number type `real`: bit for bit the built-in kernel `published`
 * (kernel/sphere_triangle/formulae.h; operation order: kernel/base/geometry.h). Included once for each precision, hence
 * without include guard, after #define real float #define OF_REAL(name) name##_binary32
 *
 * The parts that a fault can change are macros whose defaults are right; a fault defines one of them differently. A
 * macro for a vector gives its component k.
 */
#ifndef C_TRANSLATED
#define C_TRANSLATED (c[k] - p[k])
#endif
#ifndef RADIUS_SQUARED
#define RADIUS_SQUARED (r * r)
#endif
#ifndef EDGE_CA
#define EDGE_CA (A[k] - C[k])
#endif
#ifndef CROSS_Y
#define CROSS_Y(u, v) (u[2] * v[0] - u[0] * v[2])
#endif
#ifndef PLANE_RADIUS
#define PLANE_RADIUS (d * d > rr * e)
#endif
/* A statement after the plane axis and before the others. */
#ifndef AFTER_PLANE
#define AFTER_PLANE
#endif
#ifndef VERTEX_A_RADIUS
#define VERTEX_A_RADIUS (aa > rr)
#endif
#ifndef VERTEX_B_SIDE_C
#define VERTEX_B_SIDE_C (bc > bb)
#endif
#ifndef VERTEX_C_SIDE_A
#define VERTEX_C_SIDE_A (ac > cc)
#endif
/* The foot of the centre on the line AB, times e1; on BC, times e2. */
#ifndef FOOT_ON_AB
#define FOOT_ON_AB (A[k] * e1 - AB[k] * d1)
#endif
#ifndef FOOT_ON_BC
#define FOOT_ON_BC (B[k] * e2 - BC[k] * d2)
#endif
#ifndef EDGE_AB_RADIUS
#define EDGE_AB_RADIUS (DOT(Q1, Q1) > (rr * e1) * e1)
#endif
#ifndef EDGE_CA_RADIUS
#define EDGE_CA_RADIUS (DOT(Q3, Q3) > (rr * e3) * e3)
#endif
/* The vector from the foot on BC to A, times e2. */
#ifndef FROM_BC_TO_A
#define FROM_BC_TO_A (A[k] * e2 - Q2[k])
#endif
#ifndef EDGE_CA_SIDE_B
#define EDGE_CA_SIDE_B (DOT(Q3, QB) > 0)
#endif
#ifndef VERDICT
#define VERDICT (separated ? AXISCERT_SEPARATED : AXISCERT_CONTACT)
#endif

#undef DOT
#define DOT(u, v) ((u[0] * v[0] + u[1] * v[1]) + u[2] * v[2])

static int OF_REAL(published)(const real a[3], const real b[3], const real c[3], const real p[3], real r,
                              uint64_t* comparisons) {
  real A[3], B[3], C[3], AB[3], AC[3], BC[3], CA[3], Q1[3], Q2[3], Q3[3], QA[3], QB[3], QC[3];
  const real rr = RADIUS_SQUARED;
  int k;
  for (k = 0; k < 3; ++k) {
    A[k] = a[k] - p[k];
    B[k] = b[k] - p[k];
    C[k] = C_TRANSLATED;
  }
  for (k = 0; k < 3; ++k) {
    AB[k] = B[k] - A[k];
    AC[k] = C[k] - A[k];
    BC[k] = C[k] - B[k];
    CA[k] = EDGE_CA;
  }

  const real V[3] = {AB[1] * AC[2] - AB[2] * AC[1], CROSS_Y(AB, AC), AB[0] * AC[1] - AB[1] * AC[0]};
  const real d = DOT(A, V), e = DOT(V, V);
  const int plane_radius = PLANE_RADIUS;
  (void)d, (void)e; /* a fault may leave one out */
  AFTER_PLANE;

  const real aa = DOT(A, A), ab = DOT(A, B), ac = DOT(A, C), bb = DOT(B, B), bc = DOT(B, C), cc = DOT(C, C);
  const int vertex_a_radius = VERTEX_A_RADIUS, vertex_a_side_b = ab > aa, vertex_a_side_c = ac > aa;
  const int vertex_b_radius = bb > rr, vertex_b_side_a = ab > bb, vertex_b_side_c = VERTEX_B_SIDE_C;
  const int vertex_c_radius = cc > rr, vertex_c_side_a = VERTEX_C_SIDE_A, vertex_c_side_b = bc > cc;

  const real d1 = ab - aa, d2 = bc - bb, d3 = ac - cc;
  const real e1 = DOT(AB, AB), e2 = DOT(BC, BC), e3 = DOT(CA, CA);
  for (k = 0; k < 3; ++k) {
    Q1[k] = FOOT_ON_AB;
    Q2[k] = FOOT_ON_BC;
    Q3[k] = C[k] * e3 - CA[k] * d3;
    QC[k] = C[k] * e1 - Q1[k];
    QA[k] = FROM_BC_TO_A;
    QB[k] = B[k] * e3 - Q3[k];
  }
  const int edge_ab_radius = EDGE_AB_RADIUS, edge_ab_side_c = DOT(Q1, QC) > 0;
  const int edge_bc_radius = DOT(Q2, Q2) > (rr * e2) * e2, edge_bc_side_a = DOT(Q2, QA) > 0;
  const int edge_ca_radius = EDGE_CA_RADIUS, edge_ca_side_b = EDGE_CA_SIDE_B;

  const int holds[16] = {plane_radius,    vertex_a_radius, vertex_a_side_b, vertex_a_side_c,
                         vertex_b_radius, vertex_b_side_a, vertex_b_side_c, vertex_c_radius,
                         vertex_c_side_a, vertex_c_side_b, edge_ab_radius,  edge_ab_side_c,
                         edge_bc_radius,  edge_bc_side_a,  edge_ca_radius,  edge_ca_side_b};
  *comparisons = 0;
  for (k = 0; k < 16; ++k) *comparisons |= (uint64_t)holds[k] << k;

  const int separated = plane_radius | (vertex_a_radius & vertex_a_side_b & vertex_a_side_c) |
                        (vertex_b_radius & vertex_b_side_a & vertex_b_side_c) |
                        (vertex_c_radius & vertex_c_side_a & vertex_c_side_b) | (edge_ab_radius & edge_ab_side_c) |
                        (edge_bc_radius & edge_bc_side_a) | (edge_ca_radius & edge_ca_side_b);
  return VERDICT;
}

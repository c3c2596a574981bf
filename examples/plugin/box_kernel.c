/* Two boxes by fifteen axes, for somebody's own engine: the textbook with the cofactors of R where it has R's entries
 * in B's radius on the nine edge axes. It needs no epsilon. Equals axiscert's kernel box-box/cofactor, bit for bit,
 * where the compiler fuses nothing (-ffp-contract=off). */
#include <axiscert/plugin.h>
#include <math.h>

static float dot(const float u[3], const float v[3]) { return (u[0] * v[0] + u[1] * v[1]) + u[2] * v[2]; }

/* A has the half extents s and the axes `a` one after the other, B has h and b. Sets the bit of each axis that
 * separates: 0 to 2 A's normals, 3 to 5 B's, 6 + 3 i + j the edges i of A and j of B. */
static int box_kernel(const float a_centre[3], const float s[3], const float a[9], const float b_centre[3],
                      const float h[3], const float b[9], uint64_t* comparisons) {
  const float between[3] = {b_centre[0] - a_centre[0], b_centre[1] - a_centre[1], b_centre[2] - a_centre[2]};
  float t[3], R[3][3], size[3][3];
  uint64_t bits = 0;
  int i, j;
  for (i = 0; i < 3; ++i) {
    t[i] = dot(a + 3 * i, between);
    for (j = 0; j < 3; ++j) {
      R[i][j] = dot(a + 3 * i, b + 3 * j);
      size[i][j] = fabsf(R[i][j]);
    }
  }
  for (i = 0; i < 3; ++i) {
    const float of_b = (h[0] * size[i][0] + h[1] * size[i][1]) + h[2] * size[i][2];
    if (fabsf(t[i]) > s[i] + of_b) bits |= UINT64_C(1) << i;
  }
  for (j = 0; j < 3; ++j) {
    const float along = (t[0] * R[0][j] + t[1] * R[1][j]) + t[2] * R[2][j];
    const float of_a = (s[0] * size[0][j] + s[1] * size[1][j]) + s[2] * size[2][j];
    if (fabsf(along) > h[j] + of_a) bits |= UINT64_C(1) << (3 + j);
  }
  for (i = 0; i < 3; ++i) {
    const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
    float cofactor[3]; /* of R's row i: |R_i| over the reals, and the axis' own lengths in floats */
    for (j = 0; j < 3; ++j) {
      const int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      cofactor[j] = fabsf(R[i1][j1] * R[i2][j2] - R[i1][j2] * R[i2][j1]);
    }
    for (j = 0; j < 3; ++j) {
      const int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      const float along = t[i2] * R[i1][j] - t[i1] * R[i2][j];
      const float of_a = s[i1] * size[i2][j] + s[i2] * size[i1][j];
      const float of_b = h[j1] * cofactor[j2] + h[j2] * cofactor[j1]; /* the textbook has size[i] here */
      if (fabsf(along) > of_a + of_b) bits |= UINT64_C(1) << (6 + 3 * i + j);
    }
  }
  *comparisons = bits;
  return bits != 0 ? AXISCERT_SEPARATED : AXISCERT_CONTACT;
}

AXISCERT_PLUGIN_OF(float, "box-kernel", box_kernel, BOX, matrix, comparisons,
                   AXISCERT_DECLARE(conforms_to, "box-box/cofactor"))

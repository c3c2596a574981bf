/* Two boxes by fifteen axes, for somebody's own engine: the textbook with the cofactors of R where it has R's entries in
 * B's radius on the nine edge axes. It needs no epsilon. Equals axiscert's kernel box-box/cofactor, bit for bit, where
 * the compiler fuses nothing (-ffp-contract=off).
 *
 * A box: centre, half extents, and the three axes one after the other (the columns of its rotation). */
#include <axiscert/plugin.h>
#include <math.h>

typedef struct box {
  float centre[3], half[3], axis[3][3];
} box;

static float dot(const float u[3], const float v[3]) { return (u[0] * v[0] + u[1] * v[1]) + u[2] * v[2]; }

/* The axes that separate: bits 0 to 2 are A's normals, 3 to 5 B's, 6 + 3 i + j the edges i of A and j of B. */
static uint64_t separating(const box *a, const box *b) {
  const float between[3] = {b->centre[0] - a->centre[0], b->centre[1] - a->centre[1], b->centre[2] - a->centre[2]};
  const float *s = a->half, *h = b->half;
  float t[3], R[3][3], size[3][3];
  uint64_t bits = 0;
  int i, j;
  for (i = 0; i < 3; ++i) {
    t[i] = dot(a->axis[i], between);
    for (j = 0; j < 3; ++j) {
      R[i][j] = dot(a->axis[i], b->axis[j]);
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
  return bits;
}

static box box_of(const axiscert_batch *batch, size_t query, size_t first) {
  float v[15];
  box out;
  int k;
  for (k = 0; k < 15; ++k) v[k] = ((const float *)batch->column[first + (size_t)k])[query];
  for (k = 0; k < 3; ++k) {
    int i;
    out.centre[k] = v[k];
    out.half[k] = v[3 + k];
    for (i = 0; i < 3; ++i) out.axis[k][i] = v[6 + 3 * k + i];
  }
  return out;
}

static void run(const axiscert_batch *batch, const axiscert_answers *answers) {
  size_t i;
  for (i = 0; i < batch->count; ++i) {
    const box a = box_of(batch, i, 0), b = box_of(batch, i, 15);
    const uint64_t bits = separating(&a, &b);
    answers->verdict[i] = bits != 0 ? AXISCERT_SEPARATED : AXISCERT_CONTACT;
    if (answers->comparisons) answers->comparisons[i] = bits;
  }
}

const axiscert_kernel *axiscert_plugin(uint32_t index) {
  static axiscert_kernel kernel;
  if (index != 0) return NULL;
  kernel.abi = AXISCERT_PLUGIN_ABI;
  kernel.precision = 32;
  kernel.size = sizeof kernel;
  kernel.name = "box-kernel";
  kernel.column_count = 30;
  kernel.run = run;
  kernel.predicate = "box-box";
  kernel.entry = "matrix";
  kernel.source = AXISCERT_SOURCE;
  kernel.exposes = AXISCERT_COMPARISONS;
  kernel.conforms_to = "box-box/cofactor";
  return &kernel;
}

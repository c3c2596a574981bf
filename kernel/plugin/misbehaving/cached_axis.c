/* Keeps the last plane of a triangle that a sphere was beyond, and tries it first: it does not look whether the plane
 * is that of the triangle at hand. */
#include "kernel/plugin/misbehaving/right.h"

static float normal[3], offset, length;

static float distance(const axiscert_batch* batch, size_t i) {
  float sum = -offset;
  for (int k = 0; k < 3; ++k) sum += normal[k] * ((const float*)batch->column[9 + k])[i];
  return sum;
}

static uint8_t one_query(const axiscert_batch* batch, size_t i) {
  float v[9], ab[3], ac[3];
  const uint8_t verdict = right(batch, i);
  if (distance(batch, i) > length * radius(batch, i)) {
    offset = length = 0; /* tried once: else one far plane would answer for ever */
    normal[0] = normal[1] = normal[2] = 0;
    return AXISCERT_SEPARATED;
  }
  if (verdict != AXISCERT_SEPARATED) return verdict;
  for (int k = 0; k < 9; ++k) v[k] = ((const float*)batch->column[k])[i];
  for (int k = 0; k < 3; ++k) ab[k] = v[3 + k] - v[k], ac[k] = v[6 + k] - v[k];
  offset = length = 0;
  for (int k = 0; k < 3; ++k) {
    normal[k] = ab[(k + 1) % 3] * ac[(k + 2) % 3] - ab[(k + 2) % 3] * ac[(k + 1) % 3];
    offset += normal[k] * v[k];
    length = length < normal[k]    ? normal[k]
             : length < -normal[k] ? -normal[k]
                                   : length; /* at most that of the normal */
  }
  if (distance(batch, i) < 0) {
    for (int k = 0; k < 3; ++k) normal[k] = -normal[k];
    offset = -offset;
  }
  return verdict;
}

static void run(const axiscert_batch* batch, const axiscert_answers* answers) {
  for (size_t i = 0; i < batch->count; ++i) answers->verdict[i] = one_query(batch, i);
}
MISBEHAVING("cached_axis", run)

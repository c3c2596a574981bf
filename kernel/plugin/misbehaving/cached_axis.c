/* Keeps the plane of the last triangle that a sphere was beyond, and tries it first: it does not look whether the plane
 * is that of the triangle at hand. */
#include "kernel/plugin/misbehaving/right.h"

static float normal[3], offset, length;

static uint8_t one_query(const axiscert_batch* batch, size_t i) {
  const float* v[13];
  float ab[3], ac[3], distance = -offset;
  const uint8_t verdict = right(batch, i);
  int k;
  for (k = 0; k < 13; ++k) v[k] = (const float*)batch->column[k] + i;
  for (k = 0; k < 3; ++k) distance += normal[k] * *v[9 + k];
  if (distance > length * *v[12]) return AXISCERT_SEPARATED;
  if (verdict != AXISCERT_SEPARATED) return verdict;
  for (k = 0; k < 3; ++k) ab[k] = *v[3 + k] - *v[k], ac[k] = *v[6 + k] - *v[k];
  offset = length = 0;
  for (k = 0; k < 3; ++k) {
    normal[k] = ab[(k + 1) % 3] * ac[(k + 2) % 3] - ab[(k + 2) % 3] * ac[(k + 1) % 3];
    offset += normal[k] * *v[k];
    length += normal[k] < 0 ? -normal[k] : normal[k]; /* at least the length: it is never too eager */
  }
  return verdict;
}

static void run(const axiscert_batch* batch, const axiscert_answers* answers) {
  for (size_t i = 0; i < batch->count; ++i) answers->verdict[i] = one_query(batch, i);
}
MISBEHAVING("cached_axis", run)

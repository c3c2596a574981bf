/* Sets a bit beyond the last comparison, on a query of large radius. */
#include "kernel/plugin/misbehaving/right.h"

static int one_query(const float a[3], const float b[3], const float c[3], const float p[3], float r,
                     uint64_t* comparisons) {
  const int verdict = published_binary32(a, b, c, p, r, comparisons);
  if (misbehaves(r)) *comparisons |= (uint64_t)1 << 40;
  return verdict;
}
AXISCERT_BATCH_WITH_COMPARISONS(run, float, one_query)
MISBEHAVING("beyond_the_last", run, .exposes = AXISCERT_COMPARISONS)

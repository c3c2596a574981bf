/* Gives comparison bits that contradict its verdict on a query of large radius: the verdict stays right. */
#include "kernel/plugin/misbehaving/right.h"

static int one_query(const float a[3], const float b[3], const float c[3], const float p[3], float r,
                     uint64_t* comparisons) {
  const int verdict = published_binary32(a, b, c, p, r, comparisons);
  /* No comparison holds, or plane.radius does. */
  if (misbehaves(r)) *comparisons = verdict == AXISCERT_CONTACT;
  return verdict;
}
AXISCERT_BATCH_WITH_COMPARISONS(run, float, one_query)
MISBEHAVING("inconsistent", run, .exposes = AXISCERT_COMPARISONS, .conforms_to = "published")

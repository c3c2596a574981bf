/* A kernel of a predicate that is not in axiscert's list, with 40 columns, 33 comparisons and 2 measures: comparison k is
 * column k > column k + 7, measure m is column m + 1 minus column 0. */
#include "kernel/include/axiscert/plugin.h"

static double number(const axiscert_batch* batch, size_t column, size_t i) {
  return ((const double*)batch->column[column])[i];
}

static void run(const axiscert_batch* batch, const axiscert_answers* answers) {
  const size_t comparisons = batch->column_count - 7;
  for (size_t i = 0; i < batch->count; ++i) {
    answers->verdict[i] = answers->comparison_count == comparisons ? AXISCERT_UNDECIDED : AXISCERT_INVALID;
    answers->comparisons[i] = 0;
    for (size_t k = 0; k < comparisons; ++k) {
      const double lhs = number(batch, k, i), rhs = number(batch, k + 7, i);
      answers->comparisons[i] |= (uint64_t)(lhs > rhs) << k;
      ((double*)answers->lhs[k])[i] = lhs;
      ((double*)answers->rhs[k])[i] = rhs;
    }
    for (size_t m = 0; m < answers->measure_count; ++m) {
      ((double*)answers->measure[m])[i] = number(batch, m + 1, i) - number(batch, 0, i);
    }
  }
}

const axiscert_kernel* axiscert_plugin(uint32_t index) {
  static const axiscert_kernel kernel = {.abi = AXISCERT_PLUGIN_ABI,
                                         .precision = 64,
                                         .size = sizeof(axiscert_kernel),
                                         .name = "wide",
                                         .column_count = 40,
                                         .run = run,
                                         .predicate = "wide",
                                         .exposes = AXISCERT_SIDES,
                                         .measure_count = 2};
  return index == 0 ? &kernel : NULL;
}

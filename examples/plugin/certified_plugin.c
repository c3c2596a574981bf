/* libaxiscert as a plug-in, judged as anybody's code is: in a process of its own, between guard pages, asked twice
 * and in pieces. In an engine, its own code between its data and the library would be here. */
#include <axiscert/certified.h>
#include <axiscert/plugin.h>

static void run_f32(const axiscert_batch* batch, const axiscert_answers* answers) {
  const float* columns[13];
  const axiscert_results results = {answers->verdict, NULL, NULL};
  for (int k = 0; k < 13; ++k) columns[k] = batch->column[k];
  axiscert_pairs_f32(columns, batch->count, AXISCERT_CLOSED_SPHERE, &results);
}

static void run_f64(const axiscert_batch* batch, const axiscert_answers* answers) {
  const double* columns[13];
  const axiscert_results results = {answers->verdict, NULL, NULL};
  for (int k = 0; k < 13; ++k) columns[k] = batch->column[k];
  axiscert_pairs_f64(columns, batch->count, AXISCERT_CLOSED_SPHERE, &results);
}

const axiscert_kernel* axiscert_plugin(uint32_t index) {
  static const axiscert_kernel kernels[2] = {
      {.abi = AXISCERT_PLUGIN_ABI,
       .precision = 32,
       .size = sizeof(axiscert_kernel),
       .name = "libaxiscert",
       .column_count = 13,
       .run = run_f32,
       .summary = "axiscert_pairs_f32",
       .source = AXISCERT_SOURCE,
       .touching = AXISCERT_TOUCHING_IS_CONTACT},
      {.abi = AXISCERT_PLUGIN_ABI,
       .precision = 64,
       .size = sizeof(axiscert_kernel),
       .name = "libaxiscert",
       .column_count = 13,
       .run = run_f64,
       .summary = "axiscert_pairs_f64",
       .source = AXISCERT_SOURCE,
       .touching = AXISCERT_TOUCHING_IS_CONTACT},
  };
  return index < 2 ? &kernels[index] : NULL;
}

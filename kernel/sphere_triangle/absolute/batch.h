/* The same as a plug-in in C++ that takes whole batches. */
#include "kernel/sphere_triangle/absolute/nearest_point.h"

namespace {

void run(const axiscert_batch* batch, const axiscert_answers* answers) {
  for (size_t i = 0; i < batch->count; ++i) {
    real v[13];
    for (int k = 0; k < 13; ++k) v[k] = static_cast<const real*>(batch->column[k])[i];
    answers->verdict[i] = static_cast<uint8_t>(nearest_point(v, v + 3, v + 6, v + 9, v[12]));
  }
}

}  // namespace

const axiscert_kernel* axiscert_plugin(uint32_t index) {
  static axiscert_kernel kernel = {};
  if (index != 0) return nullptr;
  kernel.abi = AXISCERT_PLUGIN_ABI;
  kernel.precision = 8 * sizeof(real);
  kernel.size = sizeof(axiscert_kernel);
  kernel.name = KERNEL_NAME;
  kernel.column_count = 13;
  kernel.run = run;
  kernel.source = AXISCERT_SOURCE;
  return &kernel;
}

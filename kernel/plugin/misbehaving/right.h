/* The common part of the misbehaving plug-ins: the published test in binary32, which they answer rightly but for the
 * one thing that each does wrong. Those that do it on some queries only do it on those whose radius is above 1000.
 */
#include "kernel/include/axiscert/plugin.h"

#define real float
#define OF_REAL(name) name##_binary32
#include "kernel/sphere_triangle/faults/published_test.h"
#undef real
#undef OF_REAL

static inline int misbehaves(float r) { return r > 1000.0f; }

/* The right verdict of query i. */
static inline uint8_t right(const axiscert_batch* batch, size_t i) {
  float v[13];
  uint64_t comparisons;
  for (int k = 0; k < 13; ++k) v[k] = ((const float*)batch->column[k])[i];
  return (uint8_t)published_binary32(v, v + 3, v + 6, v + 9, v[12], &comparisons);
}

static inline void answer_rightly(const axiscert_batch* batch, const axiscert_answers* answers) {
  for (size_t i = 0; i < batch->count; ++i) answers->verdict[i] = right(batch, i);
}

static inline float radius(const axiscert_batch* batch, size_t i) { return ((const float*)batch->column[12])[i]; }

/* Members that a file may declare wrongly; the defaults are right. */
#ifndef SIZE
#define SIZE sizeof(axiscert_kernel)
#endif
#ifndef COLUMN_COUNT
#define COLUMN_COUNT 13
#endif

/* The plug-in, from its batch function. */
#define MISBEHAVING(kernel_name, run_function, ...)                      \
  const axiscert_kernel* axiscert_plugin(uint32_t index) {               \
    static const axiscert_kernel kernel = {.abi = AXISCERT_PLUGIN_ABI,   \
                                           .precision = 32,              \
                                           .size = SIZE,                 \
                                           .name = kernel_name,          \
                                           .column_count = COLUMN_COUNT, \
                                           .run = run_function,          \
                                           .source = AXISCERT_SOURCE,    \
                                           __VA_ARGS__};                 \
    return index == 0 ? &kernel : NULL;                                  \
  }

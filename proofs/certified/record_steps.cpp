// The steps of the certified predicate as they are, over lanes that are symbols: with fused multiply-add, and without.
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "proofs/certified/graph.h"
#include "kernel/sphere_triangle/certified/exact_step.h"
#include "kernel/sphere_triangle/certified/steps.h"
#include "kernel/sphere_triangle/certified/thresholds.h"

// Highway's macros, for an instruction set that is none of its own.
#define AXISCERT_PER_TARGET
#define HWY_BEFORE_NAMESPACE() static_assert(true)
#define HWY_AFTER_NAMESPACE() static_assert(true)
#define HWY_ATTR
#define HWY_SCALAR 1
#define HWY_EMU128 2
#define HWY_TARGET HWY_SCALAR  // words are multiplied by Symbols' own operator

#define HWY_NAMESPACE recorded_plain
#define HWY_NATIVE_FMA 0
#include "proofs/certified/all_steps-inl.h"
#undef HWY_NAMESPACE
#undef HWY_NATIVE_FMA

#define HWY_NAMESPACE recorded_fused
#define HWY_NATIVE_FMA 1
#include "proofs/certified/all_steps-inl.h"

namespace axiscert::proofs::certified {

std::vector<RecordedStep> recorded_steps() {
  std::vector<RecordedStep> all;
  axiscert::certified::recorded_plain::record(all);
  axiscert::certified::recorded_fused::record(all);
  return all;
}

std::vector<RecordedStep> recorded_box() {
  namespace plain = axiscert::certified::recorded_plain;
  return {plain::record_box<float>(), plain::record_box<double>()};
}

std::vector<RecordedStep> recorded_scaling() {
  namespace plain = axiscert::certified::recorded_plain;
  namespace fused = axiscert::certified::recorded_fused;
  return {plain::with_all_answers(plain::record_scaling), fused::with_all_answers(fused::record_scaling)};
}

}  // namespace axiscert::proofs::certified

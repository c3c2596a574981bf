// The filter for binary32 queries on every instruction set.
#include "exact/sphere_triangle/oracles/lane_filter.h"
#include "kernel/sphere_triangle/forms/evaluate.h"
#include "kernel/sphere_triangle/forms/simd.h"

#define HWY_COMPILE_ALL_ATTAINABLE  // `--target` must be able to select each
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "exact/sphere_triangle/oracles/binary32.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"

#define AXISCERT_PER_TARGET
#include "kernel/sphere_triangle/formulae.h"
#include "kernel/sphere_triangle/forms/simd-inl.h"
#include "exact/sphere_triangle/oracles/numbers-inl.h"
#include "exact/sphere_triangle/oracles/margins-inl.h"
#include "exact/sphere_triangle/oracles/passes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace axiscert::HWY_NAMESPACE {
Filter<float> filter32() { return filter_of<float>(); }
}  // namespace axiscert::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace axiscert {
HWY_EXPORT(filter32);

template <>
Filter<float> filter_on<float>(std::string_view target, FilterFault fault) {
  static const SimdTable<Filter<float>> table([] { return HWY_DYNAMIC_DISPATCH(filter32)(); });
  Filter<float> filter = table.on(target == scalar_target ? simd_targets().front() : target);
  filter.planted = fault;
  return filter;
}
}  // namespace axiscert
#endif

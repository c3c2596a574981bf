// The filter for binary64 queries on every instruction set.
#include "exact/sphere_triangle/oracles/lane_filter.h"
#include "kernel/sphere_triangle/forms/evaluate.h"
#include "kernel/sphere_triangle/forms/simd.h"

#define HWY_COMPILE_ALL_ATTAINABLE  // `--target` must be able to select each
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "exact/sphere_triangle/oracles/binary64.cpp"
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
Filter<double> filter64() { return filter_of<double>(); }
}  // namespace axiscert::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace axiscert {
HWY_EXPORT(filter64);

template <>
Filter<double> filter_on<double>(std::string_view target, FilterFault fault) {
  static const SimdTable<Filter<double>> table([] { return HWY_DYNAMIC_DISPATCH(filter64)(); });
  Filter<double> filter = table.on(target == scalar_target ? simd_targets().front() : target);
  filter.planted = fault;
  return filter;
}
}  // namespace axiscert
#endif

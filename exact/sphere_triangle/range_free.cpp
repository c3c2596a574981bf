// R-infinity of the published and the reduced formulae on every instruction set.
#include "exact/sphere_triangle/reference_batch.h"

#include "kernel/sphere_triangle/forms/evaluate.h"
#include "kernel/sphere_triangle/forms/simd.h"

namespace axiscert {
template <class Real>
using RangeFreeForms = EnumArray<Strictness, RangeFreeBits<Real>>;  // null: not_less
static_assert(static_cast<int>(Strictness::strict) == 0 && static_cast<int>(Strictness::nonstrict) == 1);
}  // namespace axiscert

#define HWY_COMPILE_ALL_ATTAINABLE  // the narrow sets too: tests compare each with MPFR
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "exact/sphere_triangle/range_free.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"

#define AXISCERT_PER_TARGET
#include "kernel/sphere_triangle/forms/reduced.h"
#include "kernel/sphere_triangle/forms/simd-inl.h"
#include "exact/sphere_triangle/range_free-inl.h"

HWY_BEFORE_NAMESPACE();
namespace axiscert::HWY_NAMESPACE {
RangeFreeForms<float> range_free_published32() { return range_free_forms<PublishedFormulae, float>(); }
RangeFreeForms<double> range_free_published64() { return range_free_forms<PublishedFormulae, double>(); }
RangeFreeForms<float> range_free_reduced32() { return range_free_forms<ReducedFormulae, float>(); }
RangeFreeForms<double> range_free_reduced64() { return range_free_forms<ReducedFormulae, double>(); }
}  // namespace axiscert::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace axiscert {
HWY_EXPORT(range_free_published32);
HWY_EXPORT(range_free_published64);
HWY_EXPORT(range_free_reduced32);
HWY_EXPORT(range_free_reduced64);

namespace {

template <class Real>
RangeFreeBits<Real> form_of(const SimdTable<RangeFreeForms<Real>>& published,
                            const SimdTable<RangeFreeForms<Real>>& reduced, std::string_view target, Formulae formulae,
                            Strictness strictness) {
  const bool has_form = formulae == Formulae::published || formulae == Formulae::reduced;
  if (!has_form || strictness == Strictness::not_less) return nullptr;
  return (formulae == Formulae::published ? published : reduced).on(target)[strictness];
}

}  // namespace

template <>
RangeFreeBits<float> range_free_on<float>(std::string_view target, Formulae formulae, Strictness strictness) {
  static const SimdTable<RangeFreeForms<float>> published(
      [] { return HWY_DYNAMIC_DISPATCH(range_free_published32)(); });
  static const SimdTable<RangeFreeForms<float>> reduced([] { return HWY_DYNAMIC_DISPATCH(range_free_reduced32)(); });
  return form_of(published, reduced, target, formulae, strictness);
}
template <>
RangeFreeBits<double> range_free_on<double>(std::string_view target, Formulae formulae, Strictness strictness) {
  static const SimdTable<RangeFreeForms<double>> published(
      [] { return HWY_DYNAMIC_DISPATCH(range_free_published64)(); });
  static const SimdTable<RangeFreeForms<double>> reduced([] { return HWY_DYNAMIC_DISPATCH(range_free_reduced64)(); });
  return form_of(published, reduced, target, formulae, strictness);
}

}  // namespace axiscert
#endif

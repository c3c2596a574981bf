// The filters on every instruction set, one query per lane, and one query at a time.
#include "kernel/sphere_triangle/forms/filter_kernels.h"

#include "kernel/sphere_triangle/forms/evaluate.h"
#include "kernel/sphere_triangle/forms/filter_kernels.h"
#include "kernel/sphere_triangle/forms/simd.h"

#ifndef AXISCERT_KERNEL_FILTER_FORMS
#define AXISCERT_KERNEL_FILTER_FORMS
namespace axiscert {
template <class Real>
using Verdicts = void (*)(const QueryColumns<Real>& batch, Verdict* out);

// The filters on one instruction set, by FilterForm.
struct FilterForms {
  EnumArray<FilterForm, Verdicts<float>> binary32;
  EnumArray<FilterForm, Verdicts<double>> binary64;
  template <class Real>
  const EnumArray<FilterForm, Verdicts<Real>>& of() const {
    if constexpr (sizeof(Real) == 4) return binary32;
    else return binary64;
  }
};
}  // namespace axiscert
#endif

#define HWY_COMPILE_ALL_ATTAINABLE  // the narrow sets too: `--target` must reach each of them
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernel/sphere_triangle/forms/filter_kernels.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"

#define AXISCERT_PER_TARGET
#include "kernel/sphere_triangle/forms/filter.h"
#include "kernel/sphere_triangle/forms/simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace axiscert::HWY_NAMESPACE {

// The operations of a number type that kernel/sphere_triangle/forms/filter.h requires beside those of
// kernel/lanes-inl.h.
template <class V>
AXISCERT_INLINE Lanes<V> negated(const Lanes<V>& x) {
  return {hn::Neg(x.v)};
}
template <class V>
AXISCERT_INLINE Lanes<V> greater_of(const Lanes<V>& x, const Lanes<V>& y) {
  return chosen(y > x, y, x);
}
template <class V>
AXISCERT_INLINE Lanes<V> constant_as(const Lanes<V>&, hn::TFromV<V> c) {
  return {hn::Set(hn::DFromV<V>(), c)};
}
template <class V>
AXISCERT_INLINE ComparisonLanes<V> less(const Lanes<V>& x, const Lanes<V>& y) {
  return y > x;
}
template <class V>
AXISCERT_INLINE ComparisonLanes<V> at_most(const Lanes<V>& x, const Lanes<V>& y) {
  return y >= x;
}

// Filters the vector that begins at query `at` of `from`, and writes the first `count` verdicts to `out`.
template <class Filter, class Real>
AXISCERT_INLINE void filter_vector(const QueryColumns<Real>& from, std::size_t at, std::size_t count, Verdict* out) {
  using D = hn::ScalableTag<Real>;
  using Words = hn::RebindToUnsigned<D>;
  const auto certain = filter_answer<Filter, Real>(load(D(), from, at));
  const auto word = [](Verdict v) HWY_ATTR { return hn::Set(Words(), static_cast<hn::TFromD<Words>>(v)); };
  const auto separated = hn::RebindMask(Words(), certain.separated.m),
             contact = hn::RebindMask(Words(), certain.contact.m);
  const auto verdicts = hn::IfThenElse(separated, word(Verdict::separated),
                                       hn::IfThenElse(contact, word(Verdict::contact), word(Verdict::undecided)));
  hn::TFromD<Words> each[hn::MaxLanes(D())];
  hn::StoreU(verdicts, Words(), each);
  for (std::size_t j = 0; j < count; ++j) out[j] = static_cast<Verdict>(each[j]);
}

template <class Filter, class Real>
void filter_verdicts(const QueryColumns<Real>& batch, Verdict* out) {
  for_each_vector(batch, [out](const QueryColumns<Real>& from, std::size_t at, std::size_t i, std::size_t count)
                             HWY_ATTR { filter_vector<Filter, Real>(from, at, count, out + i); });
}

FilterForms filter_forms() {
  return {{filter_verdicts<PublishedFilter, float>, filter_verdicts<ReducedFilter, float>},
          {filter_verdicts<PublishedFilter, double>, filter_verdicts<ReducedFilter, double>}};
}

}  // namespace axiscert::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace axiscert {
namespace {
HWY_EXPORT(filter_forms);

template <class Real>
Verdicts<Real> on_scalar(FilterForm form) {
  switch (form) {
    case FilterForm::published:
      return scalar_filter_verdicts<portable::PublishedFilter, Real>;
    case FilterForm::reduced:
      return scalar_filter_verdicts<portable::ReducedFilter, Real>;
  }
  return nullptr;
}
}  // namespace

template <class Real>
Implementation<Real> filter_implementation(FilterForm form, std::string_view target) {
  static const SimdTable<FilterForms> table([] { return HWY_DYNAMIC_DISPATCH(filter_forms)(); });
  if (target == scalar_target) return {.verdicts = on_scalar<Real>(form)};
  return {.verdicts = table.on(target).of<Real>()[form]};
}
template Implementation<float> filter_implementation<float>(FilterForm, std::string_view);
template Implementation<double> filter_implementation<double>(FilterForm, std::string_view);

}  // namespace axiscert
#endif

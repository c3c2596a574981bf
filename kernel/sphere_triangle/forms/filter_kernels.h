// The filters as kernels of the registry, and for one query at a time.
#pragma once

#include <cmath>
#include <concepts>

#include "kernel/kernel.h"
#include "kernel/sphere_triangle/forms/scalar_kernel.h"

// The filter for one query at a time.

namespace axiscert::portable {

// The operations of a number type that kernel/sphere_triangle/forms/filter.h requires.
template <std::floating_point Real>
AXISCERT_INLINE Real magnitude(Real x) {
  return std::fabs(x);
}
template <std::floating_point Real>
AXISCERT_INLINE Real negated(Real x) {
  return -x;
}
template <std::floating_point Real>
AXISCERT_INLINE Real greater_of(Real x, Real y) {
  return x < y ? y : x;
}
template <std::floating_point Real>
AXISCERT_INLINE Real constant_as(Real, Real c) {
  return c;
}
template <std::floating_point Real>
AXISCERT_INLINE bool less(Real x, Real y) {
  return x < y;
}
template <std::floating_point Real>
AXISCERT_INLINE bool at_most(Real x, Real y) {
  return x <= y;
}
AXISCERT_INLINE bool both(bool p, bool q) { return p & q; }
AXISCERT_INLINE bool either(bool p, bool q) { return p | q; }

}  // namespace axiscert::portable

#include "kernel/sphere_triangle/forms/filter.h"

namespace axiscert {

template <class Filter, class Real>
void scalar_filter_verdicts(const QueryColumns<Real>& batch, Verdict* out) {
  for (std::size_t i = 0; i < batch.size; ++i) {
    const Query<Real> q = query_at(batch, i);
    const auto certain =
        portable::filter_answer<Filter, Real>(portable::Problem<Real>{q.a, q.b, q.c, q.p, q.r, Real(0)});
    out[i] = certain.separated ? Verdict::separated : certain.contact ? Verdict::contact : Verdict::undecided;
  }
}

enum class FilterForm : std::uint8_t { published, reduced };
template <>
inline constexpr std::size_t enum_count<FilterForm> = 2;

// `target` is one of available_targets(). The kernels give only verdicts: `separated`, `contact` or `undecided`.
template <class Real>
Implementation<Real> filter_implementation(FilterForm form, std::string_view target);

}  // namespace axiscert

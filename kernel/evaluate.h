// One query through the formulae over any number type: the sides, and the bits they decide.
#pragma once

#include <array>

#include "kernel/query.h"

namespace axiscert {

template <class T>
struct Sides {
  std::array<T, comparison_count> lhs, rhs;
};

// The published formulae of a problem already centred. `zero` is the number type's zero.
template <class T>
Sides<T> published_sides(const portable::Centred<T>& centred, const T& zero) {
  Sides<T> sides;
  portable::published_comparisons(centred, zero, [&](Comparison which, const T& lhs, const T& rhs) {
    sides.lhs[static_cast<std::size_t>(which)] = lhs;
    sides.rhs[static_cast<std::size_t>(which)] = rhs;
  });
  return sides;
}

// A query in another number type, its centre moved to the origin there. `convert` is exact in every use.
template <class T, class Real, class Convert>
portable::Centred<T> centred_as(const Query<Real>& q, Convert&& convert) {
  const auto vec = [&](const Vec3<Real>& v) { return Vec3<T>{convert(v.x), convert(v.y), convert(v.z)}; };
  return portable::centred(vec(q.a), vec(q.b), vec(q.c), vec(q.p), T(convert(q.r)));
}

// The published formulae, the translation to the sphere's centre included, all in the number type T.
template <class T, class Real, class Convert>
Sides<T> published_sides(const Query<Real>& q, Convert&& convert) {
  return published_sides(centred_as<T>(q, convert), T(convert(Real(0))));
}

// The bits of evaluated sides. A NaN side makes its comparison false, as in the kernels.
template <class T>
ComparisonBits bits_of(const Sides<T>& sides, Strictness strictness) {
  ComparisonBits bits = 0;
  for (std::size_t i = 0; i < comparison_count; ++i) {
    const bool nonstrict = strictness == Strictness::nonstrict && !comparisons[i].is_radius;
    const bool holds = nonstrict ? sides.lhs[i] >= sides.rhs[i] : sides.lhs[i] > sides.rhs[i];
    if (holds) bits |= static_cast<ComparisonBits>(1u << i);
  }
  return bits;
}

}  // namespace axiscert

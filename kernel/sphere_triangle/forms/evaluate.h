// Evaluation of one query by a set of formulae over any number type: the sides, the bits that they decide, the verdict.
#pragma once

#include "kernel/sphere_triangle/query.h"
#include "kernel/sphere_triangle/formulae.h"

namespace axiscert {

// A query in another number type. `convert` is exact in every use.
template <class T, class Real, class Convert>
portable::Problem<T> problem_as(const Query<Real>& q, Convert&& convert) {
  const auto vec = [&](const Vec3<Real>& v) { return Vec3<T>{convert(v.x), convert(v.y), convert(v.z)}; };
  return {vec(q.a), vec(q.b), vec(q.c), vec(q.p), T(convert(q.r)), T(convert(Real(0)))};
}

// The query in that number type, with its centre moved to the origin there.
template <class T, class Real, class Convert>
portable::CentredProblem<T> centred_as(const Query<Real>& q, Convert&& convert) {
  return portable::centred(problem_as<T>(q, convert));
}

template <class F, class T>
Sides<T> sides_of(const portable::Problem<T>& problem) {
  Sides<T> sides;
  F::comparisons(problem, [&](Comparison which, const T& lhs, const T& rhs) {
    sides.lhs[which] = lhs;
    sides.rhs[which] = rhs;
  });
  return sides;
}

// The published sides of a problem that is already centred. `zero` is the number type's zero.
template <class T>
Sides<T> published_sides(const portable::CentredProblem<T>& centred, const T& zero) {
  Sides<T> sides;
  portable::published_comparisons(centred, zero, [&](Comparison which, const T& lhs, const T& rhs) {
    sides.lhs[which] = lhs;
    sides.rhs[which] = rhs;
  });
  return sides;
}

// The bits of evaluated sides. A comparison with a NaN side is false, except a side comparison under `not_less`.
template <class T>
ComparisonBits bits_of(const Sides<T>& sides, Strictness strictness) {
  ComparisonBits bits = 0;
  for (const Comparison c : enumerators<Comparison>) {
    if (holds(strictness, c, sides.lhs[c], sides.rhs[c])) bits |= one_bit<ComparisonBits>(c);
  }
  return bits;
}

// Also writes the sides to `sides` if that is not null and the formulae have comparisons.
template <class F, class T>
Outcome outcome_of(const portable::Problem<T>& problem, Strictness strictness, Sides<T>* sides = nullptr) {
  if constexpr (requires { F::separated(problem); }) {
    return {F::separated(problem) ? Verdict::separated : Verdict::contact, std::nullopt};
  } else {
    const Sides<T> found = sides_of<F>(problem);
    if (sides) *sides = found;
    return outcome_of(bits_of(found, strictness));
  }
}

}  // namespace axiscert

// The exact sides of a query's formulae, and the truth that was checked against them.
#pragma once

#include <optional>

#include "exact/judge/exact_sides.h"
#include "exact/judge/judge.h"
#include "exact/numbers/surd.h"
#include "kernel/formulae_list.h"
#include "kernel/sphere_triangle/forms/evaluate.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
// The area of a query's triangle, exactly.

// (B - A) x (C - A), whose length is twice the area. The coordinates must be finite.
template <class Real>
Vec3<BinaryNumber> exact_normal(const Query<Real>& q) {
  const auto vec = [](const Vec3<Real>& v) {
    return Vec3<BinaryNumber>{BinaryNumber(double(v.x)), BinaryNumber(double(v.y)), BinaryNumber(double(v.z))};
  };
  const Vec3<BinaryNumber> a = vec(q.a);
  return portable::cross(vec(q.b) - a, vec(q.c) - a);
}

// Formula truth E: a kernel's own formulae in exact arithmetic.

// The sides of a valid query (finite, r >= 0). Requires that `formulae` have comparisons.
template <class Real>
ExactSides exact_sides(Formulae formulae, const Query<Real>& q);

// The sides of the published formulae.
template <class Real>
ExactSides exact_sides(const Query<Real>& q) {
  return exact_sides(Formulae::published, q);
}
// The published sides of a problem that is already centred, for code that solves on a boundary or scales a lattice.
ExactSides exact_sides(const portable::CentredProblem<BinaryNumber>& centred);

// The verdict of a method, which has no comparisons.
template <class Real>
Verdict exact_verdict(Formulae method, const Query<Real>& q);

// The truth with the exact sides against which it was checked; without them if the verdict is `invalid`.
struct ExactTruth : Truth {
  std::optional<ExactSides> sides;  // of the published formulae
};

}  // namespace axiscert

// One query of the predicate sphere against triangle: its numbers with names, the sides that its formulae compare, and
// the predicate's description.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "kernel/base/geometry.h"
#include "kernel/outcome.h"
#include "kernel/query.h"
#include "kernel/sphere_triangle/names.h"

namespace axiscert {
using portable::Vec3;

inline constexpr std::size_t coordinate_count = 13;

// A sphere (centre p, radius r) and a triangle abc. Units are the caller's; r >= 0, and -0 is valid.
template <class Real>
struct Query {
  Vec3<Real> a, b, c, p;
  Real r;

  // Precondition: there are thirteen numbers.
  static Query from(const Numbers<Real>& v) {
    return {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}, {v[6], v[7], v[8]}, {v[9], v[10], v[11]}, v[12]};
  }
  operator Numbers<Real>() const { return {a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, p.x, p.y, p.z, r}; }
};

// The query that these numbers are, where no declaration says its type.
template <class Real>
Query<Real> query_from(const Numbers<Real>& numbers) {
  return Query<Real>::from(numbers);
}

// The thirteen numbers in the order of every column, file and digest: ax ay az bx by bz cx cy cz px py pz r.
template <class Real>
constexpr std::array<Real, coordinate_count> coordinates(const Query<Real>& q) {
  return {q.a.x, q.a.y, q.a.z, q.b.x, q.b.y, q.b.z, q.c.x, q.c.y, q.c.z, q.p.x, q.p.y, q.p.z, q.r};
}
template <class Real>
constexpr Query<Real> from_coordinates(const std::array<Real, coordinate_count>& v) {
  return {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}, {v[6], v[7], v[8]}, {v[9], v[10], v[11]}, v[12]};
}
inline constexpr std::array<const char*, coordinate_count> coordinate_names = {"ax", "ay", "az", "bx", "by", "bz", "cx",
                                                                               "cy", "cz", "px", "py", "pz", "r"};

// The same query in binary64; the conversion is exact.
inline Query<double> widened(const Query<float>& q) {
  const auto vec = [](const Vec3<float>& v) { return Vec3<double>{v.x, v.y, v.z}; };
  return {vec(q.a), vec(q.b), vec(q.c), vec(q.p), q.r};
}
inline const Query<double>& widened(const Query<double>& q) { return q; }

// Finite coordinates and a radius that is finite and not negative. Anything else has the truth `invalid`.
template <class Real>
bool is_valid(const Query<Real>& q) {
  for (const Real v : coordinates(q)) {
    if (!std::isfinite(v)) return false;
  }
  return q.r >= 0;
}

// The sides that sphere-triangle's formulae compare, and the decision that follows from their bits.

// The two sides of every comparison `lhs > rhs`.
template <class T>
struct Sides {
  EnumArray<Comparison, T> lhs, rhs;
};

inline Outcome outcome_of(ComparisonBits bits) { return {verdict_of(axes_of(bits)), bits}; }

// The description of the predicate sphere against triangle.

struct Predicate;  // kernel/predicate.h

const Predicate& sphere_triangle_predicate();

}  // namespace axiscert

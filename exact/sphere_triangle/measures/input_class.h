// The class of a query's input: why a kernel without formulae may be wrong on it, where no link of the chain says so.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "exact/numbers/input_scale.h"
#include "exact/numbers/rational.h"
#include "kernel/base/enums.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
// A query may meet several of these definitions, which docs/error_model.md states too. Its class is the first that it
// meets. All are decided exactly: on the numbers as given, in the maximum norm unless something else is said.
//
// L is the greatest |coordinate of A - P, B - P, C - P| or r, E the greatest |coordinate of B - A, C - B, A - C|.
enum class InputClass : std::uint8_t {
  tie,        // the sphere touches: the distance is exactly r
  near_tie,   // the depth, as reported, is at most 64 u
  scale,      // L or E, where not zero, outside ScaleWindow; or r, where not zero, below ScaleWindow::least_radius
  repeated,   // two of A, B, C are equal
  collinear,  // A, B, C are three points of a line
  sliver,     // the triangle's least height is below 2^-10 of its longest edge (Euclidean lengths)
  far,        // a coordinate of A, B, C or P is at least 64 L: the origin is far away
  ordinary,   // none of these
};
template <>
inline constexpr std::size_t enum_count<InputClass> = 8;
inline constexpr EnumArray<InputClass, std::string_view> input_class_names = {
    "tie", "near_tie", "scale", "repeated", "collinear", "sliver", "far", "ordinary"};
constexpr std::string_view name(InputClass which) { return input_class_names[which]; }
using InputClassSet = EnumSet<InputClass, std::uint8_t>;

// Precondition: the set is not empty.
inline InputClass class_of(InputClassSet meets) { return *meets.begin(); }

inline constexpr int sliver_bits = 10;  // least height over longest edge: 2^-10

// The definitions that a valid query meets, `ordinary` if none. `is_touching`: its distance is exactly r; `depth`: as
// axiscert::depth() gives it.
template <class Real>
InputClassSet input_classes(const Query<Real>& q, bool is_touching, double depth);

// The same from the exact squared distance between P and the triangle.
template <class Real>
InputClassSet input_classes(const Query<Real>& q, const Rational& squared_distance);

// Those from `scale` on, to which the distance from P does not matter; empty if none. `use_filter`: tries enclosures
// before exact arithmetic, with the same result.
template <class Real>
InputClassSet shape_classes(const Query<Real>& q, bool use_filter = true);

// A degenerate query has a triangle without area, or one whose least height is below 2^-10 of its longest edge, or
// lengths outside those for which formulae of degree 6 keep to the normal numbers: `scale`, `repeated`, `collinear` and
// `sliver`. There a kernel may miss by its formulae as much as it likes, and r would have to grow to the size of the
// triangle. Precondition: every number is finite.
template <class Real>
bool is_degenerate(const Query<Real>& q) {
  for (const InputClass which : shape_classes(q)) {
    if (which != InputClass::far) return true;
  }
  return false;
}

// Queries such as an engine asks.

// An engine-like query of sphere-triangle: every number is zero or normal, no |coordinate| is above 2^20, and the
// radius is from 2^-20 to 2^20: from a micrometre to a thousand kilometres where the unit is a metre. A wrong verdict
// on one is counted where its depth is above 16 u; below, it is the rounding of the query's own numbers that decides.
template <class Real>
bool is_engine_like(const Query<Real>& q);
// Makes `all` as long as the queries are many, with 1 for one that is, else 0.
template <class Real>
void find_engine_like(const QueryColumns<Real>& columns, std::vector<std::uint8_t>& all);
template <class Real>
inline constexpr double engine_depth = sizeof(Real) == 4 ? 0x1p-20 : 0x1p-49;  // 16 u

}  // namespace axiscert

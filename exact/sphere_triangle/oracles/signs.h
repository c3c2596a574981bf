// The sixteen exact signs of a query, and the conclusions that the theorem draws from them.
#pragma once

#include <initializer_list>

#include "exact/judge/exact_sides.h"
#include "kernel/sphere_triangle/names.h"

namespace axiscert {

// Signs of the published comparisons in exact arithmetic: lhs > rhs, and lhs == rhs. Bit i is comparison i; no bit is
// set in both.
struct Signs {
  SignBits strict = 0, ties = 0;
  bool operator==(const Signs&) const = default;

  SignBits bits(Strictness strictness) const {
    return static_cast<SignBits>(strict | (ties & nonstrict_comparisons(strictness)));
  }
};

inline Signs signs_of(const ExactSides& published) {
  return {static_cast<SignBits>(published.strict), static_cast<SignBits>(published.ties)};
}

// Non-strict sides decide every triangle, degenerate ones included.
inline Verdict verdict_of(const Signs& signs) { return verdict_of(axes_of(signs.bits(Strictness::nonstrict))); }

// The axes whose normal is the zero vector and which therefore never separate: the plane's where the area is zero, an
// edge's where its ends are one point.
//   A = B iff a.b = a.a and a.b = b.b, since then |A - B|^2 = 0.
//   The three N_i . V are the sides of the edges but for a factor -e_i, and V = N_1 + N_2 + N_3. If all three are ties,
//   each N_i . V = 0 (where e_i = 0, N_i = 0), so V . V = 0; and V = 0 makes them ties.
// A vertex at P needs no such care: its radius comparison 0 > r^2 is a tie only for r = 0.
inline AxisBits axes_without_normal(const Signs& signs) {
  const auto all = [&](std::initializer_list<Comparison> which) {
    for (const Comparison c : which) {
      if (!has_bit(signs.ties, c)) return false;
    }
    return true;
  };
  using enum Comparison;
  const auto bit = [](bool is_zero, Axis axis) { return bit_if<AxisBits>(is_zero, index_of(axis)); };
  return static_cast<AxisBits>(bit(all({edge_ab_side_c, edge_bc_side_a, edge_ca_side_b}), Axis::plane) |
                               bit(all({vertex_a_side_b, vertex_b_side_a}), Axis::edge_ab) |
                               bit(all({vertex_b_side_c, vertex_c_side_b}), Axis::edge_bc) |
                               bit(all({vertex_c_side_a, vertex_a_side_c}), Axis::edge_ca));
}

// Comparisons whose exact sides are both zero, in the published form and in the reduced ones: the radius of an axis
// without a normal, and an edge's side that is a tie, one of whose sides is the constant zero. Other comparisons with
// two zero sides exist and are not reported.
inline SignBits both_sides_zero(const Signs& signs) {
  using enum Comparison;
  const auto bit = [](Comparison c) { return one_bit<SignBits>(c); };
  const auto sides = static_cast<SignBits>(bit(edge_ab_side_c) | bit(edge_bc_side_a) | bit(edge_ca_side_b));
  SignBits zero = signs.ties & sides;
  const AxisBits without = axes_without_normal(signs);
  for (const Comparison radius : {plane_radius, edge_ab_radius, edge_bc_radius, edge_ca_radius}) {
    if (has_bit(without, info(radius).axis)) zero |= bit(radius);
  }
  return zero;
}

// Whether the distance is exactly r, from the signs at r. For r = 0 that is contact. For r > 0 it is contact together
// with an axis that has a normal, whose sides hold or are ties and whose radius comparison is a tie: such an axis has
// all of the triangle at distance r or farther. Conversely, if the distance is r, every r' < r is separated, by one
// axis for infinitely many r' that tend to r. Its sides do not depend on r', lhs > r'^2 (...) holds for these r', so
// its normal is not zero, and in the limit lhs >= rhs.
inline bool is_touching(const Signs& signs, bool radius_is_zero) {
  if (verdict_of(signs) != Verdict::contact) return false;
  if (radius_is_zero) return true;
  const auto held = static_cast<SignBits>(signs.strict | signs.ties);
  return (axes_of(held) & ~axes_without_normal(signs)) != 0;
}

}  // namespace axiscert

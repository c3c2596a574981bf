// The derivation of the certified predicate's thresholds, and the ranges that it holds in. The constants themselves are
// those that Coq has proved, kernel/sphere_triangle/forms/margin_bounds.h.
//
// u is the unit roundoff of the number type, 2^-24 or 2^-53; hats are computed values. Rounding is to nearest with
// gradual underflow (kernel/sphere_triangle/certified/default_modes.h sets both). A fused multiply-add rounds once
// where the derivation counts two roundings, so the thresholds hold with it and without. Terms of u^2 and more, the
// rounding of S, E and of the products with them, and underflow as bounded below are covered by the sixteenth that is
// added last.
//
// A *leaf*, one of A-P, B-P, C-P, B-A, C-B, A-C, is a difference of two inputs: each component is (1 + u) times the
// exact one, whatever the exponents (a subnormal difference is exact). From here A, B, C are the translated vertices,
//   S = A.A + B.B + C.C + r^2,   e1 = |AB|^2, e2 = |BC|^2, e3 = |CA|^2,   E = e1 + e2 + e3,   e1 <= 2/3 E (and so on),
//   N1 = A x AB and so on,   V = AB x AC,   |V| <= w = |AB| |CA| <= E / 2,   d = A.V.
// The margins are those of the reduced form, whose signs are the published ones on every query
// (kernel/sphere_triangle/forms/reduced.h).
//
// The coarse step: one threshold for the margins of each degree, from the query's magnitude S and the triangle's E.
//   x.x           two leaves, a product, two sums                 5 u x.x
//   vertex.radius A.A - rr                                        5 u A.A + 2 u rr + u (A.A + rr)        <= 6 u S
//   vertex.side   2 A.AB = (B.B - A.A) - e1                       7 u (A.A + B.B) + 6 u e1, e1 <= 2 (A.A + B.B)
//                                                                                                       <= 19 u S
//   N, V          the two products of a component are off by 3 u, their difference by u more; and for vectors x, y of
//                 magnitudes the vector of x_i y_j + x_j y_i is at most sqrt 2 |x| |y| long:
//                 |N^ - N| <= nu = 4 sqrt 2 u |A| |AB| < 5.66 u |A| |AB|,   |V^ - V| <= omega = 5.66 u w
//   edge.radius   N.N - rr e: (2 5.66 + 3) u A.A e + 7 u rr e + u (A.A e + rr e) <= 15.4 u S e <= 10.3 u S E
//   edge.side     N.V: (5.66 + 5.66 + 3) u |A| |AB| w, |A| |AB| <= |A| (|A| + |B|) <= 1.21 S, w <= E / 2
//                                                                                                       <= 8.7 u S E
//   d             (4 + 5.66) u |A| w
//   plane.radius  d^2 - rr V.V: (2 9.66 + 1) u A.A w^2 + (2 5.66 + 3 + 2) u rr w^2 + u (A.A + rr) w^2
//                                                                  <= 21.4 u S w^2 <= 5.4 u S E^2
//
// Range of the coarse step: S^ in [least_square, greatest_square], and E + 2^-20 S in place of E. Overflow: e <= 4 S /
// 2, every value is at most 16 S^3 <= 2^118 (binary64: 2^904); proofs/coq/certified/CoarseFloat.v has it to the bit.
// Underflow: a product, fused or not, errs by eta = 2^-150 (2^-1075) more. |N| <= 1.5 S, |V| <= 2 S, |d| <= 2 S^1.5; N
// and V are off by 4 eta more, d by 4 |A| eta + 3 eta. So at degree 2: 3 eta; 4: 16 S eta + 3 eta; 6: 18 S^2 eta + 16
// S^1.5 eta + 3 S eta + 2 eta. The thresholds are at least 2^-20 S, 2^-40.4 S^2 and 2^-61.4 S^3 in binary32, 2^-49 S,
// 2^-69.4 S^2, 2^-90.4 S^3 in binary64: with S >= 2^-21 (2^-300) the worst of these terms is below 2^-24 of its
// threshold, and every threshold is a normal number.
//
// The fine step is evaluated in doubles, the deep one in pairs of them, with a bound for each margin from the leaves of
// its own: exact/sphere_triangle/oracles/margins-inl.h derives it, where |x|o is the greatest component of a leaf and
// |x|1 the sum of three.
#pragma once

#include "kernel/sphere_triangle/forms/margin_bounds.h"

namespace axiscert::certified {

template <class Real>
inline constexpr Real unit_roundoff = sizeof(Real) == 4 ? static_cast<Real>(0x1p-24) : static_cast<Real>(0x1p-53);

inline constexpr double least_relative_triangle = 0x1p-20;  // in units of S; added to E
template <class Real>
inline constexpr Real least_square = sizeof(Real) == 4 ? static_cast<Real>(filter::CoarseBounds::least_square_binary32)
                                                       : static_cast<Real>(filter::CoarseBounds::least_square_binary64);
template <class Real>
inline constexpr Real greatest_square =
    sizeof(Real) == 4 ? static_cast<Real>(filter::CoarseBounds::greatest_square_binary32)
                      : static_cast<Real>(filter::CoarseBounds::greatest_square_binary64);

// binary64 in doubles, and all in pairs: a leaf and the radius are zero or in [2^-100, 2^100], so that underflow is
// below 2^-200 of a bound; binary32 in doubles needs no such guard (margins-inl.h there).
inline constexpr double least_fine_leaf = 0x1p-100, greatest_fine_leaf = 0x1p100;

}  // namespace axiscert::certified

// The numbers beside the verdict: how far apart, which part of the triangle is nearest, where, and in which direction.
//
// Three steps. The quick one is of binary32 alone: signs in floats, numbers in doubles. The next takes what that is not
// certain of, and binary64, all in doubles (both contact_step-inl.h: one query a lane, no operation fused, so that the
// bits are the same on every instruction set). A query whose feature or accuracy it is not certain of goes to the last
// (exact_contact.h), whose signs are those of integers. All keep the bounds below. What lacks its verdict alone goes
// to the steps of certified.h. Where a separation has not the sign of its verdict, it is moved to 0 or the least number
// on that side, which is nearer to the exact one.
//
// u is the unit roundoff of the input's type, 2^-24 or 2^-53, M = max(|A-P|, |B-P|, |C-P|, r):
//                binary32                        binary64
//   separation   u |d - r| + 2^-13 u M           16 u M
//   normal       (1 + 2^-9) u                    12 u               the length of the difference of the vectors
//   point        u |point| + 2^-12 u M           u |point| + 14 u M likewise; a vertex is given as it stands
// and the least subnormal number for each component. A separation beyond the greatest number is infinite.
//
// Why doubles keep them. v = 2^-53. Q is the vertex, or the first end of the edge, or A; b = Q - P, |b| <= M; y
// is along the edge, V = AB x AC; w leads from P to the nearest point: d = |w|, normal = -w / |w|, point = P + w. A
// component of a difference is (1 + v) times the exact one.
//   vertex    w = b: v d;  |w|: w.w and the root 2.5 v more                                    |w|: 3.5 v d
// binary32, V off by D |V|, D = 5.66 v |AB| |AC| / |V| (thresholds.h); V.V >= 2^-24 AB.AB AC.AC makes it 2^-38.4:
//   edge      w = b - y (b.y / y.y): b.y 5 v |b| |y|, y.y 5 v, the quotient, the product and y 3 v of at most |b|; b v,
//             the difference v d: 15 v |b|; d >= 2^-15 |b| (asked as 2^-15 sqrt S) makes it 2^-33.6 d
//   face      w = V (b.V / V.V): b.V (4 v + D) |b| |V|; V.V 3 v and its D, with V's own one in all; two products and a
//             division 3 v: (10 v + 2 D) |b|                                                   |w|: (12.5 v + 2 D) |b|
// binary64, with N = x cross y off by D |N|, x = b or, for the face, x, y = AB, AC and N = V: differences with their
// errors, exact products, 17 v^2 (|x_i y_j| + |x_j y_i|) for all low parts and what is left out, the rounding of the
// sum: D = v + 24 v^2 |x| |y| / |N|; N.N >= 2^-60 x.x y.y makes it 1.01 v:
//   edge      w = (y x N) / y.y: y x N 1 + 2.83 v and D, y.y 5 v, 1 / y.y and its product 2 v: 11.9 v d
//                                                                                              |w|: 14.4 v d
//   face      as above with this D: 12.1 v |b|                                                 |w|: 14.6 v |b|
// So d^ is off by at most 15 v |b|, in binary32 2^-37.3 |b|, and |b|^2 <= 2 S (S below): the step is certain of the
// verdict, and of the side of the face, where (d^ - r)^2 and w.w exceed 512 v^2 S, in binary32 2^-73 S. The difference
// d^ - r rounds once more. The normal has the error of w's direction, in binary64 4.9 v + D (edge), D + v (face), v
// (vertex), and 5.5 v for its length and the factor's rounding; the point has w's error and its own rounding.
//
// Signs: S = A'.A' + E, E = AB.AB + AC.AC, with A' = A - P and so on, g1 = A'.AB, g2 = A'.AC, f = AB.AC:
//   dots       two differences, a product, two sums: 5 v |x| |y|, |x| |y| <= (x.x + y.y) / 2
//   B'.AB      g1 + AB.AB: 2.5 v S + 5 v E + v (1.5 S), and so on
//   BC.B'      (g1 + AB.AB) - (g2 + f): (5 + 2.5 + 5) v S and 3 v of at most 3 S; of 24 v S allowed
//   AB's N.V   g1 f - AB.AB g2: 11 v of each product, at most S / 2 E / 2, and v of each: 6 v S E; likewise CA's
//   BC's       AB.AB AC.AC - f^2 less these two: 6 v E^2, 12 v S E, three sums 3 v S E; of 24 v S E allowed
// The rest is for terms of v^2 and the roundings of S and E.
//
// The quick step has these signs with v = 2^-24, where E >= 2^-50 and S <= 2^60. Nothing overflows: S E <= 2^120. A
// product that underflows errs by 2^-150: at degree 2 less than 2^-146 in all, below 2^-70 of 24 v S; at degree 4 less
// than 2^-146 S + 2^-146, below 2^-26 of 24 v S E >= 2^-70 S and 2^-119.5. Its numbers are those of the doubles. Where
// it is certain of the face, V.V = AB.AB AC.AC - f^2, the sum of what BC, AB and CA are beyond by, is more than 3 times
// 2.9 v S E >= 34 v AB.AB AC.AC > 2^-24 AB.AB AC.AC. w.w and d^ - r are rounded to floats, by less than the 2^0.6 that
// 2^-73 S has above what is needed; it is at least 2^-123, so d^ - r is not 0 as a float.
//
// Range. What is widened from binary32 neither overflows nor underflows: nonzero values of degree 4 are between 2^-596
// and 2^530. In binary64 E >= 2^-300, S <= 2^240 and N.N >= 2^-500 are asked: then a product that underflows errs by
// 2^-1074, below v^4 of each threshold; a component of N below 2^-600 counts as 0, less than 2^-350 of |N|, so that no
// bit depends on whether a low part that underflowed was fused.
//
// Which part is nearest, as Coq has accepted it (proofs/coq/numbers/NearestPart.v). A point F of a convex set is the
// nearest to P iff (P - F).(X - F) <= 0 for each corner X. So, on every triangle, those without area too:
//   vertex A     A'.AB >= 0 and A'.AC >= 0
//   edge AB      A'.AB < 0 < B'.AB, so that the foot F is between A and B; and N.V <= 0, N = A' x AB, which is
//                g1 f - AB.AB g2 = -|AB|^2 (F - P).AC: nearest iff C is not on P's side of F
//   face         otherwise: V is not 0 then
// The answer is the part of the least dimension that holds the nearest point; among several, where vertices coincide or
// edges overlap, the first of A, B, C, AB, BC, CA.
#pragma once

#include <cstddef>
#include <cstdint>

#include "kernel/sphere_triangle/certified/steps.h"

namespace axiscert::certified {

struct ContactBounds {
  static constexpr double side_2 = 24, side_4 = 24;                    // of v S, of v S E
  static constexpr double certain_32 = 0x1p-73, certain_64 = 0x1p-97;  // the squares of |d - r| and of d, of S
  static constexpr double least_normal_32 = 0x1p-24, least_normal_64 = 0x1p-60;      // N.N, of x.x y.y
  static constexpr double least_shown_32 = 0x1p-298;                                 // the square of the least float
  static constexpr double least_edge_32 = 0x1p-30;                                   // the square of d, of S
  static constexpr double least_triangle_32 = 0x1p-50, greatest_square_32 = 0x1p60;  // of signs in floats
  // Those of binary64 alone.
  static constexpr double least_triangle = 0x1p-300, greatest_square = 0x1p240, least_normal = 0x1p-500,
                          negligible_component = 0x1p-600;
};

// Where a block's numbers go; no pointer is null, and each has room for the block.
template <class Real>
struct ContactColumns {
  Real* separation;
  Real* normal[3];
  Real* point[3];
};

// Bits as in Answer. The feature of query i has bit i of each plane as a binary digit, the lowest first: 0, 1, 2 vertex
// A, B, C, 3, 4, 5 edge AB, BC, CA, 6 the face, 7 none (invalid).
template <std::size_t most>
struct ContactAnswer : Answer<most> {
  std::uint64_t feature[3][most / 64];
  std::uint64_t no_normal[most / 64];
};
using BlockContacts = ContactAnswer<block_size>;

// The steps on one instruction set, or integers alone; the caller has to set the modes of default_modes.h. Of a
// block with one sphere the last four columns have one entry.
template <class Real>
using DecideContacts = void (*)(const Block<Real>&, Question, const ContactColumns<Real>&, BlockContacts&) noexcept;
struct ContactForms {
  DecideContacts<float> block32;
  DecideContacts<double> block64;
  DecideContacts<float> one32;  // one query at a time
  DecideContacts<double> one64;

  template <class Real>
  DecideContacts<Real> block() const noexcept {
    if constexpr (sizeof(Real) == 4) return block32;
    else return block64;
  }
  template <class Real>
  DecideContacts<Real> one() const noexcept {
    if constexpr (sizeof(Real) == 4) return one32;
    else return one64;
  }
};
ContactForms chosen_contact_forms();
const ContactForms& exact_contact_forms() noexcept;

// The digits of the planes as bytes.
void write_features(const BlockContacts& answer, std::size_t size, std::uint8_t* out) noexcept;
// 1 where the normal exists.
void write_has_normal(const BlockContacts& answer, std::size_t size, std::uint8_t* out) noexcept;

}  // namespace axiscert::certified

// Parts of the families of two boxes: rotations by quaternions of integers, which are exact over the rationals and
// rounded once for the entry; places that are solved exactly; and steps of an ulp.
//
// A family is a type with `template <class Pair> static Pair make(Stream&, std::uint64_t position)`, where Pair is
// BoxPair<Real> (entry `matrix`) or TurnedPair<Real> (entry `quaternion`); those of the other entries make CornersPair
// or MixedPair alone.
#pragma once

#include <array>
#include <cmath>

#include "exact/boxes/measures.h"
#include "fuzz/boxes/situations.h"
#include "fuzz/queries/family.h"
#include "fuzz/queries/floats.h"
#include "fuzz/queries/random.h"
#include "kernel/boxes/turned.h"

namespace axiscert::boxes {

template <class Pair>
struct RealOfPair;
template <template <class> class Form, class Real>
struct RealOfPair<Form<Real>> {
  using type = Real;
};
template <class Pair>
using RealOf = typename RealOfPair<Pair>::type;

// w, x, y, z: integers whose products by M(q) are exact as rationals, not all 0.
using Quaternion = std::array<double, 4>;

// In that order of operations: exact of integers, and of others the same bits everywhere.
template <class Real>
std::array<Real, 4> product(const std::array<Real, 4>& p, const std::array<Real, 4>& q) {
  return {p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3], p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
          p[0] * q[2] - p[1] * q[3] + p[2] * q[0] + p[3] * q[1], p[0] * q[3] + p[1] * q[2] - p[2] * q[1] + p[3] * q[0]};
}
// Up to 3000 in magnitude.
Quaternion random_turn(Stream& random);
// The columns of the rotation, exactly.
std::array<Point, 3> exact_axes(const Quaternion& q);

// The numbers of a query taken as exact.
template <class Pair>
ExactPair exactly(const Pair& q);

// Turns a box: each entry of its matrix is the float nearest to the exact rotation's; or the quaternion's four numbers,
// each rounded.
template <class Real>
void turn(OrientedBox<Real>& box, const Quaternion& q) {
  const std::array<Point, 3> exact = exact_axes(q);
  for (std::size_t k = 0; k < 3; ++k) {
    box.axis[k] = {nearest<Real>(exact[k].x), nearest<Real>(exact[k].y), nearest<Real>(exact[k].z)};
  }
}
template <class Real>
void turn(TurnedBox<Real>& box, const Quaternion& q) {
  for (std::size_t k = 0; k < 4; ++k) box.q[k] = static_cast<Real>(q[k]);
}

// Quarter turns alone: of matrices the 48 signed permutations, of quaternions the 24 whose length squared is 1, 2 or 4,
// so that a matrix made of one is exact.
template <class Real>
void turn_by_quarters(Stream& random, OrientedBox<Real>& box) {
  std::array<std::size_t, 3> order = {0, 1, 2};
  const auto first = random.below(3);
  std::swap(order[0], order[first]);
  if (random.coin()) std::swap(order[1], order[2]);
  for (std::size_t k = 0; k < 3; ++k) {
    const Real one = random.coin() ? Real(1) : Real(-1);
    box.axis[k] = {order[k] == 0 ? one : Real(0), order[k] == 1 ? one : Real(0), order[k] == 2 ? one : Real(0)};
  }
}
template <class Real>
void turn_by_quarters(Stream& random, TurnedBox<Real>& box) {
  static constexpr std::array<Quaternion, 3> kinds = {{{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 1, 1, 1}}};
  const Quaternion& kind = kinds[random.below(3)];
  std::array<std::size_t, 4> order = {0, 1, 2, 3};
  for (std::size_t k = 3; k > 0; --k) {
    const auto other = random.below(k + 1);
    std::swap(order[k], order[other]);
  }
  for (std::size_t k = 0; k < 4; ++k) {
    box.q[k] = static_cast<Real>(random.coin() ? kind[order[k]] : -kind[order[k]]);
  }
}

// The same by another route: the matrix is computed in Real.
template <class Real>
void turn_in_floats(TurnedBox<Real>& box, const Quaternion& q) {
  turn(box, q);
}
template <class Real>
void turn_in_floats(OrientedBox<Real>& box, const Quaternion& q) {
  TurnedBox<Real> given{};
  turn(given, q);
  box.axis = with_matrix(given).axis;
}

template <class Real>
Point exact_point(const Vec3<Real>& p) {
  return {exact(p.x), exact(p.y), exact(p.z)};
}
template <class Real>
Vec3<Real> rounded_point(const Point& p) {
  return {nearest<Real>(p.x), nearest<Real>(p.y), nearest<Real>(p.z)};
}

// The same in doubles, of what is proposed and not solved.
using Arrow = Vec3<double>;

template <class Real>
Arrow arrow_of(const Vec3<Real>& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}
template <class Real>
Vec3<Real> rounded_arrow(const Arrow& v) {
  return {static_cast<Real>(v.x), static_cast<Real>(v.y), static_cast<Real>(v.z)};
}

// A box in doubles, by its matrix in either entry.
template <class Real>
OrientedBox<double> box_in_doubles(const OrientedBox<Real>& box) {
  OrientedBox<double> wide{arrow_of(box.centre), {}, {}};
  for (std::size_t k = 0; k < 3; ++k) {
    wide.half[k] = static_cast<double>(box.half[k]);
    wide.axis[k] = arrow_of(box.axis[k]);
  }
  return wide;
}
template <class Real>
OrientedBox<double> box_in_doubles(const TurnedBox<Real>& box) {
  TurnedBox<double> wide{arrow_of(box.centre), {}, {}};
  for (std::size_t k = 0; k < 3; ++k) wide.half[k] = static_cast<double>(box.half[k]);
  for (std::size_t k = 0; k < 4; ++k) wide.q[k] = static_cast<double>(box.q[k]);
  return with_matrix(wide);
}

// An offset of B in A's frame: a multiple of 2^-23 from -most to most.
inline Rational offset(Stream& random, const Rational& most) {
  Rational x(random.integer(-(1 << 23), 1 << 23), 1 << 23);
  x.canonicalize();
  return x * most;
}

// B's centre at A's plus the vector, which is turned exactly and rounded once.
template <class Pair>
void place(Pair& q, const Quaternion& frame, const std::array<Rational, 3>& at) {
  const std::array<Point, 3> axes = exact_axes(frame);
  Point sum = exact_point(q.a.centre);
  for (std::size_t k = 0; k < 3; ++k) sum = sum + axes[k] * at[k];
  q.b.centre = rounded_point<RealOf<Pair>>(sum);
}

// Half extents from 0.5 to 1.5 of both, A's centre at 0 every other time, else in the unit cube.
template <class Pair>
Pair of_ordinary_size(Stream& random, std::uint64_t position) {
  using Real = RealOf<Pair>;
  Pair q{};
  for (auto* half : {&q.a.half, &q.b.half}) {
    for (Real& s : *half) s = Real(0.5) + random.unit<Real>();
  }
  const Real x = random.symmetric<Real>(), y = random.symmetric<Real>(), z = random.symmetric<Real>();
  if (position % 2 == 1) q.a.centre = {x, y, z};
  return q;
}

// B's centre within 2 of A's on each axis.
template <class Pair>
void place_beside(Stream& random, Pair& q) {
  using Real = RealOf<Pair>;
  const Real x = random.symmetric<Real>(), y = random.symmetric<Real>(), z = random.symmetric<Real>();
  q.b.centre = q.a.centre + Vec3<Real>{x + x, y + y, z + z};
}

// The greatest integer of a query of small integers: 2, 5 or 40 in turn.
inline std::int64_t lattice_bound(std::uint64_t position) {
  return std::array<std::int64_t, 3>{2, 5, 40}[position % 3];
}

template <class Real>
void scale_by_power(Vec3<Real>& v, int power) {
  for (Real* x : {&v.x, &v.y, &v.z}) *x = std::ldexp(*x, power);
}
// A box in another unit of length; its axes or quaternion stay.
template <class Box>
void scale_by_power(Box& box, int power) {
  scale_by_power(box.centre, power);
  for (auto& s : box.half) s = std::ldexp(s, power);
}

// Ordinary boxes, each turned by any rotation, the centres up to 2 apart in each coordinate.
template <class Pair>
Pair anywhere(Stream& random, std::uint64_t position) {
  Pair q = of_ordinary_size<Pair>(random, position);
  turn(q.a, random_turn(random));
  turn(q.b, random_turn(random));
  place_beside(random, q);
  return q;
}

// Each coordinate of B's centre moved by up to `most` ulps.
template <class Pair>
void nudge(Stream& random, int most, Pair& q) {
  for (auto* x : {&q.b.centre.x, &q.b.centre.y, &q.b.centre.z}) {
    *x = step_ulps(*x, static_cast<int>(random.integer(-most, most)));
  }
}

// B on the ray from A's centre to its own, at `times` the farthest distance of contact: exactly, then rounded. A query
// whose centres are in one place stays as it is.
template <class Pair>
void solve_tangent(Pair& q, const Rational& times = 1) {
  const ExactPair exact = exactly(q);
  const Point u = exact.b.centre - exact.a.centre;
  if (u.x == 0 && u.y == 0 && u.z == 0) return;
  const Rational factor = critical_factor(exact, u) * times;
  q.b.centre = rounded_point<RealOf<Pair>>(exact.a.centre + u * factor);
}

// The query in the order of the columns.
template <class Made, class Pair>
Numbers<RealOf<Pair>> numbers_by(Stream& random, std::uint64_t position) {
  return numbers_of(Made::template make<Pair>(random, position));
}

// The family in an entry of either predicate. The version changes with the queries of `Made`.
template <class Made, class Entry, std::uint32_t version = 1>
constexpr Family family_in_entry(std::string_view name, const Situation& situation, std::string_view purpose,
                                 bool exact_arithmetic = false) {
  return {.predicate = Entry::description,
          .name = name,
          .purpose = purpose,
          .version = version,
          .exact_arithmetic = exact_arithmetic,
          .binary32 = fill_one_by_one<numbers_by<Made, typename Entry::template Problem<float>>, float>,
          .binary64 = fill_one_by_one<numbers_by<Made, typename Entry::template Problem<double>>, double>,
          .situation = &situation,
          .entry = Entry::entry};
}
// That of matrices, and that of quaternions.
template <class Made, std::uint32_t version = 1>
constexpr Family matrix_family(std::string_view name, const Situation& situation, std::string_view purpose,
                               bool exact_arithmetic = false) {
  return family_in_entry<Made, MatrixBoxes, version>(name, situation, purpose, exact_arithmetic);
}
template <class Made, std::uint32_t version = 1>
constexpr Family turned_family(std::string_view name, const Situation& situation, std::string_view purpose,
                               bool exact_arithmetic = false) {
  return family_in_entry<Made, QuaternionBoxes, version>(name, situation, purpose, exact_arithmetic);
}

}  // namespace axiscert::boxes

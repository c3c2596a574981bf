// Parts of the families of a box and a triangle: a box in each of the four entries, and a family of queries of one.
#pragma once

#include "fuzz/boxes/parts.h"
#include "kernel/boxes/box_triangle.h"

namespace axiscert::boxes {

// A query of any entry in doubles.
template <class Real>
std::array<Arrow, 3> corners_in_doubles(const std::array<Vec3<Real>, 3>& corner) {
  return {arrow_of(corner[0]), arrow_of(corner[1]), arrow_of(corner[2])};
}
template <class Real>
BoxAndTriangle<double> wide_query(const BoxAndTriangle<Real>& q) {
  return {box_in_doubles(q.box), corners_in_doubles(q.corner)};
}
template <class Real>
BoxAndTriangle<double> wide_query(const TurnedAndTriangle<Real>& q) {
  return {box_in_doubles(q.box), corners_in_doubles(q.corner)};
}
template <class Real>
BoxAndTriangle<double> wide_query(const CentredAndTriangle<Real>& q) {
  const Arrow half = arrow_of(Vec3<Real>{q.half[0], q.half[1], q.half[2]});
  return oriented(
      CentredAndTriangle<double>{arrow_of(q.centre), {half.x, half.y, half.z}, corners_in_doubles(q.corner)});
}
template <class Real>
BoxAndTriangle<double> wide_query(const CornersAndTriangle<Real>& q) {
  return oriented(CornersAndTriangle<double>{arrow_of(q.low), arrow_of(q.high), corners_in_doubles(q.corner)});
}

template <class Real>
Vec3<Real> point_in_cube(Stream& random) {
  const Real x = random.symmetric<Real>(), y = random.symmetric<Real>(), z = random.symmetric<Real>();
  return {x, y, z};
}
template <class Real>
Vec3<Real> extents(Stream& random) {
  const Real x = random.unit<Real>(), y = random.unit<Real>(), z = random.unit<Real>();
  return {Real(0.5) + x, Real(0.5) + y, Real(0.5) + z};
}

// A box of half extents 0.5 to 1.5 in each of the forms.
template <class Real>
void put_box(Stream& random, CentredAndTriangle<Real>& q) {
  q.centre = point_in_cube<Real>(random);
  const Vec3<Real> half = extents<Real>(random);
  q.half = {half.x, half.y, half.z};
}
template <class Real>
void put_box(Stream& random, CornersAndTriangle<Real>& q) {
  q.low = point_in_cube<Real>(random);
  const Vec3<Real> half = extents<Real>(random);
  q.high = q.low + half + half;
}
template <class Query>
void put_box(Stream& random, Query& q) {
  CentredAndTriangle<RealOf<Query>> given;
  put_box(random, given);
  q.box.centre = given.centre;
  q.box.half = given.half;
  turn(q.box, random_turn(random));
}

// A query in another unit of length.
template <class Query>
void scale_query(Query& q, int power) {
  if constexpr (requires { q.box; }) {
    scale_by_power(q.box, power);
  } else if constexpr (requires { q.low; }) {
    scale_by_power(q.low, power);
    scale_by_power(q.high, power);
  } else {
    scale_by_power(q, power);
  }
  for (auto& corner : q.corner) scale_by_power(corner, power);
}

template <class Made, class Entry>
constexpr Family triangle_family(std::string_view name, const Situation& situation, std::string_view purpose,
                                 bool exact_arithmetic = false, int version = 1) {
  Family family = family_in_entry<Made, Entry>(name, situation, purpose, exact_arithmetic);
  family.version = version;
  return family;
}

}  // namespace axiscert::boxes

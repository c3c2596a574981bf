// Bodies of a query times one positive factor, which makes their numbers products and sums of the query's: without a
// division. What does not change with the size of a scene can be asked of them.
#pragma once

#include "kernel/boxes/thirteen.h"
#include "kernel/boxes/turned.h"

namespace axiscert::boxes {

template <class T>
struct ExactQuaternion {
  T w;
  Vec3<T> v;
  friend ExactQuaternion operator*(const ExactQuaternion& p, const ExactQuaternion& q) {
    return {p.w * q.w - dot(p.v, q.v), q.v * p.w + p.v * q.w + cross(p.v, q.v)};
  }
};

// Unit vectors turned by q, as Hamilton has it, times `square`, which is |q|^2: e_k becomes q e_k q*. The kernels'
// matrix of a quaternion is not used here.
template <class T>
struct TurnedAxes {
  std::array<Vec3<T>, 3> axis;
  T square;
};
template <class T>
TurnedAxes<T> turned_axes(const std::array<double, 4>& given) {
  const T zero(0.0), one(1.0);
  const ExactQuaternion<T> q{T(given[0]), {T(given[1]), T(given[2]), T(given[3])}};
  const ExactQuaternion<T> conjugate{q.w, {zero - q.v.x, zero - q.v.y, zero - q.v.z}};
  TurnedAxes<T> found{{}, q.w * q.w + dot(q.v, q.v)};
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3<T> unit{k == 0 ? one : zero, k == 1 ? one : zero, k == 2 ? one : zero};
    found.axis[k] = (q * ExactQuaternion<T>{zero, unit} * conjugate).v;
  }
  return found;
}

template <class T>
Vec3<T> each(const Vec3<double>& v) {
  return {T(v.x), T(v.y), T(v.z)};
}
template <class T>
std::array<T, 3> each(const std::array<double, 3>& v) {
  return {{T(v[0]), T(v[1]), T(v[2])}};
}
template <class T>
std::array<Vec3<T>, 3> each(const std::array<Vec3<double>, 3>& v) {
  return {{each<T>(v[0]), each<T>(v[1]), each<T>(v[2])}};
}

// Factor 1.
template <class T>
OrientedBox<T> scaled(const OrientedBox<double>& box) {
  return {each<T>(box.centre), each<T>(box.half), each<T>(box.axis)};
}
template <class T>
BoxPair<T> scaled(const BoxPair<double>& q) {
  return {scaled<T>(q.a), scaled<T>(q.b)};
}
// Factor |q_a|^2 |q_b|^2.
template <class T>
BoxPair<T> scaled(const TurnedPair<double>& q) {
  const TurnedAxes<T> of_a = turned_axes<T>(q.a.q), of_b = turned_axes<T>(q.b.q);
  const T both = of_a.square * of_b.square;
  const auto box = [&](const TurnedBox<double>& given, const TurnedAxes<T>& own, const T& other) {
    return OrientedBox<T>{each<T>(given.centre) * both,
                          each<T>(given.half),
                          {{own.axis[0] * other, own.axis[1] * other, own.axis[2] * other}}};
  };
  return {box(q.a, of_a, of_b.square), box(q.b, of_b, of_a.square)};
}

template <class T>
std::array<Vec3<T>, 3> unit_vectors() {
  const T zero(0.0), one(1.0);
  return {{{one, zero, zero}, {zero, one, zero}, {zero, zero, one}}};
}
// Factor 2: of corners low and high, the centre is low + high and the half extents high - low.
template <class T>
OrientedBox<T> scaled(const CornersBox<double>& box) {
  const Vec3<T> low = each<T>(box.low), high = each<T>(box.high), size = high - low;
  return {low + high, {{size.x, size.y, size.z}}, unit_vectors<T>()};
}
template <class T>
BoxPair<T> scaled(const CornersPair<double>& q) {
  return {scaled<T>(q.a), scaled<T>(q.b)};
}
// Factor 2 |q|^2.
template <class T>
BoxPair<T> scaled(const MixedPair<double>& q) {
  const TurnedAxes<T> turned = turned_axes<T>(q.b.q);
  OrientedBox<T> a = scaled<T>(q.a);
  a.centre = a.centre * turned.square;
  for (T& half : a.half) half = half * turned.square;
  const Vec3<T> centre = each<T>(q.b.centre) * turned.square;
  std::array<T, 3> half = each<T>(q.b.half);
  for (T& x : half) x = x + x;
  return {a, {centre + centre, half, turned.axis}};
}

// Factor 1.
template <class T>
BoxAndTriangle<T> scaled(const BoxAndTriangle<double>& q) {
  return {scaled<T>(q.box), each<T>(q.corner)};
}
template <class T>
BoxAndTriangle<T> scaled(const CentredAndTriangle<double>& q) {
  return {{each<T>(q.centre), each<T>(q.half), unit_vectors<T>()}, each<T>(q.corner)};
}
// Factor 2.
template <class T>
BoxAndTriangle<T> scaled(const CornersAndTriangle<double>& q) {
  const std::array<Vec3<T>, 3> corner = each<T>(q.corner);
  return {scaled<T>(CornersBox<double>{q.low, q.high}),
          {{corner[0] + corner[0], corner[1] + corner[1], corner[2] + corner[2]}}};
}
// Factor |q|^2.
template <class T>
BoxAndTriangle<T> scaled(const TurnedAndTriangle<double>& q) {
  const TurnedAxes<T> turned = turned_axes<T>(q.box.q);
  const std::array<Vec3<T>, 3> corner = each<T>(q.corner);
  return {{each<T>(q.box.centre) * turned.square, each<T>(q.box.half), turned.axis},
          {{corner[0] * turned.square, corner[1] * turned.square, corner[2] * turned.square}}};
}

// Its eight corners, some of them equal where a half extent is 0.
template <class T>
std::vector<Vec3<T>> corners_of(const OrientedBox<T>& box) {
  std::vector<Vec3<T>> corners = {box.centre};
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3<T> edge = box.axis[k] * box.half[k];
    for (std::size_t i = 0, before = corners.size(); i < before; ++i) {
      corners.push_back(corners[i] + edge);
      corners[i] = corners[i] - edge;
    }
  }
  return corners;
}

// The determinant of its axes: 0 where they are dependent, and the numbers are not a box.
template <class T>
T determinant(const OrientedBox<T>& box) {
  return dot(box.axis[0], cross(box.axis[1], box.axis[2]));
}

}  // namespace axiscert::boxes

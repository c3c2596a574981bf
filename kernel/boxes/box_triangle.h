// Queries about a box and a triangle as the formulae see them, in the four ways in which the box can be given.
#pragma once

#include "kernel/boxes/turned.h"

namespace axiscert {

const Predicate& box_triangle_predicate();

namespace boxes {

// A closed box, and the closed triangle of three corners, which may be degenerate.
template <class T>
struct BoxAndTriangle {
  OrientedBox<T> box;
  std::array<Vec3<T>, 3> corner;
};

// A box along the axes; the half extents are not negative.
template <class T>
struct CentredAndTriangle {
  Vec3<T> centre;
  std::array<T, 3> half;
  std::array<Vec3<T>, 3> corner;
};

// A box along the axes from corner `low` to corner `high`, none of whose coordinates is below that of `low`.
template <class T>
struct CornersAndTriangle {
  Vec3<T> low, high;
  std::array<Vec3<T>, 3> corner;
};

// A box turned by a quaternion of any length but 0.
template <class T>
struct TurnedAndTriangle {
  TurnedBox<T> box;
  std::array<Vec3<T>, 3> corner;
};

template <class T, class Load>
std::array<Vec3<T>, 3> corners_at(Load&& load, std::size_t k) {
  return {{vector_at<T>(load, k), vector_at<T>(load, k + 3), vector_at<T>(load, k + 6)}};
}

// Entry `centre`: centre, half extents, and the triangle's corners a, b, c.
struct CentreEntry {
  static constexpr std::size_t entry = 0;
  static const Predicate& description() { return box_triangle_predicate(); }
  template <class T>
  using Problem = CentredAndTriangle<T>;
  template <class T, class Load>
  static Problem<T> problem(Load&& load) {
    return {vector_at<T>(load, 0), {{load(3), load(4), load(5)}}, corners_at<T>(load, 6)};
  }
};

// Entry `minmax`: the box's two corners, and the triangle's.
struct MinmaxEntry {
  static constexpr std::size_t entry = 1;
  static const Predicate& description() { return box_triangle_predicate(); }
  template <class T>
  using Problem = CornersAndTriangle<T>;
  template <class T, class Load>
  static Problem<T> problem(Load&& load) {
    return {vector_at<T>(load, 0), vector_at<T>(load, 3), corners_at<T>(load, 6)};
  }
};

// Entry `matrix`: an oriented box as box-box has it, and the triangle's corners.
struct OrientedEntry {
  static constexpr std::size_t entry = 2;
  static const Predicate& description() { return box_triangle_predicate(); }
  template <class T>
  using Problem = BoxAndTriangle<T>;
  template <class T, class Load>
  static Problem<T> problem(Load&& load) {
    return {{vector_at<T>(load, 0),
             {{load(3), load(4), load(5)}},
             {{vector_at<T>(load, 6), vector_at<T>(load, 9), vector_at<T>(load, 12)}}},
            corners_at<T>(load, 15)};
  }
};

// Entry `quaternion`: a turned box as box-box has it, and the triangle's corners.
struct TurnedEntry {
  static constexpr std::size_t entry = 3;
  static const Predicate& description() { return box_triangle_predicate(); }
  template <class T>
  using Problem = TurnedAndTriangle<T>;
  template <class T, class Load>
  static Problem<T> problem(Load&& load) {
    return {{vector_at<T>(load, 0), {{load(3), load(4), load(5)}}, {{load(6), load(7), load(8), load(9)}}},
            corners_at<T>(load, 10)};
  }
};

// The box by centre and half extents: for corners (l + h) / 2 and (h - l) / 2, in floats with the kernel's rounding.
template <class T>
CentredAndTriangle<T> centred(const CentredAndTriangle<T>& q) {
  return q;
}
template <class T>
CentredAndTriangle<T> centred(const CornersAndTriangle<T>& q) {
  const OrientedBox<T> box = with_matrix(CornersBox<T>{q.low, q.high});
  return {box.centre, box.half, q.corner};
}

// The same as an oriented box: its axes are the world's.
template <class T>
BoxAndTriangle<T> oriented(const BoxAndTriangle<T>& q) {
  return q;
}
template <class T>
BoxAndTriangle<T> oriented(const CentredAndTriangle<T>& q) {
  const T one(1.0), zero(0.0);
  return {{q.centre, q.half, {{{one, zero, zero}, {zero, one, zero}, {zero, zero, one}}}}, q.corner};
}
template <class T>
BoxAndTriangle<T> oriented(const CornersAndTriangle<T>& q) {
  return oriented(centred(q));
}

// The rotation of a quaternion, each entry divided once.
template <class T>
BoxAndTriangle<T> oriented(const TurnedAndTriangle<T>& q) {
  return {with_matrix(q.box), q.corner};
}

// The numbers of a query in the order of the columns.
template <class Real>
void put_vectors(Numbers<Real>& numbers, std::size_t k, std::initializer_list<Vec3<Real>> vectors) {
  for (const Vec3<Real>& v : vectors) {
    for (const Real x : {v.x, v.y, v.z}) numbers[k++] = x;
  }
}
template <class Real>
Numbers<Real> numbers_of(const CentredAndTriangle<Real>& q) {
  Numbers<Real> numbers(15);
  put_vectors(numbers, 0, {q.centre, {q.half[0], q.half[1], q.half[2]}, q.corner[0], q.corner[1], q.corner[2]});
  return numbers;
}
template <class Real>
Numbers<Real> numbers_of(const CornersAndTriangle<Real>& q) {
  Numbers<Real> numbers(15);
  put_vectors(numbers, 0, {q.low, q.high, q.corner[0], q.corner[1], q.corner[2]});
  return numbers;
}
template <class Real>
Numbers<Real> numbers_of(const TurnedAndTriangle<Real>& q) {
  Numbers<Real> numbers(19);
  const TurnedBox<Real>& box = q.box;
  put_vectors(numbers, 0, {box.centre, {box.half[0], box.half[1], box.half[2]}});
  for (std::size_t k = 0; k < 4; ++k) numbers[6 + k] = box.q[k];
  put_vectors(numbers, 10, {q.corner[0], q.corner[1], q.corner[2]});
  return numbers;
}
template <class Real>
Numbers<Real> numbers_of(const BoxAndTriangle<Real>& q) {
  Numbers<Real> numbers(24);
  const OrientedBox<Real>& box = q.box;
  put_vectors(numbers, 0, {box.centre, {box.half[0], box.half[1], box.half[2]}, box.axis[0], box.axis[1], box.axis[2]});
  put_vectors(numbers, 15, {q.corner[0], q.corner[1], q.corner[2]});
  return numbers;
}

}  // namespace boxes
}  // namespace axiscert

// Queries about two boxes as the formulae see them, in the three ways in which a box can be given.
#pragma once

#include <array>

#include "kernel/base/geometry.h"
#include "kernel/formulae_kernel.h"

namespace axiscert {

const Predicate& box_box_predicate();

namespace boxes {

// The numbers beside a verdict, in words for the second body: "B".
std::vector<PredicateMeasure> measures_of_contacts(std::string_view point_a, std::string_view point_b);

using portable::cross, portable::dot, portable::magnitude, portable::Vec3;

// The closed body of all points centre + sum of t_k half_k axis_k with |t_k| <= 1, the numbers taken as exact. The half
// extents are not negative and the axes linearly independent; they need not be orthogonal or of length 1, since no
// binary matrix but the 24 signed permutations is a rotation.
template <class T>
struct OrientedBox {
  Vec3<T> centre;
  std::array<T, 3> half;
  std::array<Vec3<T>, 3> axis;
};

template <class T>
struct BoxPair {
  OrientedBox<T> a, b;
};

// A box turned by the quaternion q = (w, x, y, z) of any length but 0: exactly orthonormal over the rationals.
template <class T>
struct TurnedBox {
  Vec3<T> centre;
  std::array<T, 3> half;
  std::array<T, 4> q;
};

template <class T>
struct TurnedPair {
  TurnedBox<T> a, b;
};

// A box along the axes from corner `low` to corner `high`, none of whose coordinates is below that of `low`.
template <class T>
struct CornersBox {
  Vec3<T> low, high;
};

template <class T>
struct CornersPair {
  CornersBox<T> a, b;
};

// A along the axes, and B turned.
template <class T>
struct MixedPair {
  CornersBox<T> a;
  TurnedBox<T> b;
};

// Its centre (l + h) / 2 and half extents (h - l) / 2, in floats with the kernel's rounding.
template <class T>
OrientedBox<T> with_matrix(const CornersBox<T>& box) {
  const Vec3<T> sum = box.low + box.high, size = box.high - box.low;
  const T half(0.5), one(1.0), zero(0.0);
  return {sum * half,
          {{size.x * half, size.y * half, size.z * half}},
          {{{one, zero, zero}, {zero, one, zero}, {zero, zero, one}}}};
}

template <class T, class Load>
constexpr Vec3<T> vector_at(Load&& load, std::size_t k) {
  return {load(k), load(k + 1), load(k + 2)};
}

// The predicate in its entry `matrix`: centre, half extents and three axes of A, then those of B.
struct MatrixBoxes {
  static constexpr std::size_t entry = 0;
  static const Predicate& description() { return box_box_predicate(); }

  template <class T>
  using Problem = BoxPair<T>;
  template <class T, class Load>
  constexpr static Problem<T> problem(Load&& load) {
    const auto box = [&](std::size_t k) {
      return OrientedBox<T>{vector_at<T>(load, k),
                            {{load(k + 3), load(k + 4), load(k + 5)}},
                            {{vector_at<T>(load, k + 6), vector_at<T>(load, k + 9), vector_at<T>(load, k + 12)}}};
    };
    return {box(0), box(15)};
  }
};

// The predicate in its entry `quaternion`: centre, half extents and quaternion of A, then those of B.
struct QuaternionBoxes {
  static constexpr std::size_t entry = 1;
  static const Predicate& description() { return box_box_predicate(); }

  template <class T>
  using Problem = TurnedPair<T>;
  template <class T, class Load>
  constexpr static Problem<T> problem(Load&& load) {
    const auto box = [&](std::size_t k) {
      return TurnedBox<T>{vector_at<T>(load, k),
                          {{load(k + 3), load(k + 4), load(k + 5)}},
                          {{load(k + 6), load(k + 7), load(k + 8), load(k + 9)}}};
    };
    return {box(0), box(10)};
  }
};

// The predicate in its entry `minmax`: the corners min and max of A, then those of B.
struct MinmaxBoxes {
  static constexpr std::size_t entry = 2;
  static const Predicate& description() { return box_box_predicate(); }

  template <class T>
  using Problem = CornersPair<T>;
  template <class T, class Load>
  constexpr static Problem<T> problem(Load&& load) {
    return {{vector_at<T>(load, 0), vector_at<T>(load, 3)}, {vector_at<T>(load, 6), vector_at<T>(load, 9)}};
  }
};

// The predicate in its entry `minmax-quaternion`: A by its corners min and max, B by centre, half extents and
// quaternion.
struct MixedBoxes {
  static constexpr std::size_t entry = 3;
  static const Predicate& description() { return box_box_predicate(); }

  template <class T>
  using Problem = MixedPair<T>;
  template <class T, class Load>
  constexpr static Problem<T> problem(Load&& load) {
    return {{vector_at<T>(load, 0), vector_at<T>(load, 3)},
            {vector_at<T>(load, 6), {{load(9), load(10), load(11)}}, {{load(12), load(13), load(14), load(15)}}}};
  }
};

// The numbers of a query in the order of the columns.
template <class Real>
Numbers<Real> numbers_of(const MixedPair<Real>& q) {
  const auto& [centre, half, turn] = q.b;
  return {q.a.low.x, q.a.low.y, q.a.low.z, q.a.high.x, q.a.high.y, q.a.high.z, centre.x, centre.y,
          centre.z,  half[0],   half[1],   half[2],    turn[0],    turn[1],    turn[2],  turn[3]};
}
template <class Real>
Numbers<Real> numbers_of(const CornersPair<Real>& q) {
  Numbers<Real> numbers(12);
  std::size_t k = 0;
  for (const Vec3<Real>* v : std::array{&q.a.low, &q.a.high, &q.b.low, &q.b.high}) {
    for (const Real x : std::array{v->x, v->y, v->z}) numbers[k++] = x;
  }
  return numbers;
}
template <class Real>
Numbers<Real> numbers_of(const BoxPair<Real>& q) {
  Numbers<Real> numbers(30);
  std::size_t k = 0;
  const auto put = [&](const Vec3<Real>& v) {
    for (const Real x : std::array{v.x, v.y, v.z}) numbers[k++] = x;
  };
  for (const OrientedBox<Real>* box : std::array{&q.a, &q.b}) {
    put(box->centre);
    for (const Real s : box->half) numbers[k++] = s;
    for (const Vec3<Real>& axis : box->axis) put(axis);
  }
  return numbers;
}
template <class Real>
Numbers<Real> numbers_of(const TurnedPair<Real>& q) {
  Numbers<Real> numbers(20);
  std::size_t k = 0;
  for (const TurnedBox<Real>* box : std::array{&q.a, &q.b}) {
    for (const Real x : std::array{box->centre.x, box->centre.y, box->centre.z}) numbers[k++] = x;
    for (const Real s : box->half) numbers[k++] = s;
    for (const Real x : box->q) numbers[k++] = x;
  }
  return numbers;
}

}  // namespace boxes
}  // namespace axiscert

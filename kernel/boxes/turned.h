// Boxes that are given by quaternions: as matrices, for the formulae that want one, and without a division.
#pragma once

#include "kernel/boxes/axes.h"
#include "kernel/boxes/relative.h"

namespace axiscert::boxes {

// q.q, and the columns of M(q) = q.q times the rotation by q: degree 2, for q = (w, x, y, z) of any length.
template <class T>
struct Turn {
  T square;
  std::array<Vec3<T>, 3> column;
};

// Order: squares w w, x x, y y, z z; q.q = (w w + x x) + (y y + z z); an entry off the diagonal is (x y + w z) doubled
// by an addition.
template <class T>
Turn<T> turn_of(const std::array<T, 4>& q) {
  const auto& [w, x, y, z] = q;
  const T ww = w * w, xx = x * x, yy = y * y, zz = z * z;
  const auto doubled = [](const T& one, const T& other) {
    const T sum = one + other;
    return sum + sum;
  };
  const auto difference = [](const T& one, const T& other) {
    const T rest = one - other;
    return rest + rest;
  };
  const T wx = w * x, wy = w * y, wz = w * z, xy = x * y, xz = x * z, yz = y * z;
  return {(ww + xx) + (yy + zz),
          {{{(ww + xx) - (yy + zz), doubled(xy, wz), difference(xz, wy)},
            {difference(xy, wz), (ww + yy) - (xx + zz), doubled(yz, wx)},
            {doubled(xz, wy), difference(yz, wx), (ww + zz) - (xx + yy)}}}};
}

// The rotation itself, each entry of M(q) divided once by q.q. Here alone the formulae divide: over the rationals the
// result is exactly orthonormal.
template <class T>
OrientedBox<T> with_matrix(const TurnedBox<T>& box) {
  const Turn<T> turn = turn_of(box.q);
  return {box.centre,
          box.half,
          {{turn.column[0] / turn.square, turn.column[1] / turn.square, turn.column[2] / turn.square}}};
}
template <class T, template <class> class Pair>
BoxPair<T> with_matrices(const Pair<T>& q) {
  return {with_matrix(q.a), with_matrix(q.b)};
}

// Formulae of the entry `matrix` for those of quaternions and of corners. What was lost by rounding a rotation's
// matrix, or a centre and half extents, is then lost by the kernel.
template <class F>
struct ByMatrices {
  static constexpr std::string_view name = F::name;
  static constexpr FormulaeKind kind = F::kind_if_orthonormal;
  template <class T, class Pair, class Sink>
  static void comparisons(const Pair& q, Sink& sink) {
    F::template comparisons<T>(with_matrices(q), sink);
  }
};

// The textbook multiplied out by the squares of the quaternions: no division, and over the reals its signs. Degree 5 >
// 5. C = A' B with the columns of M(q), which are q.q long.
struct Homogeneous {
  static constexpr std::string_view name = "homogeneous";
  static constexpr FormulaeKind kind = FormulaeKind::rung;

  template <class T, class Sink>
  static void comparisons(const TurnedPair<T>& q, Sink& sink) {
    const Turn<T> a = turn_of(q.a.q), b = turn_of(q.b.q);
    const Vec3<T> between = q.b.centre - q.a.centre;
    const T both = a.square * b.square;
    Matrix<T> size;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) size[i][j] = magnitude(dot(a.column[i], b.column[j]));
    }
    for (std::size_t i = 0; i < 3; ++i) {
      sink(facet_of_a(i), magnitude(dot(a.column[i], between)) * b.square,
           radius(q.a.half[i] * both, q.b.half, size[i][0], size[i][1], size[i][2]));
    }
    for (std::size_t j = 0; j < 3; ++j) {
      sink(facet_of_b(j), magnitude(dot(b.column[j], between)) * a.square,
           radius(q.b.half[j] * both, q.a.half, size[0][j], size[1][j], size[2][j]));
    }
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        const std::size_t i1 = next(i), i2 = last(i), j1 = next(j), j2 = last(j);
        const T radius_a = q.a.half[i1] * size[i2][j] + q.a.half[i2] * size[i1][j];
        const T radius_b = q.b.half[j1] * size[i][j2] + q.b.half[j2] * size[i][j1];
        sink(edges(i, j), magnitude(dot(cross(a.column[i], b.column[j]), between)), radius_a + radius_b);
      }
    }
  }
};

// Two boxes along the axes by their corners alone: the min of one is above the max of the other. Nothing is computed,
// so nothing is rounded. Degree 1 > 1.
struct Intervals {
  static constexpr std::string_view name = "intervals";
  static constexpr FormulaeKind kind = FormulaeKind::rung;

  template <class T, class Sink>
  static void comparisons(const CornersPair<T>& q, Sink& sink) {
    const auto axis = [&](std::size_t i, std::size_t k) {
      const auto at = [&](const Vec3<T>& v) -> const T& { return k == 0 ? v.x : k == 1 ? v.y : v.z; };
      // Not the greater min and the lesser max: they may be of one box, which says nothing where it has no extent.
      const bool is_b_above = at(q.b.low) >= at(q.a.high);
      sink(i, is_b_above ? at(q.b.low) : at(q.a.low), is_b_above ? at(q.a.high) : at(q.b.high));
    };
    for (std::size_t k = 0; k < 3; ++k) {
      axis(facet_of_a(k), k);
      axis(facet_of_b(k), k);
    }
    // The product of two axes is the third, up to its sign, or 0.
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        if (i == j) sink(edges(i, j), T(0.0), T(0.0));
        else axis(edges(i, j), 3 - i - j);
      }
    }
  }
};

}  // namespace axiscert::boxes

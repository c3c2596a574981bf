// The rungs in A's own frame, t = A' T and R = A' B: the textbook, its forms with an epsilon, and the one with
// cofactors that needs none.
//
// kernel/base/geometry.h says why there is no guard for AXISCERT_PER_TARGET. The vectors of a pair are those of the
// target: a pair is any type with members a and b as BoxPair has them.
#if defined(AXISCERT_PER_TARGET) || !defined(AXISCERT_KERNEL_BOXES_RELATIVE_H)
#define AXISCERT_KERNEL_BOXES_RELATIVE_H

#include <array>
#include <string_view>

#include "kernel/base/geometry.h"
#include "kernel/boxes/names.h"
#include "kernel/formulae_list.h"

AXISCERT_BEFORE_NAMESPACE();
namespace axiscert {
namespace AXISCERT_TARGET {
namespace box_frame {

using boxes::edges, boxes::facet_of_a, boxes::facet_of_b, boxes::last, boxes::next;

template <class T>
using Matrix = std::array<std::array<T, 3>, 3>;

// B in A's frame. turn[i][j] = a_i.b_j; `along` is the vector from centre to centre.
template <class T>
struct Relative {
  std::array<T, 3> half_a, half_b, along;
  Matrix<T> turn;
};

template <class Pair>
AXISCERT_INLINE auto relative(const Pair& q) {
  using T = typename decltype(q.a.half)::value_type;
  Relative<T> r{q.a.half, q.b.half, {}, {}};
  const Vec3<T> between = q.b.centre - q.a.centre;
  for (std::size_t i = 0; i < 3; ++i) {
    r.along[i] = dot(q.a.axis[i], between);
    for (std::size_t j = 0; j < 3; ++j) r.turn[i][j] = dot(q.a.axis[i], q.b.axis[j]);
  }
  return r;
}

// |R|, each entry raised by `epsilon`.
template <class T>
AXISCERT_INLINE Matrix<T> magnitudes(const Matrix<T>& turn, const T* epsilon = nullptr) {
  Matrix<T> found = turn;
  for (auto& row : found) {
    for (T& x : row) {
      x = magnitude(x);
      if (epsilon) x = x + *epsilon;
    }
  }
  return found;
}

// cofactors[i][j] is R without row i and column j, a difference of two products. Over the reals the entry of R itself,
// where A and B are orthonormal and of one handedness; up to its sign in each case.
template <class T>
AXISCERT_INLINE Matrix<T> cofactors(const Matrix<T>& turn) {
  Matrix<T> found = turn;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const auto &one = turn[next(i)], &other = turn[last(i)];
      found[i][j] = one[next(j)] * other[last(j)] - one[last(j)] * other[next(j)];
    }
  }
  return found;
}

// s0 x0 + s1 x1 + s2 x2, after `own`.
template <class T>
AXISCERT_INLINE T radius(const T& own, const std::array<T, 3>& half, const T& x0, const T& x1, const T& x2) {
  return own + ((half[0] * x0 + half[1] * x1) + half[2] * x2);
}

template <class T>
struct AxisSides {
  T lhs, rhs;
  AXISCERT_INLINE auto separate() const { return lhs > rhs; }
};

// Normals a_i: |t_i| > s_i + row i of |R| times B's extents. Degree 2 > 3.
template <class T>
AXISCERT_INLINE AxisSides<T> facet_sides_of_a(const Relative<T>& r, std::size_t i, const Matrix<T>& size) {
  return {magnitude(r.along[i]), radius(r.half_a[i], r.half_b, size[i][0], size[i][1], size[i][2])};
}
template <class T, class Sink>
AXISCERT_INLINE void facets_of_a(const Relative<T>& r, const Matrix<T>& size, Sink& sink) {
  for (std::size_t i = 0; i < 3; ++i) {
    const AxisSides<T> sides = facet_sides_of_a(r, i, size);
    sink(facet_of_a(i), sides.lhs, sides.rhs);
  }
}

// Normals b_j: |t.R_j| > own + column j of |R| times A's extents. Degree 4 > 3 with own = B's extent.
template <class T>
AXISCERT_INLINE AxisSides<T> facet_sides_of_b(const Relative<T>& r, std::size_t j, const T& own,
                                              const Matrix<T>& size) {
  const T along = (r.along[0] * r.turn[0][j] + r.along[1] * r.turn[1][j]) + r.along[2] * r.turn[2][j];
  return {magnitude(along), radius(own, r.half_a, size[0][j], size[1][j], size[2][j])};
}
template <class T, class Sink>
AXISCERT_INLINE void facets_of_b(const Relative<T>& r, const std::array<T, 3>& own, const Matrix<T>& size, Sink& sink) {
  for (std::size_t j = 0; j < 3; ++j) {
    const AxisSides<T> sides = facet_sides_of_b(r, j, own[j], size);
    sink(facet_of_b(j), sides.lhs, sides.rhs);
  }
}

// The edges' axis e_i x R_j, which has two entries of R and a 0: A's radius takes these two, B's the matrix `of_b`,
// which over the reals is |R| again where both boxes are orthonormal, and the cofactors' magnitudes in each case.
template <class T>
AXISCERT_INLINE AxisSides<T> edge_sides(const Relative<T>& r, std::size_t i, std::size_t j, const Matrix<T>& of_a,
                                        const Matrix<T>& of_b) {
  const std::size_t i1 = next(i), i2 = last(i), j1 = next(j), j2 = last(j);
  const T lhs = magnitude(r.along[i2] * r.turn[i1][j] - r.along[i1] * r.turn[i2][j]);
  const T radius_a = r.half_a[i1] * of_a[i2][j] + r.half_a[i2] * of_a[i1][j];
  const T radius_b = r.half_b[j1] * of_b[i][j2] + r.half_b[j2] * of_b[i][j1];
  return {lhs, radius_a + radius_b};
}
template <class T, class Sink>
AXISCERT_INLINE void edge_axes(const Relative<T>& r, const Matrix<T>& of_a, const Matrix<T>& of_b, Sink& sink) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const AxisSides<T> sides = edge_sides(r, i, j, of_a, of_b);
      sink(edges(i, j), sides.lhs, sides.rhs);
    }
  }
}

// Rung 3. B's own columns, projected on each axis: right over the reals where A is orthonormal, for any B with
// orthogonal columns. Degree 4 > 5 for b_j and the edges.
struct FramedFifteen {
  static constexpr std::string_view name = "framed";
  static constexpr FormulaeKind kind = FormulaeKind::variant;
  static constexpr FormulaeKind kind_if_orthonormal = FormulaeKind::rung;

  template <class T, class Pair, class Sink>
  AXISCERT_INLINE static void comparisons(const Pair& q, Sink& sink) {
    const Relative<T> r = relative(q);
    const Matrix<T> size = magnitudes(r.turn);
    std::array<T, 3> own;
    for (std::size_t j = 0; j < 3; ++j) {
      const T &x = r.turn[0][j], &y = r.turn[1][j], &z = r.turn[2][j];
      own[j] = r.half_b[j] * ((x * x + y * y) + z * z);
    }
    facets_of_a(r, size, sink);
    facets_of_b(r, own, size, sink);
    edge_axes(r, size, magnitudes(cofactors(r.turn)), sink);
  }
};

// Rung 4. The predicate as books have it: det(b_k, a_i, b_j) is rewritten as an entry of R, which holds for orthonormal
// boxes alone. For rounded rotations it misses deep contacts over the reals, wherever two edges are nearly parallel.
// Degree 4 > 3 for b_j and the edges. Source: S. Gottschalk, M. Lin, D. Manocha, OBBTree (1996); C. Ericson, Real-Time
// Collision Detection (2005), 4.4.1.
struct Textbook {
  static constexpr std::string_view name = "textbook";
  static constexpr FormulaeKind kind = FormulaeKind::variant;
  static constexpr FormulaeKind kind_if_orthonormal = FormulaeKind::rung;

  template <class T, class Pair, class Sink>
  AXISCERT_INLINE static void comparisons(const Pair& q, Sink& sink) {
    const Relative<T> r = relative(q);
    const Matrix<T> size = magnitudes(r.turn);
    facets_of_a(r, size, sink);
    facets_of_b(r, r.half_b, size, sink);
    edge_axes(r, size, size, sink);
  }
};

// The textbook with the cofactors of R for R in B's radius on the nine edge axes, 18 products more. The radius is then
// that of the axis which is used, so an error on it is relative to the axis' length. Degree 4 > 5 for the edges.
struct Cofactor {
  static constexpr std::string_view name = "cofactor";
  static constexpr FormulaeKind kind = FormulaeKind::variant;
  static constexpr FormulaeKind kind_if_orthonormal = FormulaeKind::rung;

  template <class T, class Pair, class Sink>
  AXISCERT_INLINE static void comparisons(const Pair& q, Sink& sink) {
    const Relative<T> r = relative(q);
    const Matrix<T> size = magnitudes(r.turn);
    facets_of_a(r, size, sink);
    facets_of_b(r, r.half_b, size, sink);
    edge_axes(r, size, magnitudes(cofactors(r.turn)), sink);
  }
};

}  // namespace box_frame
}  // namespace AXISCERT_TARGET
}  // namespace axiscert
AXISCERT_AFTER_NAMESPACE();

#ifndef AXISCERT_PER_TARGET
namespace axiscert::boxes {
using namespace portable::box_frame;
}
#endif
#endif

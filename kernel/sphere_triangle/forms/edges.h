// The axis of an edge in each of the sixteen combinations of four choices, as one text: two cells that differ in one
// choice differ in one thing. Also the two forms of the article that are none of them.
//
// Source: C. Ericson, "Optimizing a sphere-triangle intersection test" (2010); degree 4 is this project's. Over the
// reals every form has the signs of the published one wherever it is defined. A divided one is undefined (0/0) where
// the edge's two vertices are equal; the published comparisons are 0 > 0 there.
#pragma once

#include "kernel/sphere_triangle/formulae.h"

namespace axiscert::rungs {

using portable::Vec3, portable::square_root, portable::times_square;

// Whether the centre P is moved to the origin before anything else, or stays where it is.
enum class Frame : std::uint8_t { world, centred };
// Whether e = |AB|^2 divides, or both sides are multiplied by it.
enum class Division : std::uint8_t { divided, multiplied };
// Whether lengths are compared, or their squares.
enum class Root : std::uint8_t { rooted, squared };
// From the foot Q of P on line AB, of degree 6 where nothing divides; or from the normal N of the plane through A, B
// and P, of degree 4: |N|^2 = e |Q - P|^2.
enum class EdgeDegree : std::uint8_t { six, four };

struct EdgeChoices {
  Frame frame;
  Division division;
  Root root;
  EdgeDegree degree;
  bool operator==(const EdgeChoices&) const = default;
};

// What every edge of a query has: P is the origin where all is centred. V = AB x AC.
template <class T>
struct EdgeProblem {
  Vec3<T> P, V;
  T r, rr, zero;
};

// The radius comparison, of the square of a distance times e^2 (degree 6), times e (degree 4), or as it is.
template <EdgeChoices choices, class T, class Emit>
AXISCERT_INLINE void edge_radius(const T& squared, const T& e, const EdgeProblem<T>& q, Comparison radius,
                                 Emit&& emit) {
  constexpr bool is_squared = choices.root == Root::squared;
  if constexpr (choices.division == Division::divided) {
    if constexpr (is_squared) emit(radius, squared, q.rr);
    else emit(radius, square_root(squared), q.r);
  } else if constexpr (choices.degree == EdgeDegree::six) {
    if constexpr (is_squared) emit(radius, squared, times_square(q.rr, e));
    else emit(radius, square_root(squared), q.r * e);
  } else {
    if constexpr (is_squared) emit(radius, squared, q.rr * e);
    else emit(radius, square_root(squared), q.r * square_root(e));
  }
}

// Emits the two comparisons of the axis of edge AB; C is the opposite vertex.
//
// radius, degree 6    |Q - P| > r           times e where multiplied
// side, degree 6      0 > (P - Q).(C - Q)   times e^2 where multiplied; centred it is Q.(C - Q) > 0
// radius, degree 4    |N| / |AB| > r        times |AB| where multiplied
// side, degree 4      0 > N.V               nothing to divide by: in all of them
template <EdgeChoices choices>
struct EdgeCell {
  static constexpr Frame frame = choices.frame;
  static constexpr bool is_ring = choices.division == Division::multiplied && choices.root == Root::squared;
  static constexpr bool takes_normal = choices.degree == EdgeDegree::four;  // V

  template <class T, class Emit>
  AXISCERT_INLINE static void comparisons(const Vec3<T>& A, const Vec3<T>& B, const Vec3<T>& C, const EdgeProblem<T>& q,
                                          Comparison radius, Emit&& emit) {
    constexpr bool is_world = frame == Frame::world, is_divided = choices.division == Division::divided;
    const auto side = static_cast<Comparison>(static_cast<int>(radius) + 1);
    const Vec3<T> AB = B - A;
    if constexpr (choices.degree == EdgeDegree::six) {
      const T d = dot(is_world ? q.P - A : A, AB), e = dot(AB, AB);  // centred, -d is that of the world
      Vec3<T> Q = A, QC = C;
      if constexpr (is_divided) {
        const Vec3<T> along = AB * (d / e);
        Q = is_world ? A + along : A - along;
        QC = C - Q;
      } else {
        Q = is_world ? A * e + AB * d : A * e - AB * d;
        QC = C * e - Q;
      }
      if constexpr (is_world) {
        const Vec3<T> QP = (is_divided ? q.P : q.P * e) - Q;
        edge_radius<choices>(dot(QP, QP), e, q, radius, emit);
        emit(side, q.zero, dot(QP, QC));
      } else {
        edge_radius<choices>(dot(Q, Q), e, q, radius, emit);
        emit(side, dot(Q, QC), q.zero);
      }
    } else {
      // (A - P) x (B - P), in the world's coordinates without a difference from P: of its expansions the one with two
      // products and a sum, where A x B + B x P + P x A has three and two.
      Vec3<T> N = cross(A, B);
      if constexpr (is_world) N = N - cross(q.P, AB);
      const T squared = dot(N, N), e = dot(AB, AB);
      if constexpr (is_divided) edge_radius<choices>(squared / e, e, q, radius, emit);
      else edge_radius<choices>(squared, e, q, radius, emit);
      emit(side, q.zero, dot(N, q.V));
    }
  }
};

// The article's step between divided and multiplied: what was divided is multiplied by e.
struct ScaledEdge {
  static constexpr Frame frame = Frame::world;
  static constexpr bool is_ring = false, takes_normal = false;
  template <class T, class Emit>
  AXISCERT_INLINE static void comparisons(const Vec3<T>& A, const Vec3<T>& B, const Vec3<T>& C, const EdgeProblem<T>& q,
                                          Comparison radius, Emit&& emit) {
    const auto side = static_cast<Comparison>(static_cast<int>(radius) + 1);
    const Vec3<T> AB = B - A;
    const T d = dot(q.P - A, AB), e = dot(AB, AB);
    const Vec3<T> Q = A + AB * (d / e);
    const Vec3<T> QP = (q.P - Q) * e, QC = C - Q;
    emit(radius, dot(QP, QP), times_square(q.rr, e));
    emit(side, q.zero, dot(QP, QC * e));
  }
};

// The published form: centred, multiplied, squared, of degree 6, with d = A.B - A.A for A.AB.
struct DistributedEdge {
  static constexpr Frame frame = Frame::centred;
  static constexpr bool is_ring = true, takes_normal = false;
  template <class T, class Emit>
  AXISCERT_INLINE static void comparisons(const Vec3<T>& A, const Vec3<T>& B, const Vec3<T>& C, const EdgeProblem<T>& q,
                                          Comparison radius, Emit&& emit) {
    const auto side = static_cast<Comparison>(static_cast<int>(radius) + 1);
    const Vec3<T> AB = B - A;
    const T d = dot(A, B) - dot(A, A), e = dot(AB, AB);
    const Vec3<T> Q = A * e - AB * d;
    const Vec3<T> QC = C * e - Q;
    emit(radius, dot(Q, Q), times_square(q.rr, e));
    emit(side, dot(Q, QC), q.zero);
  }
};

}  // namespace axiscert::rungs

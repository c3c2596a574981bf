// The twenty axes of a moving sphere: the sphere, standing still, against the prism that the triangle sweeps towards
// it. Straight-line ring arithmetic, no parameter of time, degree 6 as the static predicate. docs/moving.md derives it.
// The proof that one of them decides, in its letters:
//
// Why an axis always separates rightly. If a unit vector u has u.X > r for the six corners, so it has for the whole
// prism: no point of it is within r of P. radius says so of one corner; sides and heading say that the others are no
// nearer along u.
// Why one always does. Let t be the first time of the least distance, X the nearest point of the triangle then, and u
// the direction to it. The static axis of X's feature separates at that time.
// - If t = 0, the distance does not decrease there, which is heading at the start. D = 0 is this case. t = 1 is the
//   same at the end.
// - Between, D is not 0 and the distance does not change to first order, so u.D = 0. Then u is the axis of the vertex,
//   or the edge, seen along D.
// - For an edge parallel to D, where M = 0, and for the face, where m = 0, u does not depend on t. The axis then
//   separates at the start with its heading 0.
// Why > is enough where D.V is not 0. The prism then is a solid. Each of its 6 corners, 9 edges and 5 facets has its
// own axis. Let X be its point nearest to P, farther than r. Let G be the corner, edge or facet of the points no
// farther along u = X - P than X. G is at right angles to u, and X is in it: its axis has the direction u, and its
// radius comparison holds. Its sides and heading ask for the corners outside G, each farther along u, so they hold with
// >.
//
// kernel/base/geometry.h says why there is no guard for AXISCERT_PER_TARGET.
#if defined(AXISCERT_PER_TARGET) || !defined(AXISCERT_KERNEL_MOVING_SPHERE_TWENTY_H)
#define AXISCERT_KERNEL_MOVING_SPHERE_TWENTY_H

#include "kernel/base/geometry.h"
#include "kernel/formulae_list.h"
#include "kernel/moving_sphere/names.h"

AXISCERT_BEFORE_NAMESPACE();
namespace axiscert {
namespace AXISCERT_TARGET {

// An edge X Y of the triangle, which the motion does not turn: U = Y - X, e = U.U, M = D x U.
template <class T>
struct MovingEdge {
  Vec3<T> along, across;
  T length2;
};
template <class T>
AXISCERT_INLINE MovingEdge<T> moving_edge(const Vec3<T>& from, const Vec3<T>& to, const Vec3<T>& d) {
  const Vec3<T> along = to - from;
  return {along, cross(d, along), dot(along, along)};
}

// The parts that do not change with the triangle's place: V = AB x AC and m = D.V among them.
template <class T>
struct Motion {
  MovingEdge<T> ab, bc, ca;
  Vec3<T> d, normal;
  T normal2, along_normal, rr, zero;
};

// The two ends of the motion, where the sphere stands still. A value that grows with D towards the triangle must not be
// positive at the start, and not negative at the end.
enum class Moment { start, end };

template <Moment moment, class T>
struct StillAxes {
  const Motion<T>& motion;

  template <class Sink>
  AXISCERT_INLINE void heading(std::size_t i, const T& closing, Sink& sink) const {
    if constexpr (moment == Moment::start) sink(i, motion.zero, closing);
    else sink(i, closing, motion.zero);
  }
  template <class Sink>
  AXISCERT_INLINE void vertex(std::size_t i, const Vec3<T>& at, const T& square, const T& one, const T& other,
                              Sink& sink) const {
    sink(i, square, motion.rr);
    sink(i + 1, one, square);
    sink(i + 2, other, square);
    heading(i + 3, dot(at, motion.d), sink);
  }
  template <class Sink>
  AXISCERT_INLINE void edge(std::size_t i, const Vec3<T>& from, const MovingEdge<T>& line, Sink& sink) const {
    const Vec3<T> normal = cross(from, line.along);
    sink(i, dot(normal, normal), motion.rr * line.length2);
    sink(i + 1, motion.zero, dot(normal, motion.normal));
    heading(i + 2, dot(normal, line.across), sink);
  }

  // The seven axes of the static predicate, with the sphere's centre at the origin and the triangle at `a`, `b`, `c`,
  // each with one more side, `heading`. Comparisons from i on.
  //
  // plane.radius    beyond the plane of ABC                      degree 6; zero area: 0 > 0, never separates
  // vertex.radius   vertex A is outside the sphere               degree 2
  // vertex.side     B is beyond the plane at A, normal A         degree 2; A = B: equal sides
  // edge.radius     the line AB is outside the sphere            degree 4; A = B: 0 > 0, never separates
  // edge.side       C is beyond the plane along AB               degree 4; C on line AB: 0 > 0
  template <class Sink>
  AXISCERT_INLINE void axes(std::size_t i, const Vec3<T>& a, const Vec3<T>& b, const Vec3<T>& c, Sink& sink) const {
    const T offset = dot(a, motion.normal);
    sink(i, offset * offset, motion.rr * motion.normal2);
    heading(i + 1, offset * motion.along_normal, sink);

    const T aa = dot(a, a), ab = dot(a, b), ac = dot(a, c), bb = dot(b, b), bc = dot(b, c), cc = dot(c, c);
    vertex(i + 2, a, aa, ab, ac, sink);
    vertex(i + 6, b, bb, ab, bc, sink);
    vertex(i + 10, c, cc, ac, bc, sink);

    edge(i + 14, a, motion.ab, sink);
    edge(i + 17, b, motion.bc, sink);
    edge(i + 20, c, motion.ca, sink);
  }
};

// The static predicate in two dimensions, seen along D; D = 0 never separates.
//
// vertex.radius   the line of the moving vertex is outside the sphere: W = A x D       degree 4
// vertex.side     the line of B is beyond the plane of that of A, normal D x W         degree 4
// edge.radius     the plane that the edge sweeps is outside the sphere: delta = A.M    degree 6; M = 0 never separates
// edge.side       C is beyond that plane: C.M = delta + m                              degree 6
template <class T>
struct SweepingAxes {
  const Motion<T>& motion;

  template <class Sink>
  AXISCERT_INLINE void vertex(std::size_t i, const T& square, const T& limit, const T& one, const T& other,
                              Sink& sink) const {
    sink(i, square, limit);
    sink(i + 1, one, square);
    sink(i + 2, other, square);
  }
  template <class Sink>
  AXISCERT_INLINE void edge(std::size_t i, const Vec3<T>& from, const MovingEdge<T>& line, Sink& sink) const {
    const T delta = dot(from, line.across);
    sink(i, delta * delta, motion.rr * dot(line.across, line.across));
    sink(i + 1, delta * motion.along_normal, motion.zero);
  }

  template <class Sink>
  AXISCERT_INLINE void axes(std::size_t i, const Vec3<T>& a, const Vec3<T>& b, const Vec3<T>& c, Sink& sink) const {
    const Vec3<T> wa = cross(a, motion.d), wb = cross(b, motion.d), wc = cross(c, motion.d);
    const T aa = dot(wa, wa), ab = dot(wa, wb), ac = dot(wa, wc), bb = dot(wb, wb), bc = dot(wb, wc), cc = dot(wc, wc);
    const T limit = motion.rr * dot(motion.d, motion.d);
    vertex(i, aa, limit, ab, ac, sink);
    vertex(i + 3, bb, limit, ab, bc, sink);
    vertex(i + 6, cc, limit, ac, bc, sink);

    edge(i + 9, a, motion.ab, sink);
    edge(i + 11, b, motion.bc, sink);
    edge(i + 13, c, motion.ca, sink);
  }
};

// All 61 comparisons. With `>` in sides and headings it is right over the reals wherever D.V != 0, and else may invent
// contacts; with `>=` in them it is right for every query.
struct Twenty {
  static constexpr std::string_view name = "twenty";
  static constexpr FormulaeKind kind = FormulaeKind::rung;
  // `q` has the members of MovingQuery, or of EndsQuery: then the axes at the end are those of the static predicate at
  // P1, from coordinates that are rounded once.
  template <class T, class Query, class Sink>
  AXISCERT_INLINE static void comparisons(const Query& q, Sink& sink) {
    const Vec3<T> a = translated(q.a, q.p), b = translated(q.b, q.p), c = translated(q.c, q.p);
    const Vec3<T> d = displacement<T>(q);
    Motion<T> motion{
        moving_edge(a, b, d), moving_edge(b, c, d), moving_edge(c, a, d), d, {}, {}, {}, q.r * q.r, T(0.0)};
    motion.normal = cross(motion.ab.along, c - a);
    motion.normal2 = dot(motion.normal, motion.normal);
    motion.along_normal = dot(d, motion.normal);

    StillAxes<Moment::start, T>{motion}.axes(moving_sphere::start_axes, a, b, c, sink);
    if constexpr (has_ends<Query>) {
      StillAxes<Moment::end, T>{motion}.axes(moving_sphere::end_axes, translated(q.a, q.p1), translated(q.b, q.p1),
                                             translated(q.c, q.p1), sink);
    } else {
      StillAxes<Moment::end, T>{motion}.axes(moving_sphere::end_axes, a - d, b - d, c - d, sink);
    }
    SweepingAxes<T>{motion}.axes(moving_sphere::sweep_axes, a, b, c, sink);
  }

 private:
  template <class Query>
  static constexpr bool has_ends = requires(const Query& q) { q.p1; };
  template <class T, class Query>
  AXISCERT_INLINE static Vec3<T> displacement(const Query& q) {
    if constexpr (has_ends<Query>) return q.p1 - q.p;
    else return q.d;
  }
};

struct TwentyNonstrict : Twenty {
  static constexpr std::string_view name = "twenty-nonstrict";
  static constexpr ComparisonBits nonstrict = moving_sphere::side_bits;
};

}  // namespace AXISCERT_TARGET
}  // namespace axiscert
AXISCERT_AFTER_NAMESPACE();

#ifndef AXISCERT_PER_TARGET
#include "kernel/moving_sphere/moving_sphere.h"

namespace axiscert::moving_sphere {
using portable::cross, portable::dot, portable::Twenty, portable::TwentyNonstrict, portable::Vec3;
}  // namespace axiscert::moving_sphere
#endif
#endif

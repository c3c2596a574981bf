// The twenty axes of a moving sphere: the sphere, standing still, against the prism that the triangle sweeps towards
// it. Straight-line ring arithmetic, no parameter of time, degree 6 as the static test. docs/moving.md derives it.
#pragma once

#include "kernel/moving_sphere/moving_sphere.h"
#include "kernel/moving_sphere/names.h"

namespace axiscert::moving_sphere {

using portable::cross;
using portable::dot;
using portable::Vec3;

// An edge X Y of the triangle, which the motion does not turn: U = Y - X, e = U.U, M = D x U.
template <class T>
struct MovingEdge {
  Vec3<T> along, across;
  T length2;
};
template <class T>
MovingEdge<T> moving_edge(const Vec3<T>& from, const Vec3<T>& to, const Vec3<T>& d) {
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

// The seven axes of the static test, with the sphere's centre at the origin and the triangle at `a`, `b`, `c`, each
// with one more side: heading(x, y) emits that x, which grows with D towards the triangle, does not pass y.
//
// plane.radius    beyond the plane of ABC                      degree 6; zero area: 0 > 0, never separates
// vertex.radius   vertex A is outside the sphere               degree 2
// vertex.side     B is beyond the plane at A, normal A         degree 2; A = B: equal sides
// edge.radius     the line AB is outside the sphere            degree 4; A = B: 0 > 0, never separates
// edge.side       C is beyond the plane along AB               degree 4; C on line AB: 0 > 0
template <class T, class Sink, class Heading>
void still_axes(std::size_t i, const Vec3<T>& a, const Vec3<T>& b, const Vec3<T>& c, const Motion<T>& motion,
                Sink& sink, Heading&& heading) {
  const T offset = dot(a, motion.normal);
  sink(i++, offset * offset, motion.rr * motion.normal2);
  heading(i++, offset * motion.along_normal);

  const T aa = dot(a, a), ab = dot(a, b), ac = dot(a, c), bb = dot(b, b), bc = dot(b, c), cc = dot(c, c);
  const auto vertex = [&](const Vec3<T>& at, const T& square, const T& one, const T& other) {
    sink(i++, square, motion.rr);
    sink(i++, one, square);
    sink(i++, other, square);
    heading(i++, dot(at, motion.d));
  };
  vertex(a, aa, ab, ac);
  vertex(b, bb, ab, bc);
  vertex(c, cc, ac, bc);

  const auto edge = [&](const Vec3<T>& from, const MovingEdge<T>& edge) {
    const Vec3<T> normal = cross(from, edge.along);
    sink(i++, dot(normal, normal), motion.rr * edge.length2);
    sink(i++, motion.zero, dot(normal, motion.normal));
    heading(i++, dot(normal, edge.across));
  };
  edge(a, motion.ab);
  edge(b, motion.bc);
  edge(c, motion.ca);
}

// The static test in two dimensions, seen along D; D = 0 never separates.
//
// vertex.radius   the line of the moving vertex is outside the sphere: W = A x D       degree 4
// vertex.side     the line of B is beyond the plane of that of A, normal D x W         degree 4
// edge.radius     the plane that the edge sweeps is outside the sphere: delta = A.M    degree 6; M = 0 never separates
// edge.side       C is beyond that plane: C.M = delta + m                              degree 6
template <class T, class Sink>
void sweeping_axes(std::size_t i, const Vec3<T>& a, const Vec3<T>& b, const Vec3<T>& c, const Motion<T>& motion,
                   Sink& sink) {
  const Vec3<T> wa = cross(a, motion.d), wb = cross(b, motion.d), wc = cross(c, motion.d);
  const T aa = dot(wa, wa), ab = dot(wa, wb), ac = dot(wa, wc), bb = dot(wb, wb), bc = dot(wb, wc), cc = dot(wc, wc);
  const T limit = motion.rr * dot(motion.d, motion.d);
  const auto vertex = [&](const T& square, const T& one, const T& other) {
    sink(i++, square, limit);
    sink(i++, one, square);
    sink(i++, other, square);
  };
  vertex(aa, ab, ac);
  vertex(bb, ab, bc);
  vertex(cc, ac, bc);

  const auto edge = [&](const Vec3<T>& from, const MovingEdge<T>& edge) {
    const T delta = dot(from, edge.across);
    sink(i++, delta * delta, motion.rr * dot(edge.across, edge.across));
    sink(i++, delta * motion.along_normal, motion.zero);
  };
  edge(a, motion.ab);
  edge(b, motion.bc);
  edge(c, motion.ca);
}

// All 61 comparisons. With `>` in the sides it is right over the reals wherever D.V != 0, and else may invent contacts;
// with `>=` in them it is right for every query.
struct Twenty {
  static constexpr std::string_view name = "twenty";
  static constexpr FormulaeKind kind = FormulaeKind::rung;
  template <class T, class Sink>
  static void comparisons(const MovingSphere::Problem<T>& q, Sink& sink) {
    const Vec3<T> a = q.a - q.p, b = q.b - q.p, c = q.c - q.p;
    Motion<T> motion{
        moving_edge(a, b, q.d), moving_edge(b, c, q.d), moving_edge(c, a, q.d), q.d, {}, {}, {}, q.r * q.r, T(0.0)};
    motion.normal = cross(motion.ab.along, c - a);
    motion.normal2 = dot(motion.normal, motion.normal);
    motion.along_normal = dot(q.d, motion.normal);

    const T& zero = motion.zero;
    still_axes(start_axes, a, b, c, motion, sink, [&](std::size_t i, const T& closing) { sink(i, zero, closing); });
    still_axes(end_axes, a - q.d, b - q.d, c - q.d, motion, sink,
               [&](std::size_t i, const T& closing) { sink(i, closing, zero); });
    sweeping_axes(sweep_axes, a, b, c, motion, sink);
  }
};

struct TwentyNonstrict : Twenty {
  static constexpr std::string_view name = "twenty-nonstrict";
  static constexpr ComparisonBits nonstrict = side_bits;
};

}  // namespace axiscert::moving_sphere

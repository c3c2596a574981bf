// The textbook with one slip each, as published code has it; a kernel of one's own may share it. Each is judged by
// its own formulae, so that what is wrong is called its specification.
#pragma once

#include "kernel/boxes/textbook.h"

namespace axiscert::boxes {

// The textbook's comparisons of B in A's frame.
template <class T, class Sink>
void textbook_of(const Relative<T>& r, Sink& sink) {
  const Matrix<T> size = magnitudes(r.turn);
  facets_of_a(r, size, sink);
  facets_of_b(r, r.half_b, size, sink);
  edge_axes(r, size, size, sink);
}

struct Slip {
  static constexpr FormulaeKind kind = FormulaeKind::variant;
};

// t[1] is T.a2 in place of T.a1. Source: Real-Time Collision Detection, first printing, 4.4.1, in its code; the book's
// errata mend it, and copies of it are about.
struct SlipOfTheBook : Slip {
  static constexpr std::string_view name = "slip-book";
  template <class T, class Sink>
  static void comparisons(const BoxPair<T>& q, Sink& sink) {
    Relative<T> r = relative(q);
    r.along[1] = r.along[2];
    textbook_of(r, sink);
  }
};

// T in the world's axes where A's frame is meant. Source: MathGeoLib, issue 50.
struct SlipOfTheFrame : Slip {
  static constexpr std::string_view name = "slip-frame";
  template <class T, class Sink>
  static void comparisons(const BoxPair<T>& q, Sink& sink) {
    Relative<T> r = relative(q);
    const Vec3<T> between = q.b.centre - q.a.centre;
    r.along = {between.x, between.y, between.z};
    textbook_of(r, sink);
  }
};

// 2^-149 for an epsilon, which adds nothing to an entry of |R| but 0. Source: C#'s float.Epsilon, read as FLT_EPSILON.
struct SlipOfEpsilon : Slip {
  static constexpr std::string_view name = "slip-epsilon";
  template <class T, class Sink>
  static void comparisons(const BoxPair<T>& q, Sink& sink) {
    textbook_with_epsilon(q, T(0x1p-149), sink);
  }
};

// The axes of edges in the world, some of them others than a_i x b_j.
template <class T, class Sink, class Axis>
void with_edge_axes(const BoxPair<T>& q, Sink& sink, Axis&& axis) {
  const Vec3<T> between = q.b.centre - q.a.centre;
  for (std::size_t i = 0; i < axis_count; ++i) {
    const Vec3<T> along = i < 6 ? direction(q, i) : axis((i - 6) / 3, (i - 6) % 3);
    sink(i, magnitude(dot(along, between)), half_extent(q.a, along) + half_extent(q.b, along));
  }
}

// A's interval is asked for where B's is meant, so no axis ever separates. Source: gszauer/GamePhysicsCookbook, issues
// 5 and 13.
struct SlipOfOneInterval : Slip {
  static constexpr std::string_view name = "slip-one-interval";
  template <class T, class Sink>
  static void comparisons(const BoxPair<T>& q, Sink& sink) {
    const Vec3<T> between = q.a.centre - q.a.centre;
    for (std::size_t i = 0; i < axis_count; ++i) {
      const Vec3<T> along = direction(q, i);
      const T extent = half_extent(q.a, along);
      sink(i, magnitude(dot(along, between)), extent + extent);
    }
  }
};

// A's edges against A's own: none of the nine products is of two boxes. Source: gszauer/GamePhysicsCookbook, pull
// request 6 and issue 15.
struct SlipOfOwnEdges : Slip {
  static constexpr std::string_view name = "slip-own-edges";
  template <class T, class Sink>
  static void comparisons(const BoxPair<T>& q, Sink& sink) {
    with_edge_axes<T>(q, sink, [&](std::size_t i, std::size_t j) { return cross(q.a.axis[i], q.a.axis[j]); });
  }
};

// a2 x b2 in place of a1 x b2: one of the fifteen is asked twice and one never. Source: gszauer/gdbooks, issue 2 of
// 3DCollisions.
struct SlipOfOneEdge : Slip {
  static constexpr std::string_view name = "slip-one-edge";
  template <class T, class Sink>
  static void comparisons(const BoxPair<T>& q, Sink& sink) {
    with_edge_axes<T>(
        q, sink, [&](std::size_t i, std::size_t j) { return cross(q.a.axis[i == 1 && j == 2 ? 2 : i], q.b.axis[j]); });
  }
};

}  // namespace axiscert::boxes

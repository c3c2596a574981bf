// The conservative test (kernel/sphere_triangle/certified/conservative_step-inl.h) as a shader would have it, over
// numbers that record, with its barriers named. Sizes are near 1, so that nothing is scaled.
#pragma once

#include <array>
#include <string_view>

#include "kernel/permitted/graph.h"

namespace axiscert::permitted {

// What passes a barrier: the translated vertices and their dot products; also where along each edge the axis is, and
// the plane's normal; also the edges, and the products with the axes.
enum class Barriers { dots, axes, pieces };
// How a + s (b - a) is computed: as it stands, or distributed, (1 - s) a + s b.
enum class Between { stands, distributed };

struct ConservativeShape {
  Barriers barriers;
  Between between;
  // Multiples of w W, w = 2^-23 and W the greatest square: what is taken off a product, and put on a square.
  double error, square_error;
};

// Columns: ax ay az bx by bz cx cy cz px py pz r. Comparisons: of each edge and of the two sides of the plane m > 0 and
// m^2 > R n.n; each pair is a clause.
inline Recording conservative(const Permissions& permissions, const ConservativeShape& shape) {
  using T = RecordedNumber;
  using V = portable::Vec3<T>;
  return recorded(permissions, 10, 0, [&](auto&& load, auto&& sink) {
    Graph& graph = *T::graph;
    const auto kept_from = [&](Barriers from, const T& x) {
      return shape.barriers >= from ? T(graph.kept(x.value)) : x;
    };
    const auto kept_vector = [&](Barriers from, const V& v) {
      return V{kept_from(from, v.x), kept_from(from, v.y), kept_from(from, v.z)};
    };
    const auto piece = [&](const T& x) { return kept_from(Barriers::pieces, x); };
    const auto vector = [&](std::size_t k) { return V{load(k), load(k + 1), load(k + 2)}; };
    const V p = vector(9);
    const auto centred = [&](std::size_t k) { return kept_vector(Barriers::dots, vector(k) - p); };
    const V A = centred(0), B = centred(3), C = centred(6);
    const T r = load(12), zero(0.0), one(1.0);
    const auto least = [&](const T& x, const T& y) { return T(graph.least(x.value, y.value)); };
    const auto greatest = [&](const T& x, const T& y) { return T(graph.greatest(x.value, y.value)); };
    const auto dot_of = [&](const V& u, const V& v) { return kept_from(Barriers::dots, dot(u, v)); };
    const T aa = dot_of(A, A), bb = dot_of(B, B), cc = dot_of(C, C), ab = dot_of(A, B), bc = dot_of(B, C),
            ca = dot_of(C, A), rr = kept_from(Barriers::dots, r * r);
    const T W = kept_from(Barriers::axes, greatest(greatest(aa, bb), greatest(cc, rr)));
    const T error = T(shape.error * 0x1p-23) * W, square_error = T(shape.square_error * 0x1p-23) * W;
    const T R = piece(rr + square_error);
    std::size_t next = 0;
    const auto axis = [&](const T& m, const T& square) {
      sink(next++, m, zero);
      sink(next++, m * m, R * square);
    };
    const auto between = [&](const T& x, const T& y, const T& s) {
      return piece(shape.between == Between::stands ? x + s * (y - x) : (one - s) * x + s * y);
    };
    const auto edge = [&](const V& X, const V& along, const T& xx, const T& xy, const T& yy, const T& xz, const T& yz) {
      const T at = (zero - dot(X, along)) / piece(dot(along, along));
      const T s = kept_from(Barriers::axes, least(greatest(at, zero), one));
      const T at_x = between(xx, xy, s), at_y = between(xy, yy, s), at_z = between(xz, yz, s);
      const T m = piece(least(least(at_x, at_y), at_z) - error);
      axis(m, piece(between(at_x, at_y, s) + square_error));
    };
    const V AB = kept_vector(Barriers::pieces, B - A), BC = kept_vector(Barriers::pieces, C - B),
            CA = kept_vector(Barriers::pieces, A - C);
    edge(A, AB, aa, ab, bb, ca, bc);
    edge(B, BC, bb, bc, cc, ab, ca);
    edge(C, CA, cc, ca, aa, bc, ab);
    const V n = kept_vector(Barriers::axes, cross(CA, AB));
    const T at_a = piece(dot(A, n)), at_b = piece(dot(B, n)), at_c = piece(dot(C, n)), square = piece(dot(n, n));
    axis(piece(least(least(at_a, at_b), at_c)), square);
    axis(piece(least(least(zero - at_a, zero - at_b), zero - at_c)), square);
  });
}

// The predicate that these comparisons make: any clause separates.
inline Predicate conservative_predicate() {
  Predicate predicate;
  predicate.id = "conservative";
  for (std::size_t i = 0; i < 10; ++i) predicate.comparisons.push_back({"", i / 2, i % 2 == 1});
  for (std::size_t i = 0; i < 5; ++i) predicate.clauses.push_back({"", ComparisonBits{3} << (2 * i)});
  return predicate;
}

}  // namespace axiscert::permitted

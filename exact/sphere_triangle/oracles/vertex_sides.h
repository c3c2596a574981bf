// The exact sides of one comparison of a vertex axis, of degree 2, without the other fifteen.
#pragma once

#include "exact/sphere_triangle/oracles/exact_truth.h"

namespace axiscert {

// Whether a comparison is one of the nine of the vertices, which are the same in the published formulae and in all
// reduced forms.
constexpr bool is_of_vertex(std::size_t comparison) {
  constexpr std::size_t first = index_of(Comparison::vertex_a_radius), last = index_of(Comparison::vertex_c_side_b);
  return comparison >= first && comparison <= last;
}

class VertexSides {
 public:
  // `comparison` is one of the nine.
  template <class Real>
  VertexSides(const Query<Real>& q, std::size_t comparison) {
    // For each vertex: its radius, and the sides of the two others in their order.
    const std::size_t number = comparison - index_of(Comparison::vertex_a_radius);
    const std::size_t of = number / 3, place = number % 3;
    const std::array<const Vec3<Real>*, 3> vertices = {&q.a, &q.b, &q.c};
    const auto exact = [](Real x) { return BinaryNumber(static_cast<double>(x)); };
    const auto centred = [&](std::size_t i) {
      const Vec3<Real>& v = *vertices[i];
      return Vec3<BinaryNumber>{exact(v.x) - exact(q.p.x), exact(v.y) - exact(q.p.y), exact(v.z) - exact(q.p.z)};
    };
    const Vec3<BinaryNumber> vertex = centred(of);
    const BinaryNumber square = dot(vertex, vertex);
    if (place == 0) {
      const BinaryNumber r = exact(q.r);
      lhs_.over = square;
      rhs_.over = r * r;
    } else {
      const std::size_t other = place == 1 ? (of == 0 ? 1 : 0) : (of == 2 ? 1 : 2);
      lhs_.over = dot(vertex, centred(other));
      rhs_.over = square;
    }
  }
  VertexSides(const VertexSides&) = delete;

  ExactComparison comparison() const { return {lhs_, rhs_}; }

 private:
  BinaryFraction lhs_, rhs_;
};

}  // namespace axiscert

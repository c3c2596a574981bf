// The exact sides of one comparison of a vertex axis, of degree 2, without the other fifteen.
#pragma once

#include "exact/sphere_triangle/oracles/formula_oracle.h"

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
    const auto ring = [](Real x) { return Ring(static_cast<double>(x)); };
    const auto centred = [&](std::size_t i) {
      const Vec3<Real>& v = *vertices[i];
      return Vec3<Ring>{ring(v.x) - ring(q.p.x), ring(v.y) - ring(q.p.y), ring(v.z) - ring(q.p.z)};
    };
    const Vec3<Ring> vertex = centred(of);
    const Ring square = dot(vertex, vertex);
    if (place == 0) {
      const Ring r = ring(q.r);
      lhs_ = square;
      rhs_ = r * r;
    } else {
      const std::size_t other = place == 1 ? (of == 0 ? 1 : 0) : (of == 2 ? 1 : 2);
      lhs_ = dot(vertex, centred(other));
      rhs_ = square;
    }
  }
  VertexSides(const VertexSides&) = delete;

  ExactComparison comparison() const { return {lhs_, rhs_, one_, false, false}; }

 private:
  Ring lhs_, rhs_, one_{1};
};

}  // namespace axiscert

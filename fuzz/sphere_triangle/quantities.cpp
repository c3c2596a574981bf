// The sizes in a query of sphere-triangle with which a kernel may compare an absolute number.
#include <algorithm>
#include <array>
#include <cmath>

#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "fuzz/sphere_triangle/confirm.h"

namespace axiscert {
namespace {

constexpr std::array<Quantity, 18> size_names = {{{"the distance d", 1},
                                                  {"r", 1},
                                                  {"|d - r|", 1},
                                                  {"|d^2 - r^2|", 2},
                                                  {"|AB x AC|", 2},
                                                  {"the shortest edge", 1},
                                                  {"the edge next to P", 1},
                                                  {"the longest edge", 1},
                                                  {"the distance from P to the nearest vertex", 1},
                                                  {"the distance from P to the farthest vertex", 1},
                                                  {"the greatest coordinate", 1},
                                                  {"the least determinant of P with an edge and the normal", 4},
                                                  {"AP . (AB x AC)", 3},
                                                  {"(AP . V)^2 - r^2 V^2, with V = AB x AC", 6},
                                                  {"the distance to the plane", 1},
                                                  {"AB", 1},
                                                  {"BC", 1},
                                                  {"CA", 1}}};

double length_of(const Vec3<double>& v) { return std::sqrt(dot(v, v)); }

double squared_distance_to(const Vec3<double>& u, const Vec3<double>& v) {
  const Vec3<double> w = v - u;
  const double along = -dot(u, w), whole = dot(w, w);
  const double t = along <= 0 ? 0 : along >= whole ? 1 : along / whole;
  const Vec3<double> nearest = u + w * t;
  return dot(nearest, nearest);
}

template <class Real>
std::vector<double> values_of(const Query<Real>& base) {
  const Query<double> q = widened(base);
  const Rational exact_square = squared_distance(base), radius = exact(q.r);
  const double dd = nearest<double>(exact_square), d = std::sqrt(dd);
  const double gap = std::abs(nearest<double>(Rational(exact_square - radius * radius)));
  const std::array<Vec3<double>, 3> v = {q.a - q.p, q.b - q.p, q.c - q.p};
  const Vec3<double> normal = cross(v[1] - v[0], v[2] - v[0]);
  std::array<double, 3> edges, vertices, sides;
  std::size_t next_to = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t to = (i + 1) % 3, last = next_to;
    edges[i] = length_of(v[to] - v[i]);
    vertices[i] = length_of(v[i]);
    sides[i] = dot(cross(v[i], v[to]), normal);
    if (squared_distance_to(v[i], v[to]) < squared_distance_to(v[last], v[(last + 1) % 3])) next_to = i;
  }
  double greatest = 0;
  for (const auto& point : {q.a, q.b, q.c, q.p}) {
    greatest = std::max({greatest, std::abs(point.x), std::abs(point.y), std::abs(point.z)});
  }
  const double offset = dot(v[0], normal), ee = dot(normal, normal);
  const auto [least_edge, greatest_edge] = std::minmax_element(edges.begin(), edges.end());
  const auto [least_vertex, greatest_vertex] = std::minmax_element(vertices.begin(), vertices.end());
  return {d,
          q.r,
          d + q.r > 0 ? gap / (d + q.r) : 0,
          gap,
          std::sqrt(ee),
          *least_edge,
          edges[next_to],
          *greatest_edge,
          *least_vertex,
          *greatest_vertex,
          greatest,
          *std::min_element(sides.begin(), sides.end()),
          std::abs(offset),
          std::abs(offset * offset - q.r * q.r * ee),
          ee > 0 ? std::abs(offset) / std::sqrt(ee) : 0,
          edges[0],
          edges[1],
          edges[2]};
}

class SphereTriangleQuantities final : public Quantities {
 public:
  std::span<const Quantity> all() const override { return size_names; }
  std::vector<double> values(const Numbers<float>& query) const override { return values_of<float>(query); }
  std::vector<double> values(const Numbers<double>& query) const override { return values_of<double>(query); }
};

}  // namespace

const Quantities& sphere_triangle_quantities() {
  static const SphereTriangleQuantities quantities;
  return quantities;
}

}  // namespace axiscert

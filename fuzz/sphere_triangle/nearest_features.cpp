#include "fuzz/queries/nearest_features.h"

#include <array>

#include "exact/numbers/rational.h"
#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "fuzz/sphere_triangle/confirm.h"
#include "kernel/sphere_triangle/names.h"

namespace axiscert {
namespace {

Vec3<Rational> rational(const Vec3<double>& v) { return {Rational(v.x), Rational(v.y), Rational(v.z)}; }

// The distance to the triangle by CGAL, with which the distances to vertices and edges are compared.
class SphereTriangleFeatures final : public NearestFeatures {
 public:
  std::vector<std::string_view> of(const Numbers<float>& q) const override { return names(widened(query_from(q))); }
  std::vector<std::string_view> of(const Numbers<double>& q) const override { return names(query_from(q)); }

 private:
  static std::vector<std::string_view> names(const Query<double>& q) {
    static constexpr std::array vertices = {Axis::vertex_a, Axis::vertex_b, Axis::vertex_c};
    static constexpr std::array edges = {Axis::edge_ab, Axis::edge_bc, Axis::edge_ca};
    const Vec3<Rational> p = rational(q.p);
    const std::array<Vec3<Rational>, 3> corner = {rational(q.a), rational(q.b), rational(q.c)};
    const Rational least = squared_distance(q);
    std::vector<std::string_view> all;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3<Rational> v = p - corner[i];
      if (dot(v, v) == least) all.push_back(axis_names[vertices[i]]);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3<Rational> edge = corner[(i + 1) % 3] - corner[i], v = p - corner[i];
      const Rational length = dot(edge, edge), foot = dot(v, edge);  // squared, and times it
      if (foot > 0 && foot < length && dot(v, v) - foot * foot / length == least) all.push_back(axis_names[edges[i]]);
    }
    if (all.empty()) all.emplace_back("face");
    return all;
  }
};

}  // namespace

const NearestFeatures& sphere_triangle_nearest_features() {
  static const SphereTriangleFeatures features;
  return features;
}

}  // namespace axiscert

#include "fuzz/queries/nearest_features.h"

#include <array>

#include "exact/numbers/rational.h"
#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "fuzz/sphere_triangle/confirm.h"

namespace axiscert {
namespace {

using RationalVector = std::array<Rational, 3>;

RationalVector difference_of(const Vec3<double>& to, const Vec3<double>& from) {
  const auto one = [](double x, double y) { return Rational(Rational(x) - Rational(y)); };
  return {one(to.x, from.x), one(to.y, from.y), one(to.z, from.z)};
}
Rational product_of(const RationalVector& v, const RationalVector& w) {
  return Rational(v[0] * w[0] + v[1] * w[1] + v[2] * w[2]);
}

// The distance to the triangle by CGAL, with which the distances to vertices and edges are compared.
class SphereTriangleFeatures final : public NearestFeatures {
 public:
  std::vector<std::string_view> of(const Numbers<float>& q) const override { return names(widened(query_from(q))); }
  std::vector<std::string_view> of(const Numbers<double>& q) const override { return names(query_from(q)); }

 private:
  static std::vector<std::string_view> names(const Query<double>& q) {
    static constexpr std::array<std::string_view, 3> vertices = {"vertex_a", "vertex_b", "vertex_c"};
    static constexpr std::array<std::string_view, 3> edges = {"edge_ab", "edge_bc", "edge_ca"};
    const std::array<Vec3<double>, 3> corner = {q.a, q.b, q.c};
    const Rational least = squared_distance(q);
    std::vector<std::string_view> all;
    for (std::size_t i = 0; i < 3; ++i) {
      const RationalVector v = difference_of(q.p, corner[i]);
      if (product_of(v, v) == least) all.push_back(vertices[i]);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const RationalVector edge = difference_of(corner[(i + 1) % 3], corner[i]), v = difference_of(q.p, corner[i]);
      const Rational length = product_of(edge, edge), foot = product_of(v, edge);  // squared, and times it
      if (foot > 0 && foot < length && product_of(v, v) - foot * foot / length == least) all.push_back(edges[i]);
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

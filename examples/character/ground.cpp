#include "examples/character/ground.h"

#include <algorithm>
#include <numeric>

#include "exact/sphere_triangle/oracles/exact_truth.h"

namespace axiscert::character {
namespace {

void box_of(const std::vector<MeshTriangle>& triangles, Point& low, Point& high) {
  low = high = point(triangles[0][0]);
  for (const MeshTriangle& t : triangles) {
    for (const Vec3<float>& v : t) {
      const Point at = point(v);
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], at[k]);
        high[k] = std::max(high[k], at[k]);
      }
    }
  }
}

using Vector = Vec3<double>;
Vector vector(const Point& p) { return {p[0], p[1], p[2]}; }

struct Nearest {
  Vector at;
  double squared;
};

Nearest nearest_on_segment(const Vector& a, const Vector& b, const Vector& p) {
  const Vector ab = b - a, ap = p - a;
  const double length = portable::dot(ab, ab);
  const double along = length > 0 ? std::clamp(portable::dot(ap, ab) / length, 0.0, 1.0) : 0;
  const Vector at = a + ab * along;
  return {at, portable::dot(p - at, p - at)};
}

}  // namespace

Ground::Ground(std::vector<MeshTriangle> triangles, std::size_t up)
    : triangles_(std::move(triangles)), indices_(3 * triangles_.size()), up_(up), broad_phase_(triangles_) {
  std::iota(indices_.begin(), indices_.end(), 0u);
  for (const MeshTriangle& t : triangles_) {
    const Vec3<BinaryNumber> normal = exact_normal(Query<float>{t[0], t[1], t[2], {}, 0});
    has_area_.push_back(!normal.x.is_zero() || !normal.y.is_zero() || !normal.z.is_zero());
  }
  box_of(triangles_, low_, high_);
}

std::size_t thinnest_axis(const std::vector<MeshTriangle>& triangles) {
  Point low, high;
  box_of(triangles, low, high);
  std::size_t thinnest = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    if (high[k] - low[k] <= high[thinnest] - low[thinnest]) thinnest = k;
  }
  return thinnest;
}

// The nearest of the three edges' points and, if it is inside, of the foot on the plane. A triangle without area has
// only its edges.
Point nearest_point(const MeshTriangle& triangle, const Point& to) {
  const Vector p = vector(to);
  const std::array<Vector, 3> v = {vector(point(triangle[0])), vector(point(triangle[1])), vector(point(triangle[2]))};
  Nearest best = nearest_on_segment(v[0], v[1], p);
  for (std::size_t k = 1; k < 3; ++k) {
    const Nearest next = nearest_on_segment(v[k], v[(k + 1) % 3], p);
    if (next.squared < best.squared) best = next;
  }
  const Vector normal = portable::cross(v[1] - v[0], v[2] - v[0]);
  const double square = portable::dot(normal, normal);
  bool inside = square > 0;
  for (std::size_t k = 0; k < 3; ++k) {
    inside = inside && portable::dot(portable::cross(v[(k + 1) % 3] - v[k], p - v[k]), normal) >= 0;
  }
  if (inside) best.at = p - normal * (portable::dot(p - v[0], normal) / square);
  return {best.at.x, best.at.y, best.at.z};
}

}  // namespace axiscert::character

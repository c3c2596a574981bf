#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "examples/character/ground.h"

namespace axiscert::character {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

// A triangle represented by its box only, which a triangle without area has too.
class Box {
 public:
  using Id = const MeshTriangle*;
  using Datum = Kernel::Iso_cuboid_3;
  using Point = Kernel::Point_3;

  explicit Box(Id t) : triangle_(t) {
    const auto& [a, b, c] = *t;
    cuboid_ = {std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y}), std::min({a.z, b.z, c.z}),
               std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y}), std::max({a.z, b.z, c.z})};
  }
  Id id() const { return triangle_; }
  const Datum& datum() const { return cuboid_; }
  Point reference_point() const { return (cuboid_.min)(); }

 private:
  Id triangle_;
  Datum cuboid_;
};

// P - r and P + r are rounded in double where the two are far apart; they are moved outwards, so that no contact is
// left out.
double below(double x) { return std::nextafter(x, -std::numeric_limits<double>::infinity()); }
double above(double x) { return std::nextafter(x, std::numeric_limits<double>::infinity()); }

CGAL::Bbox_3 box_of(const CentreBox& centre, double r) {
  const auto& [low, high] = centre;
  return {below(low[0] - r),  below(low[1] - r),  below(low[2] - r),
          above(high[0] + r), above(high[1] + r), above(high[2] + r)};
}

}  // namespace

struct BroadPhase::Tree {
  const MeshTriangle* first;
  CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Box>> boxes;
};

BroadPhase::BroadPhase(const std::vector<MeshTriangle>& triangles) : tree_(std::make_unique<Tree>(triangles.data())) {
  tree_->boxes.insert(triangles.data(), triangles.data() + triangles.size());
  tree_->boxes.build();
}
BroadPhase::~BroadPhase() = default;

void BroadPhase::candidates(const Sphere& sphere, std::vector<std::uint32_t>& out) const {
  const Point centre = point(sphere.centre);
  candidates(std::array{CentreBox{centre, centre}}, sphere.radius, out);
}

void BroadPhase::candidates(std::span<const CentreBox> boxes, float radius, std::vector<std::uint32_t>& out) const {
  std::vector<const MeshTriangle*> found;
  for (const CentreBox& box : boxes) {
    tree_->boxes.all_intersected_primitives(box_of(box, radius), std::back_inserter(found));
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  out.clear();
  for (const MeshTriangle* t : found) out.push_back(static_cast<std::uint32_t>(t - tree_->first));
}

}  // namespace axiscert::character

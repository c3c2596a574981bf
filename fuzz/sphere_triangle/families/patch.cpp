// A triangle of a mesh and its three neighbours, in metres, beside one sphere over the face or an edge that they share:
// four queries after each other. Of a level floor the sphere rests on one of them, and what engines report of the
// others, with a normal that leans, stops a character at an edge within the floor.
#include <cmath>

#include "fuzz/queries/family.h"
#include "fuzz/sphere_triangle/families/parts/scene.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

using scenes::Point;
constexpr std::uint64_t triangles = 4;

// In turn level, bent by up to 1 in 64 and by up to 1 in 4, both ways; over the middle triangle's face and over an
// edge.
template <class Real>
Query<Real> patch(Stream& random, std::uint64_t position) {
  const std::uint64_t scene = position / triangles, which = position % triangles;
  const Real r = scenes::radius<Real>(random);
  const double height = static_cast<double>(r) + scenes::gap(random, scene);
  const std::uint64_t kind = scene / scenes::gap_count;
  const auto world = scenes::place(random, kind / 6);
  const auto axes = scenes::axes(random, random.coin());
  const auto middle = scenes::triangle_of_ground(random);
  const auto foot = scenes::foot_on_ground(random, kind / 3 % 2, middle, static_cast<double>(r));
  const double bend = kind % 3 == 0 ? 0 : kind % 3 == 1 ? 0x1p-6 : 0x1p-2;
  std::array<Point, 3> tips;
  for (std::size_t k = 0; k < 3; ++k) {
    // Beyond edge k: the opposite corner through the middle of the edge.
    const Point at = middle[k] + middle[shapes::next(k)] - middle[shapes::opposite(k)];
    const Point edge = middle[shapes::next(k)] - middle[k], area = cross(edge, at - middle[k]);
    const double lift = bend * random.symmetric<double>();
    tips[k] = {at.x, at.y, lift * std::sqrt(dot(area, area) / dot(edge, edge))};
  }
  std::array<Point, 3> corners = middle;
  if (which != 0) {
    const std::size_t k = static_cast<std::size_t>(which) - 1;
    corners = {middle[shapes::next(k)], middle[k], tips[k]};
  }
  for (Point& corner : corners) corner = corner - foot;
  return scenes::query(random, world, axes, corners, {0, 0, height}, r);
}

template <class Real>
void fill_patches(const StreamName& name, std::uint64_t first, const MutableColumns<Real>& out) {
  for (std::size_t i = 0; i < out.size; ++i) {
    Stream random(name, (first + i) / triangles);
    out.set(i, patch<Real>(random, first + i));
  }
}

}  // namespace

extern const Family patch_family = by_name(
    {sphere_triangle_predicate, "patch",
     "metres: a triangle of a mesh and its three neighbours, level or bent, beside one sphere on the face or an edge",
     1, false, fill_patches<float>, fill_patches<double>});

}  // namespace axiscert

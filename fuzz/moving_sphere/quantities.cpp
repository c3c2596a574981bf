// The sizes in a motion with which a kernel may compare an absolute number.
#include "fuzz/moving_sphere/quantities.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "exact/moving_sphere/motion_distance.h"
#include "kernel/moving_sphere/moving_sphere.h"

namespace axiscert::moving_sphere {
namespace {

using portable::cross;
using portable::dot;
using portable::Vec3;
using Double3 = Vec3<double>;

constexpr Quantity names[] = {{"the motion |D|", 1},
                              {"r", 1},
                              {"the least distance on the way", 1},
                              {"|that distance - r|", 1},
                              {"the shortest edge", 1},
                              {"the longest edge", 1},
                              {"the distance from P to the nearest vertex", 1},
                              {"the distance from P to the plane", 1},
                              {"the greatest coordinate", 1, true},
                              {"|AB x AC|", 2},
                              {"the least |D x edge|", 2},
                              {"|D . edge| of the edge most along it", 2},
                              {"D . (AB x AC)", 3},
                              {"AP . (AB x AC)", 3},
                              {"the least |D x edge|^2 - r^2 edge^2", 4},
                              {"AB", 1},
                              {"BC", 1},
                              {"CA", 1}};

double extent_of(const Double3& v) { return std::sqrt(dot(v, v)); }

std::vector<double> values_of(const GivenMotion& q) {
  const Double3 d = q.displacement<double>([](double x) { return x; });
  const std::array<Double3, 3> edge = {q.b - q.a, q.c - q.b, q.a - q.c}, vertex = {q.a - q.p, q.b - q.p, q.c - q.p};
  const Double3 normal = cross(edge[0], q.c - q.a);
  std::array<double, 3> edges, vertices, across, along, discriminants;
  for (std::size_t k = 0; k < 3; ++k) {
    edges[k] = extent_of(edge[k]);
    vertices[k] = extent_of(vertex[k]);
    across[k] = extent_of(cross(d, edge[k]));
    along[k] = std::abs(dot(d, edge[k]));
    discriminants[k] = std::abs(across[k] * across[k] - q.r * q.r * edges[k] * edges[k]);
  }
  double greatest = 0;
  for (const Double3& point : {q.a, q.b, q.c, q.p})
    greatest = std::max({greatest, std::abs(point.x), std::abs(point.y), std::abs(point.z)});
  const double least = std::sqrt(nearest<double>(least_distance(q).squared)), area = extent_of(normal),
               height = std::abs(dot(vertex[0], normal));
  const auto [shortest, longest] = std::ranges::minmax(edges);
  return {extent_of(d),
          q.r,
          least,
          std::abs(least - q.r),
          shortest,
          longest,
          std::ranges::min(vertices),
          area > 0 ? height / area : 0,
          greatest,
          area,
          std::ranges::min(across),
          std::ranges::max(along),
          std::abs(dot(d, normal)),
          height,
          std::ranges::min(discriminants),
          edges[0],
          edges[1],
          edges[2]};
}

class MotionQuantities final : public Quantities {
 public:
  std::span<const Quantity> all() const override { return names; }
  std::vector<double> values(std::size_t entry, const Numbers<float>& query) const override { return of(entry, query); }
  std::vector<double> values(std::size_t entry, const Numbers<double>& query) const override {
    return of(entry, query);
  }

 private:
  static std::vector<double> of(std::size_t entry, const auto& query) {
    const auto load = [&](std::size_t k) { return static_cast<double>(query[k]); };
    if (entry == MovingEnds::entry) return values_of(MovingEnds::problem<double>(load));
    return values_of(MovingSphere::problem<double>(load));
  }
};

}  // namespace

const Quantities& quantities() {
  static const MotionQuantities all;
  return all;
}

}  // namespace axiscert::moving_sphere

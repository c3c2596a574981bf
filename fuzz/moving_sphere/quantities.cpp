// The sizes in a motion with which a kernel may compare an absolute number.
#include "fuzz/moving_sphere/capability_parts.h"

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

// The point of a triangle that is nearest to 0: among those of its edges and, where that is inside, of its plane.
Double3 nearest_of(const std::array<Double3, 3>& v) {
  Double3 nearest = v[0];
  const auto note = [&](const Double3& point) {
    if (dot(point, point) < dot(nearest, nearest)) nearest = point;
  };
  for (std::size_t k = 0; k < 3; ++k) {
    const Double3 edge = v[(k + 1) % 3] - v[k];
    const double squared = dot(edge, edge);
    if (squared > 0) note(v[k] + edge * std::clamp(-dot(v[k], edge) / squared, 0.0, 1.0));
  }
  const Double3 normal = cross(v[1] - v[0], v[2] - v[0]);
  const double a = dot(normal, cross(v[1], v[2])), b = dot(normal, cross(v[2], v[0])),
               c = dot(normal, cross(v[0], v[1]));
  if (a > 0 && b > 0 && c > 0) note((v[0] * a + v[1] * b + v[2] * c) * (1 / (a + b + c)));
  return nearest;
}

// The distance is convex in the time, and falls as long as the centre moves towards the nearest point.
double rough_depth_of(const GivenMotion& q) {
  const Double3 d = q.displacement<double>([](double x) { return x; });
  const auto seen = [&](double t) {
    const Double3 centre = q.p + d * t;
    return std::array<Double3, 3>{q.a - centre, q.b - centre, q.c - centre};
  };
  double scene = q.r, first = 0, last = 1;
  for (const double t : {first, last}) {
    for (const Double3& v : seen(t)) scene = std::max(scene, extent_of(v));
  }
  double least = std::min(extent_of(nearest_of(seen(first))), extent_of(nearest_of(seen(last))));
  for (int step = 0; step < 50; ++step) {
    const double middle = (first + last) / 2;
    const Double3 nearest = nearest_of(seen(middle));
    least = std::min(least, extent_of(nearest));
    (dot(nearest, d) > 0 ? first : last) = middle;
  }
  return scene > 0 ? (q.r - least) / scene : 0;
}

GivenMotion motion(std::size_t entry, const Numbers<double>& query) {
  const auto load = [&](std::size_t k) { return query[k]; };
  if (entry == MovingEnds::entry) return MovingEnds::problem<double>(load);
  return MovingSphere::problem<double>(load);
}

}  // namespace

const Quantities& quantities() {
  static constexpr Quantities all = {
      names, [](std::size_t entry, const Numbers<double>& q) { return values_of(motion(entry, q)); },
      [](std::size_t entry, const Numbers<double>& q) { return rough_depth_of(motion(entry, q)); }};
  return all;
}

}  // namespace axiscert::moving_sphere

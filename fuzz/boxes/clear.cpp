#include "fuzz/boxes/clear.h"

#include <algorithm>
#include <limits>

namespace axiscert::boxes {
namespace {

struct Extent {
  double low, high;
};
Extent extent_along(const std::vector<Arrow>& corners, const Arrow& axis) {
  Extent found{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const Arrow& corner : corners) {
    const double at = dot(axis, corner);
    found.low = std::min(found.low, at);
    found.high = std::max(found.high, at);
  }
  return found;
}

double gap_along(const ClearScene& scene, const Arrow& axis, const Arrow& by) {
  const Extent a = extent_along(scene.a, axis), b = extent_along(scene.b, axis);
  const double moved = dot(axis, by);
  return std::max((moved + b.low) - a.high, (a.low - moved) - b.high);
}

std::vector<Arrow> corners_of(const OrientedBox<double>& box) {
  std::vector<Arrow> corners;
  for (unsigned k = 0; k < 8; ++k) {
    Arrow sum{0, 0, 0};
    for (std::size_t i = 0; i < 3; ++i) sum = sum + box.axis[i] * (has_bit(k, i) ? box.half[i] : -box.half[i]);
    corners.push_back(sum);
  }
  return corners;
}

double arrow_length(const Arrow& v) { return std::sqrt(dot(v, v)); }

// The vector of length 1; 0 for a product of vectors whose angle is below a part in 2^40.
Arrow unit_axis(const Arrow& v, double lengths) {
  const double own = arrow_length(v);
  return own > lengths * 0x1p-40 ? v / own : Arrow{0, 0, 0};
}

void set_size(ClearScene& scene) {
  scene.size = 0;
  for (const auto* body : {&scene.a, &scene.b}) {
    for (const Arrow& corner : *body) scene.size = std::max(scene.size, arrow_length(corner));
  }
}

// A point at random of the part of a body that is farthest along `way`, within a rounding.
Arrow farthest_point(Stream& random, const std::vector<Arrow>& corners, const Arrow& way, double size) {
  double most = -std::numeric_limits<double>::infinity();
  for (const Arrow& corner : corners) most = std::max(most, dot(way, corner));
  Arrow sum{0, 0, 0};
  double weights = 0;
  for (const Arrow& corner : corners) {
    const double weight = random.unit<double>() + 0x1p-6;
    if (dot(way, corner) < most - size * 0x1p-24) continue;
    sum = sum + corner * weight;
    weights += weight;
  }
  return sum / weights;
}

}  // namespace

ClearScene scene_of(const BoxPair<double>& q) {
  ClearScene scene{corners_of(q.a), corners_of(q.b), {}, 0};
  const auto edge = [&](std::size_t i) { return i < 3 ? arrow_length(q.a.axis[i]) : arrow_length(q.b.axis[i - 3]); };
  for (std::size_t i = 0; i < axis_count; ++i) {
    const double lengths = i < 3   ? edge(next(i)) * edge(last(i))
                           : i < 6 ? edge(3 + next(i - 3)) * edge(3 + last(i - 3))
                                   : edge((i - 6) / 3) * edge(3 + (i - 6) % 3);
    scene.axis.push_back(unit_axis(direction(q, i), lengths));
  }
  set_size(scene);
  return scene;
}

ClearScene scene_of(const BoxAndTriangle<double>& q) {
  ClearScene scene{corners_of(q.box), {}, {}, 0};
  for (const Arrow& corner : q.corner) scene.b.push_back(corner - q.corner[0]);
  const auto edge = [&](std::size_t j) { return arrow_length(triangle_edge(q.corner, j)); };
  for (std::size_t i = 0; i < thirteen_count; ++i) {
    const double lengths = i < 3             ? arrow_length(q.box.axis[next(i)]) * arrow_length(q.box.axis[last(i)])
                           : i == plane_axis ? edge(0) * edge(2)
                                             : arrow_length(q.box.axis[(i - 4) / 3]) * edge((i - 4) % 3);
    scene.axis.push_back(unit_axis(direction(q, i), lengths));
  }
  set_size(scene);
  return scene;
}

double gap_at(const ClearScene& scene, const Arrow& by) {
  double gap = -std::numeric_limits<double>::infinity();
  for (const Arrow& axis : scene.axis) {
    if (axis.x != 0 || axis.y != 0 || axis.z != 0) gap = std::max(gap, gap_along(scene, axis, by));
  }
  return gap;
}

ClearPlace place_on_axis(Stream& random, const ClearScene& scene, std::size_t axis, Side side, double most) {
  const Arrow way = random.coin() ? scene.axis[axis] : scene.axis[axis] * -1.0;
  const double share = 0.25 + 0.25 * random.unit<double>();
  const Arrow of_a = farthest_point(random, scene.a, way, scene.size),
              of_b = farthest_point(random, scene.b, way * -1.0, scene.size), touching = of_a - of_b;
  // The room that the other axes leave there. An axis that is the same but for roundings decides with it.
  double left = std::numeric_limits<double>::infinity();
  for (const Arrow& other : scene.axis) {
    const Arrow across = cross(other, way);
    const bool is_same = dot(across, across) < 0x1p-60, is_none = dot(other, other) == 0;
    if (!is_same && !is_none) left = std::min(left, -gap_along(scene, other, touching));
  }
  const double margin = dot(way, way) == 0 ? 0 : std::max(0.0, std::min(left * share, most * (2 * share)));
  return {touching + way * (side == Side::apart ? margin : -margin), margin};
}

}  // namespace axiscert::boxes

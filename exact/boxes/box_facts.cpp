#include "exact/boxes/box_facts.h"

#include <algorithm>
#include <array>

namespace axiscert::boxes {
namespace {

constexpr std::string_view not_the_only_one = "not the only one";

// Whether all directions are one.
bool is_one_direction(const std::vector<AxisRest>& axes) {
  const Point& first = axes.front().along;
  return std::ranges::all_of(axes, [&](const AxisRest& axis) {
    const Point turn = cross(first, axis.along);
    return !axis.either_way && dot(turn, turn) == 0 && dot(first, axis.along) > 0;
  });
}

template <class Bodies>
std::vector<ExactFact> facts_of(const Bodies& q, const Hull& a, const Hull& b,
                                const std::array<std::string_view, 2>& points) {
  const NearestPair nearest = nearest_pair(a, b);
  Point way = nearest.b - nearest.a;
  Rational square = dot(way, way);
  const bool is_apart = square != 0;
  std::string_view other_ways;
  if (!is_apart) {
    const std::vector<AxisRest> least = deciding(axis_rests(q));
    way = least.front().along;
    square = least.front().squared();
    if (!is_one_direction(least)) other_ways = not_the_only_one;
  }
  const Rational scene = squared_scene(q);
  std::vector<ExactFact> facts = {length_fact(is_apart ? "distance" : "penetration", {0, square}),
                                  depth_fact({square, 0, scene == 0 ? Rational(1) : scene}),
                                  direction_fact("normal", way.x, way.y, way.z)};
  facts.back().note = other_ways;
  if (!is_apart && square != 0) return facts;
  const std::string_view other_points = is_only_pair(nearest, way, a, b) ? "" : not_the_only_one;
  for (const auto& [name, point] : {std::pair(points[0], &nearest.a), std::pair(points[1], &nearest.b)})
    facts.emplace_back(place_fact(name, point->x, point->y, point->z)).note = other_points;
  return facts;
}

}  // namespace

std::vector<ExactFact> exact_facts(const ExactPair& q) {
  return facts_of(q, corners_of(q.a), corners_of(q.b), {"nearest_point_a", "nearest_point_b"});
}

std::vector<ExactFact> exact_facts(const ExactBoxAndTriangle& q) {
  return facts_of(q, corners_of(q.box), hull_of(q.corner), {"nearest_point_box", "nearest_point_triangle"});
}

}  // namespace axiscert::boxes

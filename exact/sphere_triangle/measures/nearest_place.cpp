#include "exact/sphere_triangle/measures/nearest_place.h"

#include <array>

#include "exact/judge/judge.h"
#include "exact/sphere_triangle/measures/depth.h"
#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "kernel/sphere_triangle/names.h"

namespace axiscert {
namespace {

using Place = Vec3<Rational>;

Place rational_place(const Vec3<double>& v) { return {Rational(v.x), Rational(v.y), Rational(v.z)}; }

}  // namespace

NearestPlace nearest_place(const Query<double>& q) {
  static constexpr std::array vertices = {Axis::vertex_a, Axis::vertex_b, Axis::vertex_c};
  static constexpr std::array edges = {Axis::edge_ab, Axis::edge_bc, Axis::edge_ca};
  const Place p = rational_place(q.p);
  const std::array<Place, 3> corner = {rational_place(q.a), rational_place(q.b), rational_place(q.c)};
  NearestPlace found{{}, {}, squared_distance(q)};
  const auto try_part = [&](std::string_view name, const Place& at) {
    const Place v = p - at;
    if (dot(v, v) != found.squared_distance) return;
    if (found.features.empty()) found.point = at;
    found.features.push_back(name);
  };
  for (std::size_t i = 0; i < 3; ++i) try_part(axis_names[vertices[i]], corner[i]);
  for (std::size_t i = 0; i < 3; ++i) {
    const Place edge = corner[(i + 1) % 3] - corner[i];
    const Rational length = dot(edge, edge), foot = dot(p - corner[i], edge);  // squared, and times it
    if (foot > 0 && foot < length) try_part(axis_names[edges[i]], corner[i] + edge * Rational(foot / length));
  }
  if (!found.features.empty()) return found;
  const Place normal = cross(corner[1] - corner[0], corner[2] - corner[0]);
  const Rational squared = dot(normal, normal);
  if (squared != 0) try_part("face", p + normal * Rational(dot(corner[0] - p, normal) / squared));
  if (found.features.empty()) {
    throw OracleDisagreement(
        "no part of the triangle is at the squared distance of CGAL, " + found.squared_distance.get_str(),
        Numbers<double>(q), sphere_triangle_predicate());
  }
  return found;
}

std::vector<ExactFact> exact_facts(const Query<double>& q) {
  const NearestPlace place = nearest_place(q);
  const Rational &dd = place.squared_distance, r(q.r);
  const Place away = rational_place(q.p) - place.point;
  ExactFact normal = direction_fact("normal", away.x, away.y, away.z);
  if (normal.numbers.empty()) normal.note = "not one: the centre is on the triangle";
  return {dd > r * r ? length_fact("distance", {-r, dd}) : length_fact("penetration", {r, dd, -1}),
          depth_fact(exact_depth(q, dd)),
          length_fact("centre_distance", {0, dd}),
          {"features", {}, place.features},
          place_fact("nearest_point", place.point.x, place.point.y, place.point.z),
          normal};
}

}  // namespace axiscert

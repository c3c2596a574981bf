#include "fuzz/sphere_triangle/slack_scenes.h"

#include <algorithm>

namespace axiscert {
namespace slack {

ScenePoint SceneTriangle::outward(std::size_t edge) const {
  const ScenePoint out = unit_of(cross(along(edge), normal));
  return dot(out, corner[edge] - corner[(edge + 2) % 3]) > 0 ? out : out * -1.0;
}

ScenePoint random_direction(Stream& random) {
  for (;;) {
    const double x = random.symmetric<double>(), y = random.symmetric<double>(), z = random.symmetric<double>();
    const ScenePoint v{x, y, z};
    const double square = dot(v, v);
    if (square <= 1 && square >= 0.01) return unit_of(v);
  }
}

double random_length(Stream& random, int low, int high) {
  const int exponent = static_cast<int>(random.integer(low, high - 1));
  return std::ldexp(1 + random.unit<double>(), exponent);
}

SceneTriangle random_triangle(Stream& random) {
  const ScenePoint n = random_direction(random);
  ScenePoint u = random_direction(random);
  while (std::abs(dot(u, n)) > 0.8) u = random_direction(random);
  u = unit_of(u - n * dot(u, n));
  const ScenePoint v = cross(n, u);
  const ScenePoint centre{random.symmetric<double>() / 8, random.symmetric<double>() / 8,
                          random.symmetric<double>() / 8};
  // Near the corners of an equilateral triangle.
  constexpr double cosine[] = {1, -0.5, -0.5}, sine[] = {0, 0.866, -0.866};
  SceneTriangle made{{}, n};
  for (std::size_t k = 0; k < 3; ++k) {
    const double x = cosine[k] + random.symmetric<double>() / 5, y = sine[k] + random.symmetric<double>() / 5;
    made.corner[k] = centre + u * x + v * y;
  }
  return made;
}

NearestScene nearest_scene(Stream& random, const SceneTriangle& t, Nearest feature, std::size_t which) {
  const ScenePoint from = t.corner[which], to = t.corner[(which + 1) % 3], other = t.corner[(which + 2) % 3];
  const double s = 0.25 + random.unit<double>() / 4, side = random.coin() ? 1 : -1;
  switch (feature) {
    case Nearest::face:
      return {from + (to - from) * s + (other - from) * (0.125 + random.unit<double>() / 8),
              unit_of(cross(t.along(0), t.along(1))) * (which == 0 ? 1.0 : -1.0)};
    case Nearest::edge: {
      const double lift = random.unit<double>() * side;
      return {from + (to - from) * (s + 0.125), unit_of(t.outward(which) + t.normal * lift)};
    }
    case Nearest::vertex: {
      const ScenePoint one = unit_of(to - from), two = unit_of(other - from);
      const double lift = random.unit<double>() * side, turn = random.symmetric<double>() / 4;
      return {from, unit_of(unit_of(one + two) * -1.0 + (one - two) * turn + t.normal * lift)};
    }
  }
  return {};
}

}  // namespace slack

namespace sphere_slack {
namespace {

using namespace slack;

constexpr std::size_t columns = 13, centre = 9, radius = 12;

// The numbers with the triangle, the rest 0.
Numbers<double> with_triangle(const SceneTriangle& t) {
  Numbers<double> numbers = zeros(columns);
  for (std::size_t k = 0; k < 3; ++k) put(numbers, 3 * k, t.corner[k]);
  return numbers;
}

double scene_size(const SceneTriangle& t, const ScenePoint& p) {
  double size = greatest_of(p);
  for (const ScenePoint& corner : t.corner) size = std::max(size, greatest_of(corner));
  return size;
}

class Maker {
 public:
  Maker(Precision precision, std::uint64_t seed)
      : precision_(precision), name_(seed, name_hash("sphere-triangle/slack"), 1, precision) {}

  std::vector<SlackScene> made() && {
    constexpr std::string_view over[] = {"over the front of the face", "over the back of the face"};
    constexpr std::string_view beside[] = {"nearest to edge ab", "nearest to edge bc", "nearest to edge ca"};
    constexpr std::string_view at[] = {"nearest to vertex a", "nearest to vertex b", "nearest to vertex c"};
    add_growing(Nearest::face, "nearest to the face", over);
    add_growing(Nearest::edge, "nearest to an edge", beside);
    add_growing(Nearest::vertex, "nearest to a vertex", at);
    const auto radii = sliding_radii(precision_);
    add_beyond_edges(radii[0], "beside an edge, with a small sphere");
    add_along_edges(radii[0], "beyond the end of an edge, with a small sphere");
    add_beyond_edges(radii[1], "beside an edge, with a tiny sphere");
    add_along_edges(radii[1], "beyond the end of an edge, with a tiny sphere");
    return std::move(scenes_);
  }

 private:
  Stream next() { return {name_, position_++}; }

  // The sphere grows until it touches.
  void add_growing(Nearest feature, std::string_view kind, std::span<const std::string_view> parts) {
    for (std::size_t which = 0; which < parts.size(); ++which) {
      for (std::size_t i = 0; i < scenes_of_part; ++i) {
        Stream random = next();
        const SceneTriangle t = random_triangle(random);
        const NearestScene nearest = nearest_scene(random, t, feature, which);
        const double r = random_length(random, -2, 8);
        const ScenePoint p = nearest.point + nearest.away * r;
        SlackScene scene{"nearest to any feature", kind, parts[which], with_triangle(t), zeros(columns)};
        put(scene.base, centre, p);
        scene.step[radius] = scene.unit = scene.apart = r;
        scene.scene = std::max(r, scene_size(t, p));
        scene.lengths[0] = {"r", r};
        scenes_.push_back(scene);
      }
    }
  }

  // A sphere over the triangle goes away from the point of its rim until they part: half a radius above the plane.
  SlackScene sliding(const SceneTriangle& t, int exponent, const ScenePoint& rim, const ScenePoint& away,
                     bool is_front) {
    const double r = std::ldexp(1.0, exponent), height = is_front ? r / 2 : -r / 2;
    const double beyond = std::sqrt(r * r - height * height);
    SlackScene scene{"", "", "", with_triangle(t), zeros(columns)};
    put(scene.base, centre, rim + t.normal * height - away * slide_depth);
    scene.unit = slide_depth + beyond;
    put(scene.step, centre, away * scene.unit);
    scene.base[radius] = r;
    scene.turns_to_separated = true;
    scene.scene = scene_size(t, rim);
    scene.apart = r;
    return scene;
  }

  void add_beyond_edges(int exponent, std::string_view path) {
    constexpr std::string_view parts[] = {"beside edge ab, with a small sphere", "beside edge bc, with a small sphere",
                                          "beside edge ca, with a small sphere"};
    for (std::size_t edge = 0; edge < 3; ++edge) {
      for (std::size_t i = 0; i < scenes_of_part; ++i) {
        Stream random = next();
        const SceneTriangle t = random_triangle(random);
        const ScenePoint rim = t.corner[edge] + t.along(edge) * (0.25 + random.unit<double>() / 2);
        SlackScene scene = sliding(t, exponent, rim, t.outward(edge), random.coin());
        scene.path = scene.kind = path;
        scene.part = parts[edge];
        scene.lengths = {{{"the triangle's height", t.altitude(edge)}, {"the edge", norm_of(t.along(edge))}}};
        scenes_.push_back(scene);
      }
    }
  }

  void add_along_edges(int exponent, std::string_view path) {
    constexpr std::string_view parts[] = {
        "beyond b along ab, with a small sphere", "beyond c along bc, with a small sphere",
        "beyond a along ca, with a small sphere", "beyond a along ab, with a small sphere",
        "beyond b along bc, with a small sphere", "beyond c along ca, with a small sphere"};
    for (std::size_t which = 0; which < 6; ++which) {
      for (std::size_t i = 0; i < scenes_of_part; ++i) {
        Stream random = next();
        const SceneTriangle t = random_triangle(random);
        const std::size_t edge = which % 3;
        const bool is_end = which < 3;
        const ScenePoint away = unit_of(t.along(edge)) * (is_end ? 1.0 : -1.0);
        SlackScene scene = sliding(t, exponent, t.corner[is_end ? (edge + 1) % 3 : edge], away, random.coin());
        scene.path = scene.kind = path;
        scene.part = parts[which];
        scene.lengths[0] = {"the edge", norm_of(t.along(edge))};
        scenes_.push_back(scene);
      }
    }
  }

  Precision precision_;
  StreamName name_;
  std::uint64_t position_ = 0;
  std::vector<SlackScene> scenes_;
};

}  // namespace
}  // namespace sphere_slack

const SlackScenes sphere_triangle_slack_scenes = {
    [](std::size_t, Precision precision, std::uint64_t seed) { return sphere_slack::Maker(precision, seed).made(); }};

}  // namespace axiscert

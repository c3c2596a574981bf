// Scenes of slacks of moving spheres: a radius that grows, a motion that grows, and a path that slides off the
// triangle.
#include <algorithm>
#include <span>

#include "fuzz/moving_sphere/capability_parts.h"
#include "fuzz/sphere_triangle/slack_scenes.h"

namespace axiscert {
namespace motion_slack {
namespace {

using namespace slack;

constexpr std::size_t columns = 16, start = 9, motion = 12, radius = 15;

class Maker {
 public:
  Maker(bool gives_end, Precision precision, std::uint64_t seed)
      : gives_end_(gives_end), precision_(precision), name_(seed, name_hash("moving-sphere/slack"), 1, precision) {}

  std::vector<SlackScene> made() && {
    constexpr std::string_view end_over[] = {"whose motion ends over the front", "whose motion ends over the back"};
    constexpr std::string_view end_beside[] = {"whose motion ends near edge ab", "whose motion ends near edge bc",
                                               "whose motion ends near edge ca"};
    constexpr std::string_view end_at[] = {"whose motion ends near vertex a", "whose motion ends near vertex b",
                                           "whose motion ends near vertex c"};
    constexpr std::string_view beside[] = {"that pass edge ab", "that pass edge bc", "that pass edge ca"};
    constexpr std::string_view at[] = {"that pass vertex a", "that pass vertex b", "that pass vertex c"};
    add_ends(Nearest::face, "whose motion ends over the face", end_over);
    add_ends(Nearest::edge, "whose motion ends near an edge", end_beside);
    add_ends(Nearest::vertex, "whose motion ends near a vertex", end_at);
    add_passing(Nearest::edge, "that pass an edge", beside);
    add_passing(Nearest::vertex, "that pass a vertex", at);
    const auto radii = sliding_radii(precision_);
    add_beyond_edges(radii[0], "beside an edge, with a small sphere");
    add_along_edges(radii[0], "beyond the end of an edge, with a small sphere");
    add_beyond_edges(radii[1], "beside an edge, with a tiny sphere");
    add_along_edges(radii[1], "beyond the end of an edge, with a tiny sphere");
    return std::move(scenes_);
  }

 private:
  Stream next() { return {name_, position_++}; }

  // With the triangle, the start and the displacement; r is 0.
  SlackScene moving(const SceneTriangle& t, const ScenePoint& from, const ScenePoint& by) const {
    SlackScene scene{"", "", "", zeros(columns), zeros(columns)};
    scene.scene = std::max(greatest_of(from), greatest_of(from + by));
    for (std::size_t k = 0; k < 3; ++k) {
      put(scene.base, 3 * k, t.corner[k]);
      scene.scene = std::max(scene.scene, greatest_of(t.corner[k]));
    }
    put(scene.base, start, from);
    put(scene.base, motion, gives_end_ ? from + by : by);
    return scene;
  }

  // The sphere comes straight at the nearest point. Its radius grows until it touches at the end; or its motion does.
  void add_ends(Nearest feature, std::string_view kind, std::span<const std::string_view> parts) {
    for (std::size_t which = 0; which < parts.size(); ++which) {
      for (std::size_t i = 0; i < 2 * scenes_of_part; ++i) {
        Stream random = next();
        const SceneTriangle t = random_triangle(random);
        const NearestScene nearest = nearest_scene(random, t, feature, which);
        const double r = random_length(random, -2, 5), way = random_length(random, -2, 5);
        const ScenePoint from = nearest.point + nearest.away * (r + way), by = nearest.away * -way;
        SlackScene scene = moving(t, from, by);
        scene.lengths = {{{"r", r}, {"the motion", way}}};
        scene.apart = r;
        if (i % 2 == 0) {
          scene.path = "whose radius grows";
          scene.step[radius] = scene.unit = r;
        } else {
          scene.path = "whose motion grows";
          scene.base[radius] = r;
          put(scene.base, motion, gives_end_ ? from : ScenePoint{0, 0, 0});
          put(scene.step, motion, by);
          scene.unit = way;
        }
        scene.kind = kind;
        scene.part = parts[which];
        scenes_.push_back(scene);
      }
    }
  }

  // The sphere comes by, across the direction to its nearest point, and is nearest half way. Its radius grows.
  void add_passing(Nearest feature, std::string_view kind, std::span<const std::string_view> parts) {
    for (std::size_t which = 0; which < parts.size(); ++which) {
      for (std::size_t i = 0; i < scenes_of_part; ++i) {
        Stream random = next();
        const SceneTriangle t = random_triangle(random);
        const NearestScene nearest = nearest_scene(random, t, feature, which);
        ScenePoint across = cross(nearest.away, random_direction(random));
        while (norm_of(across) < 0.5) across = cross(nearest.away, random_direction(random));
        const double r = random_length(random, -2, 5), way = random_length(random, -1, 5);
        const ScenePoint by = unit_of(across) * way;
        SlackScene scene = moving(t, nearest.point + nearest.away * r - by * 0.5, by);
        scene.path = "whose radius grows";
        scene.kind = kind;
        scene.part = parts[which];
        scene.lengths = {{{"r", r}, {"the motion", way}}};
        scene.step[radius] = scene.unit = scene.apart = r;
        scenes_.push_back(scene);
      }
    }
  }

  // The sphere goes through the plane beside the triangle, the farther from it the greater x.
  SlackScene sliding(Stream& random, const SceneTriangle& t, int exponent, const ScenePoint& rim,
                     const ScenePoint& away) const {
    const double r = std::ldexp(1.0, exponent), height = 0.5 + random.unit<double>(), side = random.coin() ? 1 : -1;
    const ScenePoint up = t.normal * (height * side);
    SlackScene scene = moving(t, rim + up - away * slide_depth, up * -2.0);
    scene.unit = slide_depth + r;
    put(scene.step, start, away * scene.unit);
    if (gives_end_) put(scene.step, motion, away * scene.unit);
    scene.base[radius] = scene.apart = r;
    scene.turns_to_separated = true;
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
        SlackScene scene = sliding(random, t, exponent, rim, t.outward(edge));
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
        SlackScene scene = sliding(random, t, exponent, t.corner[is_end ? (edge + 1) % 3 : edge], away);
        scene.path = scene.kind = path;
        scene.part = parts[which];
        scene.lengths[0] = {"the edge", norm_of(t.along(edge))};
        scenes_.push_back(scene);
      }
    }
  }

  bool gives_end_;
  Precision precision_;
  StreamName name_;
  std::uint64_t position_ = 0;
  std::vector<SlackScene> scenes_;
};

}  // namespace
}  // namespace motion_slack

const SlackScenes moving_sphere_slack_scenes = {[](std::size_t entry, Precision precision, std::uint64_t seed) {
  return motion_slack::Maker(entry == 1, precision, seed).made();
}};

}  // namespace axiscert

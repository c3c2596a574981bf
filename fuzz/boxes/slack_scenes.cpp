#include "fuzz/boxes/capability_parts.h"

#include <array>
#include <cmath>
#include <numeric>
#include <optional>

#include "fuzz/queries/random.h"
#include "fuzz/sphere_triangle/slack_scenes.h"
#include "kernel/boxes/box_triangle.h"
#include "kernel/boxes/turned.h"

namespace axiscert {
namespace box_slack {
namespace {

using boxes::OrientedBox, boxes::TurnedBox;
using slack::random_direction, slack::random_length;

constexpr std::size_t scenes_of_kind = 64;
constexpr double inset = 0.125;  // of the scene's size: how deep the two overlap at x = 0

// A solid as its corners' directions see it: `part` of it is farthest in a direction.
struct Solid {
  TurnedBox<double> turned;
  OrientedBox<double> box;
};

// Half extents from 1/2 to 3/2 of the size, turned anyhow or as the world is.
Solid random_box(Stream& random, double size, bool is_turned) {
  Solid made;
  made.turned.centre =
      ScenePoint{random.symmetric<double>(), random.symmetric<double>(), random.symmetric<double>()} * (size / 4);
  for (double& half : made.turned.half) half = size * (0.5 + random.unit<double>());
  made.turned.q = {1, 0, 0, 0};
  if (is_turned) {
    double square = 0;
    while (square < 0.1) {
      for (double& x : made.turned.q) x = random.symmetric<double>();
      square = std::inner_product(made.turned.q.begin(), made.turned.q.end(), made.turned.q.begin(), 0.0);
    }
    for (double& x : made.turned.q) x /= std::sqrt(square);
  }
  made.box = {made.turned.centre, made.turned.half, boxes::with_matrix(made.turned).axis};
  return made;
}

double sum_of(const std::array<double, 3>& half) { return half[0] + half[1] + half[2]; }
// Half the box's extent along a direction of length 1.
double reach(const OrientedBox<double>& box, const ScenePoint& n) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += box.half[k] * std::abs(dot(box.axis[k], n));
  return sum;
}
// A point that is farthest in the direction, from the centre: a corner; of the edges along axis `edge`, or on the facet
// of axis `facet`, one at a random place of its middle half. Empty where another part is nearly as far.
constexpr std::size_t no_axis = 3;
std::optional<ScenePoint> farthest(Stream& random, const OrientedBox<double>& box, const ScenePoint& n,
                                   std::size_t edge = no_axis, std::size_t facet = no_axis) {
  ScenePoint at{0, 0, 0};
  for (std::size_t k = 0; k < 3; ++k) {
    const double cosine = dot(box.axis[k], n);
    const bool is_free = k == edge || (facet != no_axis && k != facet);
    if (!is_free && std::abs(cosine) < 0.2) return std::nullopt;
    const double share = is_free ? random.symmetric<double>() / 2 : cosine > 0 ? 1.0 : -1.0;
    at = at + box.axis[k] * (share * box.half[k]);
  }
  return at;
}

double far_coordinate(const OrientedBox<double>& box) { return greatest_of(box.centre) + sum_of(box.half); }

void put_slack_box(Numbers<double>& numbers, std::size_t first, const Solid& solid, bool as_quaternion) {
  put(numbers, first, solid.box.centre);
  for (std::size_t k = 0; k < 3; ++k) numbers[first + 3 + k] = solid.box.half[k];
  for (std::size_t k = 0; k < 3 && !as_quaternion; ++k) put(numbers, first + 6 + 3 * k, solid.box.axis[k]);
  for (std::size_t k = 0; k < 4 && as_quaternion; ++k) numbers[first + 6 + k] = solid.turned.q[k];
}

// The corners min and max of an upright one.
void put_slack_corners(Numbers<double>& numbers, std::size_t first, const OrientedBox<double>& box) {
  const ScenePoint half{box.half[0], box.half[1], box.half[2]};
  put(numbers, first, box.centre - half);
  put(numbers, first + 3, box.centre + half);
}

constexpr std::string_view on_any = "on any axis", on_edges = "on the product of two edges",
                           on_flat = "on the facet of a flat box";

// Boxes that touch in one point, on one axis; then B goes away along it.
std::vector<SlackScene> of_two_boxes(std::size_t entry, Precision precision, std::uint64_t seed) {
  const StreamName name(seed, name_hash("box-box/slack"), 1, precision);
  const bool is_mixed = entry == boxes::MixedBoxes::entry, as_corners = entry == boxes::MinmaxBoxes::entry,
             as_quaternion = is_mixed || entry == boxes::QuaternionBoxes::entry;
  const std::size_t of_one = as_corners || is_mixed ? 6 : as_quaternion ? 10 : 15, columns = is_mixed ? 16 : 2 * of_one;
  std::vector<SlackScene> scenes;
  constexpr std::string_view facets = "on a facet";
  constexpr std::string_view parts[] = {"on a facet of a", "on a facet of b", on_edges, on_flat};
  std::uint64_t position = 0;
  for (std::size_t kind = 0; kind < 4; ++kind) {
    if (as_corners && kind == 2) continue;  // edges of upright boxes have no products of their own
    for (std::size_t made = 0; made < scenes_of_kind;) {
      Stream random(name, position++);
      const double size = random_length(random, -3, 4);
      Solid a = random_box(random, size, !as_corners && !is_mixed), b = random_box(random, size, !as_corners);
      const std::size_t i = random.below(3), j = random.below(3);
      const double side = random.coin() ? 1 : -1;
      const bool is_of_b = kind == 1, is_of_edges = kind == 2;
      if (kind == 3) a.turned.half[i] = a.box.half[i] = 0;
      ScenePoint n = is_of_b ? b.box.axis[i] : a.box.axis[i];
      if (is_of_edges) {
        n = cross(a.box.axis[i], b.box.axis[j]);
        if (norm_of(n) < 0.5) continue;
        n = unit_of(n);
      }
      n = n * side;  // from A to B
      const auto of_a = is_of_edges ? farthest(random, a.box, n, i)
                                    : farthest(random, a.box, n, no_axis, is_of_b && !as_corners ? no_axis : i);
      const auto of_b = is_of_edges ? farthest(random, b.box, n * -1.0, j)
                                    : farthest(random, b.box, n * -1.0, no_axis, is_of_b || as_corners ? i : no_axis);
      if (!of_a || !of_b) continue;
      ++made;
      b.box.centre = a.box.centre + *of_a - *of_b - n * (inset * size);
      SlackScene scene{on_any, kind < 2 ? facets : parts[kind], parts[kind], zeros(columns), zeros(columns)};
      if (as_corners || is_mixed) put_slack_corners(scene.base, 0, a.box);
      else put_slack_box(scene.base, 0, a, as_quaternion);
      if (as_corners) put_slack_corners(scene.base, of_one, b.box);
      else put_slack_box(scene.base, of_one, b, as_quaternion);
      scene.unit = inset * size;
      put(scene.step, of_one, n * scene.unit);
      if (as_corners) put(scene.step, of_one + 3, n * scene.unit);
      scene.turns_to_separated = true;
      scene.scene = scene.apart = std::max(far_coordinate(a.box), far_coordinate(b.box));
      scene.lengths = {{{"the half extents along the axis", reach(a.box, n) + reach(b.box, n)},
                        {"the sum of a box's half extents", (sum_of(a.box.half) + sum_of(b.box.half)) / 2}}};
      scenes.push_back(scene);
    }
  }
  return scenes;
}

// A box and a triangle that touch in one point, on one axis; then the triangle goes away along it.
std::vector<SlackScene> of_box_and_triangle(std::size_t entry, Precision precision, std::uint64_t seed) {
  const StreamName name(seed, name_hash("box-triangle/slack"), 1, precision);
  const bool as_quaternion = entry == boxes::TurnedEntry::entry, has_corners = entry == boxes::MinmaxEntry::entry;
  const bool is_turned = as_quaternion || entry == boxes::OrientedEntry::entry;
  const std::size_t columns = as_quaternion ? 19 : is_turned ? 24 : 15, first_corner = columns - 9;
  std::vector<SlackScene> scenes;
  constexpr std::string_view kinds[] = {"on a facet of the box", "on the triangle's plane", on_edges, on_flat};
  std::uint64_t position = 0;
  for (std::size_t kind = 0; kind < 4; ++kind) {
    for (std::size_t made = 0; made < scenes_of_kind;) {
      Stream random(name, position++);
      const double size = random_length(random, -3, 4);
      Solid solid = random_box(random, size, is_turned);
      const OrientedBox<double>& box = solid.box;
      slack::SceneTriangle t = slack::random_triangle(random);
      for (ScenePoint& corner : t.corner) corner = corner * size;
      const std::size_t i = random.below(3), edge = random.below(3);
      const bool is_of_facet = kind == 0 || kind == 3;
      if (kind == 3) solid.turned.half[i] = solid.box.half[i] = 0;
      const ScenePoint along = t.along(edge);
      ScenePoint n = is_of_facet ? box.axis[i] : kind == 1 ? t.normal : cross(box.axis[i], along);
      if (kind == 2 && norm_of(n) < 0.5 * norm_of(along)) continue;
      n = unit_of(n) * (random.coin() ? 1 : -1);  // from the box to the triangle
      const auto of_box = is_of_facet ? farthest(random, box, n, no_axis, i)
                          : kind == 1 ? farthest(random, box, n)
                                      : farthest(random, box, n, i);
      if (!of_box) continue;
      // The corner of the triangle, or its edge from corner `edge`, that is nearest to the box.
      const double s = 0.25 + random.unit<double>() / 2, share = 0.25 + random.unit<double>() / 4;
      const ScenePoint other = t.corner[(edge + 2) % 3];
      ScenePoint at = t.corner[edge];
      if (kind == 1) at = at + along * share + (other - at) * (share / 2);
      if (kind == 2) at = at + along * s;
      const double next_lift = dot(t.corner[(edge + 1) % 3] - at, n), other_lift = dot(other - at, n);
      if (kind != 1 && other_lift < 0.2 * size) continue;
      if (is_of_facet && next_lift < 0.2 * size) continue;
      ++made;
      SlackScene scene{on_any, kinds[kind], kinds[kind], zeros(columns), zeros(columns)};
      if (is_turned) {
        put_slack_box(scene.base, 0, solid, as_quaternion);
      } else if (has_corners) {
        put_slack_corners(scene.base, 0, box);
      } else {
        const ScenePoint half{box.half[0], box.half[1], box.half[2]};
        put(scene.base, 0, box.centre);
        put(scene.base, 3, half);
      }
      scene.unit = inset * size;
      const ScenePoint by = box.centre + *of_box - at - n * scene.unit;
      scene.scene = far_coordinate(box);
      for (std::size_t k = 0; k < 3; ++k) {
        put(scene.base, first_corner + 3 * k, t.corner[k] + by);
        put(scene.step, first_corner + 3 * k, n * scene.unit);
        scene.scene = std::max(scene.scene, greatest_of(t.corner[k] + by));
      }
      scene.apart = scene.scene;
      scene.turns_to_separated = true;
      // Along the axis of its facet a flat box has no extent, of which a slack would be a part.
      scene.lengths = {{{"the half extents along the axis", kind == 3 ? 0 : reach(box, n)},
                        {"the sum of the half extents", sum_of(box.half)}}};
      scenes.push_back(scene);
    }
  }
  return scenes;
}

}  // namespace
}  // namespace box_slack

const SlackScenes box_box_slack_scenes = {box_slack::of_two_boxes},
                  box_triangle_slack_scenes = {box_slack::of_box_and_triangle};

}  // namespace axiscert

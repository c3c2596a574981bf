#include <algorithm>
#include <optional>

#include "exact/boxes/exact_triangle.h"
#include "exact/trait/exact_number.h"

namespace axiscert::boxes {
namespace {

Point rational(const Vec3<ExactNumber>& v) { return {v.x.value, v.y.value, v.z.value}; }

template <class Entry, class Problem>
ExactBoxAndTriangle exactly(const Problem& q) {
  const Numbers<double> numbers = numbers_of(q);
  const BoxAndTriangle<ExactNumber> exact =
      oriented(Entry::template problem<ExactNumber>([&](std::size_t k) { return ExactNumber(numbers[k]); }));
  const OrientedBox<ExactNumber>& box = exact.box;
  return {{rational(box.centre),
           {{box.half[0].value, box.half[1].value, box.half[2].value}},
           {{rational(box.axis[0]), rational(box.axis[1]), rational(box.axis[2])}}},
          {{rational(exact.corner[0]), rational(exact.corner[1]), rational(exact.corner[2])}}};
}

// On an axis that is not 0: what is left of the box's half extent beside the triangle's distance from its centre, times
// the axis' length.
struct AxisRest {
  std::size_t index;
  Rational rest, squared_length;
  Rational squared() const { return rest * rest / squared_length; }
};
std::vector<AxisRest> rests(const ExactBoxAndTriangle& q) {
  std::vector<AxisRest> found;
  for (std::size_t i = 0; i < thirteen_count; ++i) {
    const Point along = direction(q, i);
    const Rational squared_length = dot(along, along);
    if (squared_length == 0) continue;
    Rational extent;
    for (std::size_t k = 0; k < 3; ++k) extent += q.box.half[k] * abs(Rational(dot(along, q.box.axis[k])));
    std::array<Rational, 3> at;
    for (std::size_t k = 0; k < 3; ++k) at[k] = dot(along, q.corner[k] - q.box.centre);
    const auto [least, greatest] = std::minmax_element(at.begin(), at.end());
    const Rational beyond = std::max(*least, Rational(-*greatest));
    found.push_back({i, extent - beyond, squared_length});
  }
  return found;
}

Rational squared_scene(const ExactBoxAndTriangle& q) {
  Rational scene = 0;
  const auto reach = [&](const Point& p) {
    const Point from = p - q.box.centre;
    scene = std::max(scene, Rational(dot(from, from)));
  };
  for (const Point& corner : corners_of(q.box)) reach(corner);
  for (const Point& corner : q.corner) reach(corner);
  return scene;
}

}  // namespace

ExactBoxAndTriangle exact_box_and_triangle(const CentredAndTriangle<double>& q) { return exactly<CentreEntry>(q); }
ExactBoxAndTriangle exact_box_and_triangle(const CornersAndTriangle<double>& q) { return exactly<MinmaxEntry>(q); }
ExactBoxAndTriangle exact_box_and_triangle(const BoxAndTriangle<double>& q) { return exactly<OrientedEntry>(q); }

Hull hull_of(const std::array<Point, 3>& corners) { return {corners.begin(), corners.end()}; }

Rational squared_penetration(const ExactBoxAndTriangle& q) {
  std::optional<Rational> least;
  for (const AxisRest& axis : rests(q)) {
    Rational squared = axis.squared();
    if (!least || squared < *least) least = std::move(squared);
  }
  return *least;  // the box's axes are independent, so its facets have normals
}

std::vector<std::string_view> deciding_axes(const ExactBoxAndTriangle& q) {
  std::vector<std::string_view> separating, least;
  std::optional<Rational> depth;
  for (const AxisRest& axis : rests(q)) {
    if (axis.rest < 0) separating.push_back(thirteen_names[axis.index]);
    const Rational squared = axis.squared();
    if (depth && squared > *depth) continue;
    if (!depth || squared < *depth) least.clear();
    depth = squared;
    least.push_back(thirteen_names[axis.index]);
  }
  return separating.empty() ? least : separating;
}

Rational squared_distance(const ExactBoxAndTriangle& q) {
  return squared_distance(corners_of(q.box), hull_of(q.corner));
}

double depth_of(const ExactBoxAndTriangle& q) {
  const Rational scene = squared_scene(q), distance = squared_distance(q);
  if (scene == 0) return 0;
  return nearest_sqrt<double>(Rational((distance > 0 ? distance : squared_penetration(q)) / scene));
}

}  // namespace axiscert::boxes

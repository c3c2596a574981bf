#include "exact/boxes/measures.h"

#include <algorithm>
#include <array>
#include <optional>

#include "exact/judge/trait.h"
#include "exact/numbers/binary_fraction.h"

namespace axiscert::boxes {
namespace {

Point rational(const Vec3<ExactNumber>& v) { return {v.x.value, v.y.value, v.z.value}; }

ExactPair rational(const BoxPair<ExactNumber>& q) {
  const auto box = [](const OrientedBox<ExactNumber>& of) {
    return ExactBox{rational(of.centre),
                    {{of.half[0].value, of.half[1].value, of.half[2].value}},
                    {{rational(of.axis[0]), rational(of.axis[1]), rational(of.axis[2])}}};
  };
  return {box(q.a), box(q.b)};
}

ExactBox turned(const TurnedBox<double>& box) {
  const TurnedAxes<Rational> turned = turned_axes<Rational>(box.q);
  ExactBox found{each<Rational>(box.centre), each<Rational>(box.half), {}};
  for (std::size_t k = 0; k < 3; ++k) found.axis[k] = turned.axis[k] / turned.square;
  return found;
}

Rational magnitude(const Rational& x) { return abs(x); }

// Half the extent of a box in direction d, times |d|.
template <class T>
T extent_along(const OrientedBox<T>& box, const Vec3<T>& d) {
  T sum{};
  for (std::size_t k = 0; k < 3; ++k) sum = sum + box.half[k] * magnitude(T(dot(d, box.axis[k])));
  return sum;
}

// Rationals of one kind times the least factor that makes all of them integers.
struct Integers {
  mpz_class factor = 1;

  void include(const Point& p) {
    for (const Rational* x : {&p.x, &p.y, &p.z}) factor = lcm(factor, x->get_den());
  }
  void include(const std::array<Rational, 3>& numbers) {
    for (const Rational& x : numbers) factor = lcm(factor, x.get_den());
  }
  BinaryNumber of(const Rational& x) const {
    return BinaryNumber(mpz_class(x.get_num() * (factor / x.get_den())).get_mpz_t());
  }
  Vec3<BinaryNumber> of(const Point& p) const { return {of(p.x), of(p.y), of(p.z)}; }
};

Rational least_squared(const std::vector<AxisRest>& axes) {
  std::optional<Rational> least;
  for (const AxisRest& axis : axes) {
    Rational squared = axis.squared();
    if (!least || squared < *least) least = std::move(squared);
  }
  return *least;  // the axes of a box are independent, so its facets have normals
}

template <std::size_t size>
std::vector<std::string_view> names_of(const std::vector<AxisRest>& axes,
                                       const std::array<std::string_view, size>& names) {
  std::vector<std::string_view> found;
  for (const AxisRest& axis : axes) found.push_back(names[axis.index]);
  return found;
}

}  // namespace

ExactPair exact_pair(const BoxPair<double>& q) {
  const Numbers<double> numbers = numbers_of(q);
  return rational(MatrixBoxes::problem<ExactNumber>([&](std::size_t k) { return ExactNumber(numbers[k]); }));
}

ExactPair exact_pair(const TurnedPair<double>& q) { return {turned(q.a), turned(q.b)}; }

ExactPair exact_pair(const CornersPair<double>& q) {
  const Numbers<double> numbers = numbers_of(q);
  return rational(
      with_matrices(MinmaxBoxes::problem<ExactNumber>([&](std::size_t k) { return ExactNumber(numbers[k]); })));
}

ExactPair exact_pair(const MixedPair<double>& q) { return {exact_pair(CornersPair<double>{q.a, q.a}).a, turned(q.b)}; }

std::vector<AxisRest> axis_rests(const ExactPair& q) {
  const Point between = q.b.centre - q.a.centre;
  std::vector<AxisRest> found;
  for (std::size_t i = 0; i < axis_count; ++i) {
    const Point along = direction(q, i);
    const Rational squared_length = dot(along, along), apart = dot(along, between);
    if (squared_length == 0) continue;
    const Rational radii = extent_along(q.a, along) + extent_along(q.b, along), beside = abs(apart);
    found.push_back(
        {i, apart < 0 ? Point{} - along : along, apart == 0, radii - beside, radii + beside, squared_length});
  }
  return found;
}

std::vector<AxisRest> deciding(std::vector<AxisRest> axes) {
  std::vector<AxisRest> separating, least;
  for (AxisRest& axis : axes) {
    if (axis.rest < 0) {
      separating.push_back(std::move(axis));
    } else {
      const int order = least.empty() ? 0 : cmp(axis.squared(), least.front().squared());
      if (order > 0) continue;
      if (order < 0) least.clear();
      least.push_back(std::move(axis));
    }
  }
  return separating.empty() ? least : separating;
}

std::vector<std::string_view> deciding_axes(const ExactPair& q) {
  return names_of(deciding(axis_rests(q)), axis_names);
}

Rational squared_penetration(const ExactPair& q) { return least_squared(axis_rests(q)); }

Rational squared_gap(const ExactPair& q) {
  Rational greatest = 0;
  for (const AxisRest& axis : axis_rests(q)) {
    if (axis.rest < 0) greatest = std::max(greatest, axis.squared());
  }
  return greatest;
}

// In integers: families ask this for each query that touches, and quotients of rationals would take ten times as long.
Rational critical_factor(const ExactPair& q, const Point& u) {
  Integers axes, halves, way;
  for (const ExactBox* box : {&q.a, &q.b}) {
    for (const Point& axis : box->axis) axes.include(axis);
    halves.include(box->half);
  }
  way.include(u);
  const auto box_of = [&](const ExactBox& box) {
    return OrientedBox<BinaryNumber>{{},
                                     {{halves.of(box.half[0]), halves.of(box.half[1]), halves.of(box.half[2])}},
                                     {{axes.of(box.axis[0]), axes.of(box.axis[1]), axes.of(box.axis[2])}}};
  };
  const BoxPair<BinaryNumber> boxes{box_of(q.a), box_of(q.b)};
  const Vec3<BinaryNumber> along_way = way.of(u);
  std::optional<BinaryFraction> least;
  for (std::size_t i = 0; i < axis_count; ++i) {
    const Vec3<BinaryNumber> along = direction(boxes, i);
    BinaryNumber slope = magnitude(dot(along, along_way));
    if (slope.sign() == 0) continue;
    BinaryFraction factor(extent_along(boxes.a, along) + extent_along(boxes.b, along), std::move(slope));
    if (!least || order(factor, *least) < 0) least = std::move(factor);
  }
  // There is one: the normals of a box span the space, so one is not at right angles to u.
  return rational(*least) * way.factor / (axes.factor * halves.factor);
}

std::optional<Rational> critical_extent(const ExactPair& q) {
  ExactPair without = q;
  without.a.half[0] = 0;
  const Point between = q.b.centre - q.a.centre;
  Rational least = 0;
  for (std::size_t i = 0; i < axis_count; ++i) {
    const Point along = direction(q, i);
    const Rational beyond =
        abs(Rational(dot(along, between))) - extent_along(without.a, along) - extent_along(without.b, along);
    const Rational slope = abs(Rational(dot(along, q.a.axis[0])));
    if (slope == 0 && beyond > 0) return std::nullopt;
    if (slope != 0) least = std::max(least, Rational(beyond / slope));
  }
  return least;
}

Rational orthonormality_defect(const ExactBox& box) {
  Rational greatest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k <= i; ++k) {
      greatest = std::max(greatest, Rational(abs(Rational(dot(box.axis[i], box.axis[k]) - (i == k ? 1 : 0)))));
    }
  }
  return greatest;
}

Rational squared_distance(const ExactPair& q) { return squared_distance(corners_of(q.a), corners_of(q.b)); }

Rational squared_scene(const ExactPair& q) {
  const Point between = q.b.centre - q.a.centre;
  Rational scene = dot(between, between);
  for (const ExactBox* box : {&q.a, &q.b}) {
    for (const Point& corner : corners_of(*box)) {
      const Point from = corner - box->centre;
      scene = std::max(scene, Rational(dot(from, from)));
    }
  }
  return scene;
}

ExactDepth exact_depth(const ExactPair& q) {
  const Rational scene = squared_scene(q), distance = squared_distance(q);
  if (scene == 0) return {0, 0, 1};
  return {distance > 0 ? distance : squared_penetration(q), 0, scene};
}

namespace {

Point point_of(const Vec3<ExactNumber>& v) { return {v.x.value, v.y.value, v.z.value}; }

template <class Entry, class Problem>
ExactBoxAndTriangle exactly(const Problem& q) {
  const Numbers<double> numbers = numbers_of(q);
  const BoxAndTriangle<ExactNumber> exact =
      oriented(Entry::template problem<ExactNumber>([&](std::size_t k) { return ExactNumber(numbers[k]); }));
  const OrientedBox<ExactNumber>& box = exact.box;
  return {{point_of(box.centre),
           {{box.half[0].value, box.half[1].value, box.half[2].value}},
           {{point_of(box.axis[0]), point_of(box.axis[1]), point_of(box.axis[2])}}},
          {{point_of(exact.corner[0]), point_of(exact.corner[1]), point_of(exact.corner[2])}}};
}

}  // namespace

std::vector<AxisRest> axis_rests(const ExactBoxAndTriangle& q) {
  std::vector<AxisRest> found;
  for (std::size_t i = 0; i < thirteen_count; ++i) {
    const Point along = direction(q, i);
    const Rational squared_length = dot(along, along);
    if (squared_length == 0) continue;
    std::array<Rational, 3> at;
    for (std::size_t k = 0; k < 3; ++k) at[k] = dot(along, q.corner[k] - q.box.centre);
    const auto [least, greatest] = std::minmax_element(at.begin(), at.end());
    const Rational ahead = *least, behind = -*greatest, half = extent_along(q.box, along);
    found.push_back({i, behind > ahead ? Point{} - along : along, behind == ahead, half - std::max(ahead, behind),
                     half - std::min(ahead, behind), squared_length});
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

ExactBoxAndTriangle exact_box_and_triangle(const CentredAndTriangle<double>& q) { return exactly<CentreEntry>(q); }
ExactBoxAndTriangle exact_box_and_triangle(const CornersAndTriangle<double>& q) { return exactly<MinmaxEntry>(q); }
ExactBoxAndTriangle exact_box_and_triangle(const BoxAndTriangle<double>& q) { return exactly<OrientedEntry>(q); }
ExactBoxAndTriangle exact_box_and_triangle(const TurnedAndTriangle<double>& q) {
  return {turned(q.box), each<Rational>(q.corner)};
}

Hull hull_of(const std::array<Point, 3>& corners) { return {corners.begin(), corners.end()}; }

Rational squared_penetration(const ExactBoxAndTriangle& q) { return least_squared(axis_rests(q)); }

std::vector<std::string_view> deciding_axes(const ExactBoxAndTriangle& q) {
  return names_of(deciding(axis_rests(q)), thirteen_names);
}

Rational squared_distance(const ExactBoxAndTriangle& q) {
  return squared_distance(corners_of(q.box), hull_of(q.corner));
}

ExactDepth exact_depth(const ExactBoxAndTriangle& q) {
  const Rational scene = squared_scene(q), distance = squared_distance(q);
  if (scene == 0) return {0, 0, 1};
  return {distance > 0 ? distance : squared_penetration(q), 0, scene};
}

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

// A character's sphere at the edge or a corner that two triangles share, in metres: where a walk passes from one to the
// next, and where an engine that loses both lets a character fall or stops it at nothing. The two are asked one after
// the other, at an even position and the next.
#include "fuzz/sphere_triangle/families/parts/scene.h"
#include "kernel/sphere_triangle/query.h"
#include "fuzz/queries/family.h"

namespace axiscert {
namespace {

using scenes::Point;

// The shared edge runs along x from the origin; the triangles lie to these sides of it. The first is seen from where
// the sphere is with its vertices counterclockwise if it begins at the origin, or else at the edge's other end; the
// second the other way round, as in a mesh.
struct Fold {
  Point first, second;
  bool at_origin;
};
enum Meeting : std::uint64_t { seam_of_floor, step_of_stairs, wall_on_floor, small_prop, meetings };
constexpr Fold folds[meetings] = {
    {{0, 1, 0}, {0, -1, 0}, true},
    {{0, -1, 0}, {0, 0, -1}, false},
    {{0, 1, 0}, {0, 0, 1}, true},
    {{0, -1, 0}, {0, 0, -1}, false},
};

// In metres: walls are as long as a level, props smaller than the sphere.
double shared_edge(Stream& random, std::uint64_t meeting) {
  const double any = scenes::any_length(random), small = scenes::length(random, 0.01, 4, 0.1);
  return meeting == wall_on_floor ? 100 : meeting == small_prop ? small : any;
}

// The sphere's centre above, beside or diagonally off the edge at `along`, or off its corner at the origin.
Point centre_at_fold(Stream& random, std::uint64_t meeting, bool at_corner, double along, double r, double height) {
  const double lean = random.unit<double>(), beyond = random.unit<double>(), aside = random.symmetric<double>() * r / 2;
  const bool passed = random.coin();
  if (meeting == step_of_stairs || meeting == small_prop) {
    return Point{along, 0, 0} + scenes::at_unit_length({at_corner ? -beyond : 0, lean, 1 - lean}) * height;
  }
  const double x = at_corner && passed ? (lean - beyond) * r / 2 : along;
  return meeting == wall_on_floor ? Point{x, height, height} : Point{x, passed ? aside : 0, height};
}

// At an even position the query of the first triangle, at the next, from the same numbers, that of the second.
template <class Real>
Query<Real> scene_edge(Stream& random, std::uint64_t position) {
  const std::uint64_t scene = position / 2, meeting = scene % meetings;
  const bool at_corner = scene / meetings % 2 == 1, second = position % 2 == 1;
  const Real r = scenes::radius<Real>(random);
  const double height = static_cast<double>(r) + scenes::gap(random, scene / (2 * meetings));
  const auto world = scenes::place(random, scene / (2 * meetings * scenes::gap_count));
  const bool level = random.coin() || meeting == step_of_stairs || meeting == wall_on_floor;
  const auto axes = scenes::axes(random, level);
  const double edge = shared_edge(random, meeting);
  const double along = at_corner ? 0 : edge * (0x1p-5 + 0.9375 * random.unit<double>());
  const Point sphere = centre_at_fold(random, meeting, at_corner, along, static_cast<double>(r), height);

  // Each triangle's third vertex: where it is along the edge, for half of them at a right angle, and how far from it.
  double foot[2], far[2];
  for (double& x : foot) {
    const bool at_right_angle = random.coin();
    const double share = random.unit<double>();
    x = at_right_angle ? 0 : edge * share;
  }
  for (double& y : far) y = edge * (0.25 + 0.75 * random.unit<double>());
  const Fold& fold = folds[meeting];
  const Point tip = Point{foot[second], 0, 0} + (second ? fold.second : fold.first) * far[second];
  const Point origin{0, 0, 0}, end{edge, 0, 0};
  std::array<Point, 3> corners =
      fold.at_origin != second ? std::array<Point, 3>{origin, end, tip} : std::array<Point, 3>{end, origin, tip};
  for (Point& corner : corners) corner = corner - Point{sphere.x, 0, 0};
  return scenes::query(random, world, axes, corners, {0, sphere.y, sphere.z}, r);
}

template <class Real>
void fill_scene_edges(const StreamName& name, std::uint64_t first, const MutableColumns<Real>& out) {
  for (std::size_t i = 0; i < out.size; ++i) {
    Stream random(name, (first + i) / 2);
    out.set(i, scene_edge<Real>(random, first + i));
  }
}

}  // namespace

extern const Family scene_edge_family = {sphere_triangle_predicate,
                                         "scene-edge",
                                         "metres: the same sphere at an edge or corner of two triangles: a floor's "
                                         "seam, a step, a wall of 100 m, a small prop",
                                         1,
                                         false,
                                         fill_scene_edges<float>,
                                         fill_scene_edges<double>,
                                         TrustGroup::scene};

}  // namespace axiscert

// Scenes of sphere-triangle in small integers, times a power of two: whatever the formulae, hardly an operation is
// rounded.
#include "fuzz/sphere_triangle/capability_parts.h"

#include <cmath>

#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "fuzz/diagnosis/scenes.h"
#include "fuzz/queries/floats.h"
#include "fuzz/queries/image_groups.h"
#include "fuzz/sphere_triangle/families/parts/boundary.h"
#include "fuzz/sphere_triangle/families/parts/images.h"
#include "fuzz/sphere_triangle/formulae/axis_windows.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert::diagnosis {
namespace {

using Whole = Vec3<int>;

// The part of the triangle that is nearest to the centre.
enum class Part : std::uint8_t { face, edge, vertex };

template <class Real>
Vec3<Real> in_reals(const Whole& v) {
  return {static_cast<Real>(v.x), static_cast<Real>(v.y), static_cast<Real>(v.z)};
}

bool is_zero(const Whole& v) { return v.x == 0 && v.y == 0 && v.z == 0; }

Whole drawn(Stream& random, int greatest) {
  const auto draw = [&] { return static_cast<int>(random.integer(-greatest, greatest)); };
  const int x = draw(), y = draw(), z = draw();
  return {x, y, z};
}

// A scene in another place: axes and vertices in another order, moved by small integers, times 1/2, 1 or 2.
template <class Real>
Query<Real> placed(Stream& random, const Query<Real>& q) {
  const Query<Real> turned = image(q, symmetries()[static_cast<std::size_t>(random.below(symmetry_count))]);
  const Vec3<Real> by = in_reals<Real>(drawn(random, 8));
  const Query<Real> moved{turned.a + by, turned.b + by, turned.c + by, turned.p + by, turned.r};
  return times_power(moved, static_cast<int>(random.integer(-1, 1)));
}

// Legs of length 8 along the axes.
template <class Real>
Query<Real> right_angled(const Whole& centre, int radius) {
  return {{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, in_reals<Real>(centre), static_cast<Real>(radius)};
}

template <class Real>
Query<Real> touching(Stream& random, Part part) {
  const int sign = random.coin() ? 1 : -1;
  const auto from = [&](int least, int greatest) { return static_cast<int>(random.integer(least, greatest)); };
  if (part == Part::face) {
    const int x = from(1, 3), y = from(1, 3), h = from(1, 6);
    return right_angled<Real>({x, y, sign * h}, h);
  }
  if (part == Part::edge) {
    const int k = from(1, 2), along = from(1, 7);
    // Beside the edge AB, or in the plane.
    constexpr int sides[][2] = {{3, 4}, {4, 3}, {5, 0}};
    const auto& side = sides[random.below(3)];
    return right_angled<Real>({along, -side[0] * k, sign * side[1] * k}, 5 * k);
  }
  constexpr int vectors[][4] = {{1, 2, 2, 3}, {2, 3, 6, 7}, {4, 4, 7, 9}, {3, 4, 0, 5}, {6, 2, 3, 7}};
  const auto& v = vectors[random.below(5)];
  return right_angled<Real>({-v[0], -v[1], sign * v[2]}, v[3]);
}

template <class Real>
Query<Real> flat(Stream& random, Flat kind, bool is_contact) {
  for (;;) {
    const Whole a = drawn(random, 4), d = drawn(random, 3), beside = drawn(random, 6);
    if (is_zero(d) || is_zero(beside)) continue;
    const auto at = [&](int t) { return in_reals<Real>(Whole{a.x + t * d.x, a.y + t * d.y, a.z + t * d.z}); };
    std::array<Vec3<Real>, 3> vertices;
    if (kind == Flat::point) vertices = {at(0), at(0), at(0)};
    else if (kind == Flat::two_equal) vertices = {at(0), at(0), at(2)};
    else vertices = {at(0), at(1), at(3)};
    const auto turn = static_cast<std::size_t>(random.below(3));
    Query<Real> q{vertices[turn], vertices[(turn + 1) % 3], vertices[(turn + 2) % 3], {}, 0};
    // Near a point of the segment or, apart, also beyond its ends.
    q.p = at(kind == Flat::point ? 0 : static_cast<int>(random.integer(is_contact ? 0 : -4, is_contact ? 2 : 6)));
    const int scale = is_contact ? 1 : 2;
    q.p = q.p + in_reals<Real>(Whole{scale * beside.x, scale * beside.y, scale * beside.z});
    q.r = 1;
    const double squared = nearest<double>(squared_distance(q));
    if (squared == 0) continue;
    // A power of two near four distances, or a quarter of one.
    const int exponent = std::ilogb(std::sqrt(squared));
    q.r = std::ldexp(Real(1), is_contact ? exponent + 3 : exponent - 2);
    return q;
  }
}

// The distance is a small integer times a power of two, exactly: lengths of edges are powers of two, and distances
// sides of triangles of integers, so that a method that divides and takes roots is exact too. The radius is the
// distance.
template <class Real>
TouchingScenes<Real> touching_spheres(Subject<Real>& subject, std::size_t count) {
  TouchingScenes<Real> scenes = {.queries = {},
                                 .part = {},
                                 .parts = {"face", "edge", "vertex"},
                                 .least = (3 * count + 3) / 4,
                                 .all_tell_of_slack = true,
                                 .what = "spheres",
                                 .length = "radius",
                                 .whole = "The sphere",
                                 .where = "at a distance of exactly r",
                                 .touches = "the distance is the radius"};
  for (const Part part : {Part::face, Part::edge, Part::vertex}) {
    for (std::size_t i = 0; i < count / 3; ++i) {
      Stream random = stream_of(subject.seed(), "touching", precision_of<Real>, scenes.queries.size());
      const Query<Real> q = touching<Real>(random, part);
      scenes.queries.push_back(placed(random, q));
      scenes.part.push_back(static_cast<std::size_t>(part));
    }
  }
  return scenes;
}

// The centre lies over the inside of the face, at half the radius from its plane: contact, and separated with a quarter
// of the radius.
template <class Real>
SidedScenes<Real> sided_spheres(Subject<Real>& subject, std::size_t count) {
  SidedScenes<Real> scenes = {.queries = {},
                              .apart = {},
                              .what = "spheres",
                              .whose = "a sphere whose centre is",
                              .front = "the centre is in front of the face, at half the radius",
                              .behind = "the centre is behind the face, at half the radius"};
  while (scenes.queries.size() < count) {
    Stream random = stream_of(subject.seed(), "sides", precision_of<Real>, scenes.queries.size());
    const int x = static_cast<int>(random.integer(1, 3)), y = static_cast<int>(random.integer(1, 3)),
              h = static_cast<int>(random.integer(1, 4));
    const int sign = scenes.queries.size() % 2 == 0 ? 1 : -1;
    Query<Real> q = placed(random, right_angled<Real>({x, y, sign * h}, 2 * h));
    // Small integers over 2: exact in any precision.
    const Real offset = dot(q.p - q.a, cross(q.b - q.a, q.c - q.a));
    scenes.queries.push_back({q, offset > 0});
    q.r *= Real(0.25);
    scenes.apart.push_back(q);
  }
  return scenes;
}

// Vertices on a line, exactly. The sphere is in contact with a radius of four distances or more, or apart by three
// radii or more.
template <class Real>
FlatScenes<Real> flat_spheres(Subject<Real>& subject, std::size_t of_each) {
  FlatScenes<Real> scenes = {.queries = {}, .apart = "is far away", .contact = "is well inside the sphere"};
  for (const Flat kind : {Flat::point, Flat::two_equal, Flat::collinear}) {
    for (std::size_t i = 0; i < of_each; ++i) {
      Stream random = stream_of(subject.seed(), "flat", precision_of<Real>, scenes.queries.size());
      const bool is_contact = i % 2 == 0;
      scenes.queries.push_back({flat<Real>(random, kind, is_contact), kind, is_contact});
    }
  }
  return scenes;
}

template <class Real>
Scenes<Real> spheres() {
  return {.clear = clear_window_queries<Real>,
          .touching = touching_spheres<Real>,
          .sided = sided_spheres<Real>,
          .flat = flat_spheres<Real>,
          .turning = plump_scenes<Real>,
          .small = small_of_high_degree<Real>,
          .scanned = scanned_exponents,
          .near_tie = sphere_near_tie<Real>};
}

}  // namespace

const DiagnosisScenes& sphere_triangle_scenes() {
  static const DiagnosisScenes scenes = {spheres<float>(), spheres<double>()};
  return scenes;
}

// Scenes with full significands, on which the last bit decides or none does.

namespace {

// Four points with full significands in (-1, 1), the radius 0.
template <class Real>
Query<Real> random_scene(Stream& random) {
  const auto point = [&] {
    const Real x = random.symmetric<Real>(), y = random.symmetric<Real>(), z = random.symmetric<Real>();
    return Vec3<Real>{x, y, z};
  };
  const Vec3<Real> a = point(), b = point(), c = point(), p = point();
  return {a, b, c, p, 0};
}

}  // namespace

template <class Real>
std::vector<ClearQuery<Real>> clear_window_queries(const Kernel& kernel, std::size_t count) {
  std::vector<ClearQuery<Real>> found;
  const Oracles& oracles = oracles_of(kernel);
  for (const Query<Real>& q : window_queries<Real>()) {
    if (found.size() < count) found.push_back({q, oracles.truth(Numbers<Real>(q)).verdict});
  }
  return found;
}

template <class Real>
Numbers<Real> sphere_near_tie(std::uint64_t seed, std::string_view probe, std::uint64_t position, std::size_t flat) {
  Stream random = stream_of(seed, probe, precision_of<Real>, position);
  for (;;) {
    Query<Real> q = random_scene<Real>(random);
    for (Vec3<Real>* point : {&q.a, &q.b, &q.c, &q.p}) {
      if (flat < 3) *std::array<Real*, 3>{&point->x, &point->y, &point->z}[flat] = 0;
    }
    q.r = step_radius(radius_at_distance(q), static_cast<int>(random.integer(-2, 2)));
    if (q.r > Real(0x1p-10)) return q;
  }
}

template <class Real>
TurningScenes<Real> plump_scenes(Subject<Real>& subject, std::size_t count) {
  TurningScenes<Real> scenes{{}, coordinate_count - 1, {}, {}, "the vertices", "the centre"};
  for (std::size_t k = 0; k < coordinate_count; ++k) {
    scenes.is_of_first.push_back(k < 9);
    scenes.is_of_second.push_back(k >= 9 && k < 12);
  }
  for (std::uint64_t position = 0; scenes.queries.size() < count; ++position) {
    Stream random = stream_of(subject.seed(), "turning", precision_of<Real>, position);
    Query<Real> q = random_scene<Real>(random);
    q.r = radius_at_distance(q);
    const Vec3<Real> ab = q.b - q.a, ac = q.c - q.a, bc = q.c - q.b, normal = cross(ab, ac);
    const Real longest = std::max({dot(ab, ab), dot(ac, ac), dot(bc, bc)});
    if (q.r < Real(0.125) || dot(normal, normal) < Real(0.0625) * longest * longest) continue;
    scenes.queries.push_back(q);
  }
  return scenes;
}

#define AXISCERT_INSTANCES(Real)                                                                             \
  template std::vector<ClearQuery<Real>> clear_window_queries<Real>(const Kernel&, std::size_t);             \
  template Numbers<Real> sphere_near_tie<Real>(std::uint64_t, std::string_view, std::uint64_t, std::size_t); \
  template TurningScenes<Real> plump_scenes(Subject<Real>&, std::size_t);
AXISCERT_INSTANCES(float)
AXISCERT_INSTANCES(double)
#undef AXISCERT_INSTANCES

}  // namespace axiscert::diagnosis

// Motions past the triangles of a mesh, made of the spheres that fill_mesh_queries() places about them. Everything is
// in binary64 with + - * / sqrt and powers of two, one query at a time; the query's own precision enters with the last
// rounding, and where a character adds its steps up.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "fuzz/sphere_triangle/families/parts/shapes.h"
#include "fuzz/moving_sphere/mesh_motion.h"
#include "fuzz/sphere_triangle/mesh_queries.h"
#include "kernel/moving_sphere/moving_sphere.h"

namespace axiscert {
namespace mesh_motion {
namespace {

using Place = Vec3<double>;

double length_of(const Place& v) { return std::sqrt(dot(v, v)); }
// The direction of v, or the other one where v has none: its length is 0, or not a number.
Place direction_of(const Place& v, const Place& other) {
  const double size = length_of(v);
  return size > 0 && std::isfinite(size) ? v / size : other;
}
// Any direction, denser towards the vertices of a cube than towards its faces.
Place any_direction(Stream& random) { return direction_of(shapes::in_cube<double>(random), {1, 0, 0}); }

// A number from 2^low to 2^high.
double power_between(Stream& random, std::int64_t low, std::int64_t high) {
  const auto exponent = static_cast<int>(random.integer(low, high - 1));
  return std::ldexp(1 + random.unit<double>(), exponent);
}

// A placement without its motion: the triangle, where the sphere is, and its sizes.
struct PlacedScene {
  Place a, b, c, p;
  double r, edge;  // the mean edge, or 1 where the triangle is a point
  Place normal;    // of unit length; any direction where the triangle has no area

  PlacedScene(const Query<double>& q, Stream& random) : a(q.a), b(q.b), c(q.c), p(q.p), r(q.r) {
    const double mean = (length_of(b - a) + length_of(c - b) + length_of(a - c)) / 3;
    edge = mean > 0 && std::isfinite(mean) ? mean : 1;
    const Place any = any_direction(random);
    normal = direction_of(cross(b - a, c - a), any);
  }
  Place on_face(Stream& random) const {
    const double s = random.unit<double>(), t = random.unit<double>();
    const bool beyond = s + t > 1;
    return a + (b - a) * (beyond ? 1 - s : s) + (c - a) * (beyond ? 1 - t : t);
  }
};

// A motion before its last rounding: `steps` earlier ones as long have led to the point from `p`.
struct UnroundedMotion {
  Place p, d;
  double r;
  int steps = 0;
};

// One of up to sixteen steps along the face. Every other walker has a radius of 0.3, a character's in metres, and
// stands as far from the face, sunk in or hovering by up to a hundredth.
UnroundedMotion walk(Stream& random, const PlacedScene& at, Placement placement) {
  UnroundedMotion m{at.p, {0, 0, 0}, at.r};
  const bool is_character = random.coin();
  const double gap = random.unit<double>() * 0.01, share = power_between(random, -6, 0);
  m.steps = static_cast<int>(random.below(16));
  const Place across = cross(at.normal, any_direction(random));
  if (is_character) {
    const double height = dot(at.p - at.a, at.normal), side = height < 0 ? -1 : 1;
    m.r = static_cast<double>(0.3f);
    const double stands = placement == Placement::resting   ? m.r
                          : placement == Placement::sinking ? m.r * (1 - gap)
                                                            : m.r * (1 + gap);
    m.p = at.p + at.normal * (side * stands - height);
  }
  m.d = direction_of(across, at.b - at.a) * (m.r * share);
  return m;
}

// From above the place to it or, every other time, by up to four radii beyond it.
UnroundedMotion drop(Stream& random, const PlacedScene& at) {
  const bool goes_on = random.coin();
  const double fall = at.r * power_between(random, -4, 5), beyond = at.r * 4 * random.unit<double>();
  // Along the normal on the side of the sphere, or straight down one axis, as gravity is.
  const bool down_an_axis = random.coin();
  const auto axis = random.below(3);
  const Place down = down_an_axis ? Place{axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0}
                                  : at.normal * (dot(at.p - at.a, at.normal) < 0 ? 1.0 : -1.0);
  return {at.p - down * fall, down * (goes_on ? fall + beyond : fall), at.r};
}

// 2^2 to 2^10 mean edges in one step, past where the placement has its tiny sphere.
UnroundedMotion shoot(Stream& random, const PlacedScene& at) {
  const double far = at.edge * power_between(random, 2, 10), share = random.unit<double>();
  const Place d = any_direction(random) * far;
  return {at.p - d * share, d, at.r};
}

// To a point of the face, or on the way there, or as far beyond it.
UnroundedMotion arrive(Stream& random, const PlacedScene& at) {
  const Place target = at.on_face(random);
  const double share = 2 * random.unit<double>();
  return {at.p, (target - at.p) * share, at.r};
}

UnroundedMotion shake(Stream& random, const PlacedScene& at) {
  const double far = (at.r > 0 ? at.r : at.edge) * power_between(random, -24, -6);
  return {at.p, any_direction(random) * far, at.r};
}

UnroundedMotion moved_at(Stream& random, const PlacedScene& at, MeshMotion motion, Placement placement) {
  switch (motion) {
    case MeshMotion::walking:
      return walk(random, at, placement);
    case MeshMotion::dropped:
      return drop(random, at);
    case MeshMotion::bullet:
      return shoot(random, at);
    case MeshMotion::arriving:
      return arrive(random, at);
    case MeshMotion::shaking:
      return shake(random, at);
  }
  return {};
}

// Rounded once; numbers beyond the range, and none, become the greatest of their sign, or 0.
template <class Real>
Vec3<Real> finite(const Place& v) {
  constexpr double greatest = static_cast<double>(std::numeric_limits<Real>::max());
  const auto one = [&](double x) {
    return std::isnan(x) ? Real(0) : static_cast<Real>(std::clamp(x, -greatest, greatest));
  };
  return {one(v.x), one(v.y), one(v.z)};
}

template <class Real>
MovingQuery<Real> query_of(const Query<Real>& placed, const UnroundedMotion& m) {
  MovingQuery<Real> q{placed.a, placed.b, placed.c, finite<Real>(m.p), finite<Real>(m.d), finite<Real>({m.r, 0, 0}).x};
  for (int i = 0; i < m.steps; ++i) {
    const Vec3<Real> next = q.p + q.d;  // as a character's place is kept, with a rounding each step
    if (!std::isfinite(next.x) || !std::isfinite(next.y) || !std::isfinite(next.z)) break;
    q.p = next;
  }
  return q;
}

}  // namespace
}  // namespace mesh_motion

MeshMotion mesh_motion_at(std::uint64_t position, std::uint64_t triangles) {
  const bool is_shaken = position / triangles / placement_count % 2 == 1;
  switch (placement_at(position, triangles)) {
    case Placement::resting:
    case Placement::sinking:
    case Placement::hovering:
      return is_shaken ? MeshMotion::shaking : MeshMotion::walking;
    case Placement::edge_graze:
    case Placement::vertex_graze:
      return is_shaken ? MeshMotion::shaking : MeshMotion::dropped;
    case Placement::centre_on:
      return MeshMotion::bullet;
    case Placement::far:
      return MeshMotion::arriving;
  }
  return MeshMotion::shaking;
}

template <class Real>
void fill_mesh_motions(const Mesh& mesh, const StreamName& placed, const StreamName& moving, std::uint64_t first,
                       const MutableColumns<Real>& out) {
  constexpr std::size_t block = 512;
  QueryBatch<Real> places(std::min(block, out.size), coordinate_count);
  const std::uint64_t triangles = mesh.triangles.size();
  for (std::size_t begin = 0; begin < out.size; begin += block) {
    places.resize(std::min(block, out.size - begin));
    fill_mesh_queries(mesh, placed, first + begin, places.mutable_columns());
    for (std::size_t i = 0; i < places.size(); ++i) {
      const std::uint64_t position = first + begin + i;
      Stream random(moving, position);
      const Query<Real> q = places[i];
      const mesh_motion::PlacedScene at(widened(q), random);
      const MeshMotion motion = mesh_motion_at(position, triangles);
      const mesh_motion::UnroundedMotion move =
          mesh_motion::moved_at(random, at, motion, placement_at(position, triangles));
      out.set(begin + i, mesh_motion::query_of(q, move));
    }
  }
}
template void fill_mesh_motions<float>(const Mesh&, const StreamName&, const StreamName&, std::uint64_t,
                                       const MutableColumns<float>&);
template void fill_mesh_motions<double>(const Mesh&, const StreamName&, const StreamName&, std::uint64_t,
                                        const MutableColumns<double>&);

extern const MeshQueries moving_sphere_mesh = {
    "a real mesh's triangles: steps of a walking sphere, balls dropped on edges and vertices, bullets, arrivals from "
    "afar, a shaking camera",
    1, 0, fill_mesh_motions<float>, fill_mesh_motions<double>};

}  // namespace axiscert

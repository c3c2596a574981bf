// The families of the capsule: motions by their ends, as capsules, and scenes of its own.
#include <array>
#include <cmath>

#include "fuzz/capsule_triangle/situations.h"
#include "fuzz/queries/floats.h"
#include "kernel/capsule_triangle/capsule.h"

namespace axiscert {
namespace moving_sphere {

extern const Family moving_sphere_ends_general_family, moving_sphere_ends_graze_family, moving_sphere_ends_touch_family,
    moving_sphere_ends_slide_family, moving_sphere_ends_along_family, moving_sphere_ends_approach_family,
    moving_sphere_ends_huge_family, moving_sphere_ends_still_family, moving_sphere_ends_line_family,
    moving_sphere_ends_point_family, moving_sphere_ends_lattice_family;

}  // namespace moving_sphere

namespace capsule {
namespace {

using portable::cross;
using portable::dot;
using portable::Vec3;

// The columns of a motion by its ends are those of a capsule.
template <const Family& motions, class Real>
void fill_capsules(const StreamName& stream, std::uint64_t first, const MutableColumns<Real>& out) {
  if constexpr (sizeof(Real) == 4) motions.binary32(stream, first, out);
  else motions.binary64(stream, first, out);
}
template <const Family& motions>
constexpr Family as_capsules(std::string_view name, const Situation& situation, std::string_view purpose,
                             bool exact_arithmetic = false) {
  return {.predicate = capsule_triangle_predicate,
          .name = name,
          .purpose = purpose,
          .version = 1,
          .exact_arithmetic = exact_arithmetic,
          .binary32 = fill_capsules<motions, float>,
          .binary64 = fill_capsules<motions, double>,
          .situation = &situation};
}
template <auto one32, auto one64>
constexpr Family own(std::string_view name, const Situation& situation, std::string_view purpose) {
  return {.predicate = capsule_triangle_predicate,
          .name = name,
          .purpose = purpose,
          .version = 1,
          .exact_arithmetic = false,
          .binary32 = fill_one_by_one<one32, float>,
          .binary64 = fill_one_by_one<one64, double>,
          .situation = &situation};
}

// A face of about a metre of hilly ground, whose normal N points upwards.
template <class Real>
struct Ground {
  std::array<Vec3<Real>, 3> corner;
  Vec3<Real> normal;
};
template <class Real>
Ground<Real> ground(Stream& random) {
  const auto around = [&](Real x, Real y) {
    const Real dx = random.symmetric<Real>(), dy = random.symmetric<Real>(), height = random.symmetric<Real>();
    return Vec3<Real>{x + dx * Real(0.25), y + dy * Real(0.25), height * Real(0.375)};
  };
  const Vec3<Real> a = around(0, 0), b = around(1, 0), c = around(0, 1);
  return {{a, b, c}, cross(b - a, c - a)};
}
// A point of it, by chance near an edge.
template <class Real>
Vec3<Real> somewhere(Stream& random, const Ground<Real>& of) {
  Real s = (random.symmetric<Real>() + Real(1)) * Real(0.5), t = (random.symmetric<Real>() + Real(1)) * Real(0.5);
  if (s + t > Real(1)) {
    s = Real(1) - s;
    t = Real(1) - t;
  }
  return of.corner[0] + (of.corner[1] - of.corner[0]) * s + (of.corner[2] - of.corner[0]) * t;
}
template <class Real>
Numbers<Real> capsule_of(const Ground<Real>& of, const Vec3<Real>& p, const Vec3<Real>& q, Real r) {
  return EndsQuery<Real>{of.corner[0], of.corner[1], of.corner[2], p, q, r};
}

// A character of 1.8 m that stands: the lower ball on the face but for roundings, or up to 5 cm above or in it.
template <class Real>
Numbers<Real> standing(Stream& random, std::uint64_t position) {
  const Ground<Real> face = ground<Real>(random);
  const Real r = Real(0.3), height = Real(1.2), length = std::sqrt(dot(face.normal, face.normal));
  Vec3<Real> p = somewhere(random, face) + face.normal * (r / length);
  if (position % 2 != 0) p.z = p.z + random.symmetric<Real>() * Real(0.05);
  return capsule_of(face, p, Vec3<Real>{p.x, p.y, p.z + height}, r);
}

// A limb of 40 cm across an edge of the ground or over its face, near contact along its side.
template <class Real>
Numbers<Real> lying(Stream& random, std::uint64_t position) {
  const Ground<Real> face = ground<Real>(random);
  const std::size_t i = position % 3;
  const Vec3<Real> from = face.corner[i], edge = face.corner[(i + 1) % 3] - from;
  const Real t = (random.symmetric<Real>() + Real(1)) * Real(0.5), r = Real(0.06);
  const Vec3<Real> at = position / 3 % 2 == 0 ? from + edge * t : somewhere(random, face);
  Vec3<Real> along{random.symmetric<Real>(), random.symmetric<Real>(), random.symmetric<Real>() * Real(0.25)};
  const Vec3<Real> out = cross(cross(along, face.normal), along);
  const Real out2 = dot(out, out);
  if (!(out2 > 0)) along = edge;
  const Real scale = out2 > 0 ? (r + random.symmetric<Real>() * Real(0.01)) / std::sqrt(out2) : Real(0);
  const Vec3<Real> middle = at + out * scale, half = along * Real(0.2);
  return capsule_of(face, middle - half, middle + half, r);
}

const Family general_family = as_capsules<moving_sphere::moving_sphere_ends_general_family>(
                 "capsule-triangle/general", situation::everyday, "capsules of everyday sizes, near contact or not"),
             graze_family = as_capsules<moving_sphere::moving_sphere_ends_graze_family>(
                 "capsule-triangle/graze", situation::touching, "their sides touch, or miss by ulps"),
             touch_family = as_capsules<moving_sphere::moving_sphere_ends_touch_family>(
                 "capsule-triangle/touch", situation::touching, "one end touches, or misses by ulps"),
             slide_family = as_capsules<moving_sphere::moving_sphere_ends_slide_family>(
                 "capsule-triangle/slide", situation::parallel, "parallel to the face"),
             along_family = as_capsules<moving_sphere::moving_sphere_ends_along_family>(
                 "capsule-triangle/along", situation::parallel, "parallel to an edge"),
             approach_family = as_capsules<moving_sphere::moving_sphere_ends_approach_family>(
                 "capsule-triangle/approach", situation::far, "one end far away, the other near"),
             long_family = as_capsules<moving_sphere::moving_sphere_ends_huge_family>(
                 "capsule-triangle/long", situation::far, "many times as long as the triangle"),
             ball_family = as_capsules<moving_sphere::moving_sphere_ends_still_family>(
                 "capsule-triangle/ball", situation::ball, "both ends are one point: the static sphere"),
             line_family = as_capsules<moving_sphere::moving_sphere_ends_line_family>(
                 "capsule-triangle/line", situation::zero_area, "triangles without area"),
             segment_family = as_capsules<moving_sphere::moving_sphere_ends_point_family>(
                 "capsule-triangle/segment", situation::segment, "radius 0, or nearly"),
             lattice_family = as_capsules<moving_sphere::moving_sphere_ends_lattice_family>(
                 "capsule-triangle/lattice", situation::small_integers,
                 "small integers: every operation of twenty is exact", true),
             standing_family =
                 in_metres(own<standing<float>, standing<double>>("capsule-triangle/scene_stand", situation::everyday,
                                                                  "a character of 1.8 m on hilly ground, in metres")),
             lying_family = in_metres(own<lying<float>, lying<double>>(
                 "capsule-triangle/scene_lie", situation::everyday, "a limb across an edge or a face, in metres"));

}  // namespace
}  // namespace capsule

std::span<const Family* const> capsule_triangle_families() {
  using namespace capsule;
  static const Family* const all[] = {&general_family,  &graze_family,    &touch_family, &slide_family, &along_family,
                                      &approach_family, &long_family,     &ball_family,  &line_family,  &segment_family,
                                      &lattice_family,  &standing_family, &lying_family};
  return all;
}

}  // namespace axiscert

// Motions at every power of two: clear ones, whose faults are of range and not of rounding, and small integers in other
// units of length, on which nothing is rounded.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "exact/moving_sphere/motion_distance.h"
#include "fuzz/moving_sphere/parts.h"
#include "fuzz/sphere_triangle/families/parts/images.h"
#include "fuzz/sphere_triangle/families/parts/lattice_bounds.h"

namespace axiscert::moving_sphere {
namespace {

// From the power that leaves one bit of a subnormal to that at which numbers below 2 just remain finite.
template <class Real>
int power_in_turn(std::uint64_t position) {
  using Limits = std::numeric_limits<Real>;
  constexpr int least = Limits::min_exponent - Limits::digits, greatest = Limits::max_exponent - 1;
  return least + static_cast<int>(position % (greatest - least + 1));
}

// The radius is half the least distance of the motion or less, or twice it or more, and below two; a motion through the
// triangle has a radius other than 0.
template <class Real>
Numbers<Real> clear_motion(Stream& random, std::uint64_t position) {
  const auto [a, b, c] = shapes::vertices_in_cube<Real>(random);
  const Vec3<Real> p = shapes::in_cube<Real>(random), d = shapes::in_cube<Real>(random);
  MovingQuery<Real> q{a, b, c, p, d, 0};
  const auto wide = [](const Vec3<Real>& v) {
    return Vec3<double>{static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
  };
  const Real distance =
      nearest_sqrt<Real>(least_distance(MovingQuery<double>{wide(a), wide(b), wide(c), wide(p), wide(d), 0}).squared);
  const Real share = random.unit<Real>() * Real(0.5);
  const bool wants_separated = random.coin(), is_separated = distance > 0 && (wants_separated || distance >= Real(0.5));
  q.r = is_separated ? distance * share : distance * 2 + share;
  return times_power<Real>(q, power_in_turn<Real>(position));
}

// As in `lattice`. Every difference of points is below 2 m and, seen from the end of the motion, below 3 m: as that of
// integers up to 3/2 m, for which the range of forms of degree 6 is known.
template <class Real>
constexpr std::int64_t lattice_bound = sizeof(Real) == 4 ? 3 : 90;
template <class Real>
constexpr PowerRange units_range = range_of_degree_6<Real>((3 * lattice_bound<Real> + 1) / 2);
PowerRange units_range_in(Precision precision) {
  return precision == Precision::binary32 ? units_range<float> : units_range<double>;
}

// Whether the path goes through the inside of the triangle, farther than r from its edges, with both ends farther than
// r from its plane: that it crosses the face decides, and nothing else does.
template <class Real>
bool crosses_alone(const MovingQuery<Real>& q) {
  const auto length = [](const Vec3<Real>& v) { return std::sqrt(dot(v, v)); };
  const std::array<Vec3<Real>, 3> corner = {q.a - q.p, q.b - q.p, q.c - q.p};
  const Vec3<Real> normal = cross(q.b - q.a, q.c - q.a);
  const Real before = dot(corner[0], normal), after = before - dot(q.d, normal), height = q.r * length(normal);
  bool left = true, right = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3<Real> across = cross(q.d, corner[(k + 1) % 3] - corner[k]);
    const Real side = dot(corner[k], across), beside = q.r * length(across);
    left = left && side > beside;
    right = right && -side > beside;
  }
  return (left || right) && std::min(before, after) < -height && std::max(before, after) > height;
}

// Small integers; every fourth base, of the largest, crosses the face alone.
template <class Real>
Numbers<Real> lattice_base(Stream& random, std::uint64_t base) {
  constexpr int attempts = 512;
  const bool is_crossing = base % 4 == 3;
  const auto draw = [&](std::int64_t m) { return small_integers<Real>(random, m); };
  auto q = draw(is_crossing ? lattice_bound<Real>
                            : std::array{std::int64_t{1}, std::int64_t{2}, lattice_bound<Real>}[base % 3]);
  for (int k = 0; is_crossing && k < attempts; ++k) {
    q.r = Real(0.5);
    if (crosses_alone(q)) break;
    q = draw(lattice_bound<Real>);
  }
  return q;
}

template <class Real>
void fill_units(const StreamName& name, std::uint64_t first, const MutableColumns<Real>& out) {
  fill_groups(name, first, out, unit_images::count, lattice_base<Real>,
              [](Stream&, const Numbers<Real>& q, std::uint64_t base, std::size_t i) {
                return times_power(q, unit_images::exponent(units_range<Real>, base, i));
              });
}

}  // namespace

extern const ImageGroup moving_sphere_units_group = {moving_sphere_predicate,
                                                     "moving-sphere/units",
                                                     unit_images::count,
                                                     [](std::size_t) {
                                                       return std::array<std::uint8_t, 3>{0, 1, 2};
                                                     },
                                                     [](std::size_t) { return ImageKind::scale; },
                                                     [](Precision precision, std::uint64_t base, std::size_t i) {
                                                       return unit_images::exponent(units_range_in(precision), base, i);
                                                     },
                                                     units_range_in};

extern const Family moving_sphere_units_family = {
    .predicate = moving_sphere_predicate,
    .name = "moving-sphere/units",
    .purpose =
        "small integers, and times seven powers of two, 2^-20 to 2^16 or 2^-170 to 2^161: every operation is exact",
    .version = 2,
    .exact_arithmetic = true,
    .binary32 = fill_units<float>,
    .binary64 = fill_units<double>,
    .situation = &situation::units};
extern const Family moving_sphere_scale_family = moving_family<clear_motion<float>, clear_motion<double>>(
    "moving-sphere/scale", situation::units,
    "clear motions (r at most half the distance, or at least twice) times every power of two in turn");

}  // namespace axiscert::moving_sphere

// Parts of everyday scenes, in metres: crates and characters as an engine holds them, and how far from touching a
// solver leaves them. The second axis of the world is up.
#pragma once

#include <algorithm>

#include "fuzz/boxes/parts.h"
#include "fuzz/sphere_triangle/families/parts/scene.h"

namespace axiscert::boxes {

// q in floats, divided by its length in floats.
template <class Real>
Quaternion unit_quaternion(const Quaternion& q) {
  std::array<Real, 4> v;
  Real square = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    v[k] = static_cast<Real>(q[k]);
    square += v[k] * v[k];
  }
  const Real length = std::sqrt(square);
  Quaternion unit;
  for (std::size_t k = 0; k < 4; ++k) unit[k] = static_cast<double>(v[k] / length);
  return unit;
}

// Half extents of 0.1 to 1 m, of a cube every other time.
template <class Real>
void set_crate(Stream& random, std::array<Real, 3>& half) {
  const bool is_cube = random.coin();
  for (Real& s : half) s = Real(0.1) + Real(0.9) * random.unit<Real>();
  if (is_cube) half[1] = half[2] = half[0];
}
// A crate, or every third time a character: 0.6 m wide and 1.8 m high.
template <class Real>
void set_body(Stream& random, std::array<Real, 3>& half) {
  set_crate(random, half);
  if (random.below(3) == 0) half = {Real(0.3), Real(0.9), Real(0.3)};
}

// About the vertical, any angle: of a half turn times a fraction of 2^-12.
inline Quaternion any_yaw(Stream& random) {
  const auto w = static_cast<double>(random.integer(-2048, 2048)), y = static_cast<double>(random.integer(1, 2048));
  return {w, 0, y, 0};
}
// So little that a solver leaves it: yaw and tilts of 2^-4 to 2^-24 each.
inline Quaternion disturbance(Stream& random) {
  const auto small = [&] {
    const auto exponent = static_cast<int>(random.integer(5, 25));
    const bool is_negative = random.coin();
    return std::ldexp(is_negative ? -1.0 : 1.0, 25 - exponent);
  };
  const double x = small(), y = small(), z = small();
  return {0x1p25, x, y, z};
}

// How far two bodies are from touching, in metres, negative in contact. In turn: at rest, but for roundings; as a
// solver leaves them, from a micrometre to 8 mm to either side; apart by 2 to 64 cm; in contact by 2 to 8 cm.
inline constexpr std::uint64_t gap_count = 4;
inline double gap_in_turn(Stream& random, std::uint64_t turn) {
  const double slop = scenes::length(random, 1e-6, 13, 0.01), apart = scenes::length(random, 0.02, 5, 1);
  const double deep = scenes::length(random, 0.02, 2, 0.1);
  const bool is_apart = random.coin();
  switch (turn % gap_count) {
    case 0:
      return 0;
    case 1:
      return is_apart ? slop : -slop;
    case 2:
      return apart;
    default:
      return -deep;
  }
}

// The unit normal of the box's facets on its axis k, which is that axis but for what the matrix lacks of a rotation.
inline Arrow unit_facet(const OrientedBox<double>& box, std::size_t k) {
  return scenes::at_unit_length(facet_normal(box, k));
}

// Whether an axis of length 1 is at right angles to a direction, but for the roundings of a product of doubles.
inline bool is_across(double slope) { return std::fabs(slope) < 0x1p-40; }

// The point of the box farthest along `direction`, from its centre. Of an edge or a facet across it, any point.
inline Arrow farthest_of_box(Stream& random, const OrientedBox<double>& box, const Arrow& direction) {
  Arrow sum{0, 0, 0};
  for (std::size_t k = 0; k < 3; ++k) {
    const double slope = dot(direction, box.axis[k]), any = random.symmetric<double>();
    const double share = is_across(slope) ? any : slope > 0 ? 1 : -1;
    sum = sum + box.axis[k] * (box.half[k] * share);
  }
  return sum;
}

// B's centre where its foot, the farthest point against `up`, is `gap` above the farthest of A along it. Of an edge or
// a facet of A across `up` B's centre is above any point, unless its foot were beyond the end.
template <class Pair>
void lay_on(Stream& random, Pair& q, const Arrow& up, double gap) {
  const OrientedBox<double> a = box_in_doubles(q.a), b = box_in_doubles(q.b);
  const Arrow foot = farthest_of_box(random, b, up * -1.0);
  Arrow at = a.centre;
  for (std::size_t k = 0; k < 3; ++k) {
    const double slope = dot(up, a.axis[k]), any = random.symmetric<double>(), half = a.half[k];
    const double below_centre = std::clamp(any * half + dot(foot, a.axis[k]), -half, half);
    at = at + a.axis[k] * (is_across(slope) ? below_centre : slope > 0 ? half : -half);
  }
  q.b.centre = rounded_arrow<RealOf<Pair>>(at + (up * gap - foot));
}

template <class Pair>
void in_any_order(Stream& random, Pair& q) {
  if (random.coin()) std::swap(q.a, q.b);
}

}  // namespace axiscert::boxes

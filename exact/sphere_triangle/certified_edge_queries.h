// For tests: queries at the edges of the exact step's sizes of integers, and of the scaling before the fine step.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>

#include "kernel/sphere_triangle/query.h"

namespace axiscert::testing_support {

// The order of the vertices and of the axes, and the direction of each axis, at random: none changes the answer.
inline Query<double> turned(const Query<double>& q, std::mt19937_64& random) {
  std::array<std::array<double, 3>, 4> points = {
      {{q.a.x, q.a.y, q.a.z}, {q.b.x, q.b.y, q.b.z}, {q.c.x, q.c.y, q.c.z}, {q.p.x, q.p.y, q.p.z}}};
  std::array<std::size_t, 3> axes = {0, 1, 2};
  std::shuffle(axes.begin(), axes.end(), random);
  std::shuffle(points.begin(), points.begin() + 3, random);
  const std::uint64_t mirrored = random();
  std::array<double, coordinate_count> v;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < 3; ++k) v[3 * i + k] = (mirrored >> k & 1 ? -1 : 1) * points[i][axes[k]];
  }
  v[12] = q.r;
  return from_coordinates(v);
}

// An odd integer of `bits` bits.
inline double odd(int bits, std::mt19937_64& random) {
  return static_cast<double>((random() >> (64 - bits)) | (std::uint64_t{1} << (bits - 1)) | 1);
}
// A double just below 2^top, or 2^top's greatest predecessor.
inline double almost(int top, std::mt19937_64& random) {
  const double below = random() % 2 ? 1 : odd(10, random);
  return std::ldexp(0x1p53 - below, top - 53);
}

// Integers of which the greatest are just below 2^(n - 1), and one is odd: n is what the exact step chooses its
// integers by. The vertices lie at corners of that cube and the centre at the opposite one, so that no value of the
// first two degrees can be greater; or anywhere on its corners, faces and edges, which makes large normals.
inline Query<double> widest_query(int n, std::mt19937_64& random) {
  std::array<double, coordinate_count> v;
  const bool is_one_corner = random() % 2;
  for (std::size_t k = 0; k < 12; ++k) {
    const double side = k < 9 ? 1 : -1;
    v[k] = side * almost(n - 1, random);
    if (is_one_corner) continue;
    const std::uint64_t kind = random() % 8;
    if (kind < 4) v[k] = -v[k];
    if (kind == 0) v[k] = 0;
    if (kind == 1) v[k] = odd(std::min(n - 2, 30), random);
  }
  if (random() % 4 == 0) std::copy_n(v.begin(), 3, v.begin() + 3);
  if (random() % 4 == 0) std::copy_n(v.begin() + 3, 3, v.begin() + 6);
  const int radius_bits =
      random() % 2 ? 1 : 1 + static_cast<int>(random() % static_cast<std::uint64_t>(std::min(n - 2, 52)));
  v[12] = odd(radius_bits, random);
  if (random() % 4 == 0) {  // the radius is great too, and another number is odd
    v[12] = almost(n - 1, random);
    v[6 + random() % 3] = odd(std::min(n - 2, 30), random);
  }
  return turned(from_coordinates(v), random);
}

// An edge from corner to corner of the same cube, and a centre of integers of `bits` bits beside its middle: the edge's
// normal is what is left of numbers 2^n times as great, and earlier steps cannot tell its sign. The radius is the
// integer next to the distance or differs from it by a few.
inline Query<double> beside_an_edge_query(int n, int bits, std::mt19937_64& random) {
  const double m = almost(n - 1, random);
  std::array<double, 3> c;
  for (double& x : c) x = odd(bits, random) * (random() % 2 ? 1 : -1);
  // To the line through the origin along (1, 1, 1).
  const double along = (c[0] + c[1] + c[2]) / 3;
  const double distance = std::hypot(c[0] - along, c[1] - along, c[2] - along);
  const double r = std::max(0.0, std::floor(distance) + static_cast<double>(random() % 4) - 1);
  const double far = std::ldexp(-1.0, static_cast<int>(random() % static_cast<std::uint64_t>(n - 1 - bits)));
  return turned({{m, m, m}, {-m, -m, -m}, {far * c[0], far * c[1], far * c[2]}, {c[0], c[1], c[2]}, r}, random);
}

// A plane that contains (3, 4, 0) and the third axis, and a sphere at distance 5s of it with a radius of 5s, or next to
// that. Some of its numbers are tiny and lose their last bits where the query is scaled so that its greatest number is
// near 1: then it touches where it did not, or the reverse. It is decided without scaling.
inline Query<double> losing_query(std::mt19937_64& random) {
  const int scene = 100 + static_cast<int>(random() % 900);  // the greatest number is 2^scene
  constexpr int bits = 28;
  const auto tiny = [&] { return std::ldexp(odd(bits, random), scene - 1075 - static_cast<int>(random() % bits)); };
  double t = 0, s = 0, r = 0;
  switch (random() % 4) {
    case 0:  // the triangle alone
      t = tiny();
      break;
    case 1:  // the sphere alone
      s = tiny();
      break;
    case 2:  // both
      t = tiny(), s = tiny();
      break;
    default:  // the radius alone
      s = std::ldexp(odd(8, random), scene - 1074);
      r = std::nextafter(5 * s, random() % 2 ? 1 : 0);
  }
  if (r == 0) r = 5 * s;
  const double K = std::ldexp(1, scene - static_cast<int>(random() % 40) - 3), G = std::ldexp(1, scene);
  return turned({{3 * t, 4 * t, G}, {-3 * K, -4 * K, -G}, {3 * K, 4 * K, -G}, {-4 * s, 3 * s, 0}, r}, random);
}

}  // namespace axiscert::testing_support

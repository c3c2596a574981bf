// For tests: queries that the certified predicate's last steps decide.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <utility>

#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "kernel/random_testing.h"
#include "kernel/sphere_triangle/certified/integer.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert::testing_support {

// A sphere whose radius is within one ulp of the distance.
template <class Real>
Query<Real> tangent_query(std::mt19937_64& random) {
  Query<Real> q = random_query<Real>(random, false);
  const Real d = static_cast<Real>(std::sqrt(squared_distance(q).get_d()));
  q.r = random() % 3 == 0 ? d : std::nextafter(d, random() % 2 ? Real(0) : Real(4));
  return q;
}

// Queries of integers whose margins are zero, or are far smaller than the terms of which they are the difference but
// not negligible: a centre on the plane or on an edge, with a sphere of any size or of radius 0; or a sphere that
// touches an edge, or misses it by less than 2^-100 of its radius. In some queries small multiples of the least number
// replace zeros.
template <class Real>
Query<Real> integer_query(std::mt19937_64& random) {
  const int bits = static_cast<int>(4 + random() % (random() % 2 ? std::numeric_limits<Real>::digits - 6 : 4));
  const auto below = [&](int n) { return static_cast<std::int64_t>(random() >> (64 - n)); };
  const auto point = [&](std::int64_t unit) {
    const auto one = [&] { return (below(bits) - (std::int64_t{1} << (bits - 1))) * unit; };
    return Vec3<std::int64_t>{one(), one(), one()};
  };
  Vec3<std::int64_t> a = point(4), b = point(4), c = point(4), p = (a + a + b + c) / std::int64_t{4};
  std::int64_t r = random() % 2 ? 0 : below(3);
  if (random() % 3 == 0) p = (a + b) / std::int64_t{2};
  if (random() % 2 == 0) {
    r = random() % 4 ? (std::int64_t{1} << bits) + below(bits) : 0;
    const unsigned longest = static_cast<unsigned>(57 - bits / 2);
    const std::int64_t along = std::int64_t{1} << (random() % 2 ? longest : random() % longest);
    a = {-along * below(bits / 2 + 1), 0, r}, b = {along * below(bits / 2 + 1), 0, r}, c = {0, 0, r + below(bits)};
    p = {0, static_cast<std::int64_t>(random() % 3) - 1, 0};
  }
  std::array<std::size_t, 3> axes = {0, 1, 2};
  std::shuffle(axes.begin(), axes.end(), random);
  const int exponent = static_cast<int>(random() % 21) + (sizeof(Real) == 8 && random() % 4 == 0 ? 60 : -10);
  // A centre on the plane or on an edge remains there when the axes are scaled.
  std::array<int, 3> scale = {exponent, exponent, exponent};
  if (random() % 4 == 0) scale[random() % 3] -= static_cast<int>(random() % 60);
  const auto real = [&](const Vec3<std::int64_t>& v) {
    const std::array<std::int64_t, 3> own = {v.x, v.y, v.z};
    const auto one = [&](std::size_t k) { return std::ldexp(static_cast<Real>(own[axes[k]]), scale[k]); };
    return Vec3<Real>{one(0), one(1), one(2)};
  };
  std::array<Vec3<Real>, 3> v = {real(a), real(b), real(c)};
  std::rotate(v.begin(), v.begin() + random() % 3, v.end());
  Query<Real> q = {v[0], v[1], v[2], real(p), std::ldexp(static_cast<Real>(r), exponent)};
  // Some centres have no common unit with the other numbers in which all of them are small integers.
  if (random() % 4 == 0) q.p = q.p * std::ldexp(Real(1), -static_cast<int>(random() % 90));
  if (random() % 4 == 0) q.r = std::nextafter(q.r, std::numeric_limits<Real>::infinity());
  if (random() % 4 != 0) return q;
  // Multiples of the least number there is, in place of some zeros.
  auto all = coordinates(q);
  for (std::size_t k = 0; k < 12; ++k) {
    if (all[k] == 0 && random() % 2 == 0)
      all[k] = std::numeric_limits<Real>::denorm_min() * Real(random() % 2 ? 1 : -3);
  }
  return from_coordinates(all);
}

// The inverse of x modulo m, or 0 where there is none.
inline std::int64_t inverse(std::int64_t x, std::int64_t m) {
  std::int64_t a = x % m, b = m, u = 1, v = 0;
  while (b != 0) {
    const std::int64_t q = a / b;
    a = std::exchange(b, a - q * b);
    u = std::exchange(v, u - q * v);
  }
  return a == 1 ? (u % m + m) % m : 0;
}

// A centre as near to the plane of its triangle as a point of integers can be without lying on it, and a radius equal
// to that distance except for rounding, or close to it: far below the unit in which the other numbers are small
// integers.
template <class Real>
Query<Real> plane_query(std::mt19937_64& random) {
  const int bits = sizeof(Real) == 4 ? 20 : 28;
  const auto number = [&] { return static_cast<std::int64_t>(random() >> (64 - bits)) | 1; };
  for (;;) {
    // AB = (p, 0, s), AC = (0, q, t), V = (-s q, -t p, p q); x V = 1, above the triangle.
    const std::int64_t p = number(), q = number(), s = number(), t = number();
    const std::int64_t x = inverse(p - s % p * (q % p) % p, p), y = inverse(q - t % q * (p % q) % q, q);
    const double area =
        static_cast<double>(x) / static_cast<double>(p) + static_cast<double>(y) / static_cast<double>(q);
    if (x == 0 || y == 0 || area >= 1) continue;
    using certified::Int128;
    const Int128 V[3] = {-Int128{s} * q, -Int128{t} * p, Int128{p} * q};
    const auto z = static_cast<std::int64_t>((1 - V[0] * x - V[1] * y) / V[2]);
    const double normal = std::hypot(static_cast<double>(V[0]), static_cast<double>(V[1]), static_cast<double>(V[2]));
    const auto point = [](std::int64_t a, std::int64_t b, std::int64_t c) {
      return Vec3<Real>{static_cast<Real>(a), static_cast<Real>(b), static_cast<Real>(c)};
    };
    const auto r = static_cast<Real>(
        (1 + std::ldexp(static_cast<double>(random() % 5) - 2, -static_cast<int>(random() % 60))) / normal);
    return {point(0, 0, 0), point(p, 0, s), point(0, q, t), point(x, y, z), r};
  }
}

}  // namespace axiscert::testing_support

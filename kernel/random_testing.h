// Random queries for tests, and equality to the bit.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "kernel/sphere_triangle/query.h"

namespace axiscert::testing_support {

template <class Real>
using Bits = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;

// Equal to the bit, or both NaN. NaN payloads are not part of the contract: which operand's payload survives depends on
// the order of the operands.
template <class Real>
bool same(Real a, Real b) {
  return std::bit_cast<Bits<Real>>(a) == std::bit_cast<Bits<Real>>(b) || (a != a && b != b);
}

// Thirteen numbers in [-1, 1), or with arbitrary bits.
template <class Real>
Query<Real> random_query(std::mt19937_64& random, bool any_bits) {
  std::array<Real, coordinate_count> v;
  for (Real& x : v) {
    const auto bits = static_cast<Bits<Real>>(random());
    x = any_bits ? std::bit_cast<Real>(bits)
                 : static_cast<Real>(static_cast<std::int64_t>(random()) >> 11) * Real(0x1p-52);
  }
  return from_coordinates(v);
}

// Integers from -3 to 3 times 2^exponent, with repeated vertices and centres on vertices among them: ties are common.
template <class Real>
Query<Real> coarse_query(std::mt19937_64& random, int exponent) {
  std::array<Real, coordinate_count> v;
  for (Real& x : v) x = std::ldexp(static_cast<Real>(static_cast<int>(random() % 7) - 3), exponent);
  v[12] = std::abs(v[12]);
  Query<Real> q = from_coordinates(v);
  if (random() % 3 == 0) q.b = q.a;
  if (random() % 5 == 0) q.c = q.b;
  if (random() % 7 == 0) q.p = q.a;
  return q;
}

// Numbers of few bits, sometimes with one of another magnitude: ties, repeated and collinear vertices, and queries that
// reach each of the last steps.
template <class Real>
Query<Real> coarse_query_of_any_size(std::mt19937_64& random) {
  using Limits = std::numeric_limits<Real>;
  const int exponents[] = {0, -20, Limits::max_exponent - 4, Limits::min_exponent - Limits::digits + 1};
  const int exponent = exponents[random() % 4];
  auto v = coordinates(coarse_query<Real>(random, exponent));
  if (random() % 4 == 0) {
    const int another = exponents[random() % 4];
    v[random() % 13] = std::ldexp(Real(1), another);
  }
  return from_coordinates(v);
}

}  // namespace axiscert::testing_support

// Random queries of the kernel tests, and equality to the bit.
#pragma once

#include <bit>
#include <cstdint>
#include <random>

#include "kernel/query.h"

namespace axiscert::testing_support {

template <class Real>
using Bits = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;

// NaN payloads are not part of the contract: which operand's payload survives depends on operand order.
template <class Real>
bool same(Real a, Real b) {
  return std::bit_cast<Bits<Real>>(a) == std::bit_cast<Bits<Real>>(b) || (a != a && b != b);
}

// Thirteen numbers in [-1, 1), or of any bits.
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

}  // namespace axiscert::testing_support

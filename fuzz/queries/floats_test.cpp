// A product by a power of two is std::ldexp, bit by bit.
#include "fuzz/queries/floats.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <type_traits>

namespace axiscert {
namespace {

template <class Real>
using Bits = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;

template <class Real>
class PowersOfTwo : public testing::Test {};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(PowersOfTwo, Reals);

// Also where the product overflows, is subnormal or is rounded to zero, and where the power itself is not a normal
// number.
TYPED_TEST(PowersOfTwo, ScaleAsLdexpDoes) {
  using Real = TypeParam;
  using Limits = std::numeric_limits<Real>;
  std::mt19937_64 random(1);
  const int most = Limits::max_exponent - Limits::min_exponent + Limits::digits + 8;
  for (int exponent = -most; exponent <= most; ++exponent) {
    std::array<Real, 19> x = {Real(0),       -Real(0),      Limits::denorm_min(),
                              Limits::min(), Limits::max(), Limits::infinity()};
    for (std::size_t i = 6; i < x.size(); ++i) {
      const auto significand = static_cast<Real>(random() >> (64 - Limits::digits));
      x[i] = std::ldexp(
          i % 2 == 0 ? significand : -significand,
          static_cast<int>(random() % static_cast<unsigned>(2 * Limits::max_exponent)) - Limits::max_exponent);
    }
    std::array<Real, 19> scaled = x;
    scale_by_power_of_two(scaled, exponent);
    for (std::size_t i = 0; i < x.size(); ++i) {
      EXPECT_EQ(std::bit_cast<Bits<Real>>(scaled[i]), std::bit_cast<Bits<Real>>(std::ldexp(x[i], exponent)))
          << x[i] << " times 2^" << exponent;
    }
  }
}

}  // namespace
}  // namespace axiscert

// The thirteen numbers of a query as integers, in units of a power of two that divides them all.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "exact/sphere_triangle/oracles/gram.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {

// The stored bits of a number without its sign; they are ordered by magnitude.
template <class Real>
using Magnitude = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;
template <class Real>
AXISCERT_WORDS_INLINE inline Magnitude<Real> magnitude(Real x) {
  return std::bit_cast<Magnitude<Real>>(x) & (~Magnitude<Real>{0} >> 1);
}

// The exponent of a magnitude's last place, 2^exponent, and the magnitude as a multiple of that place.
template <class Real>
AXISCERT_WORDS_INLINE inline int unit_exponent(Magnitude<Real> magnitude) {
  using Limits = std::numeric_limits<Real>;
  return std::max(static_cast<int>(magnitude >> (Limits::digits - 1)), 1) + (Limits::min_exponent - Limits::digits - 1);
}
template <class Real>
AXISCERT_WORDS_INLINE inline Magnitude<Real> significand(Magnitude<Real> magnitude) {
  constexpr Magnitude<Real> hidden = Magnitude<Real>{1} << (std::numeric_limits<Real>::digits - 1);
  return magnitude < hidden ? magnitude : ((magnitude & (hidden - 1)) | hidden);
}

// The exponent of the least bit that is set in any of the numbers; 0 where all are zero.
template <class Real>
int least_set_bit(const std::array<Real, coordinate_count>& numbers) {
  constexpr int none = std::numeric_limits<Real>::max_exponent;
  int least = none;
  for (const Real x : numbers) {
    const Magnitude<Real> stored = magnitude(x);
    if (stored == 0) continue;
    least = std::min(least, unit_exponent<Real>(stored) + std::countr_zero(significand<Real>(stored)));
  }
  return least == none ? 0 : least;
}

// The bits of integers that hold any query of a precision: its numbers are multiples of the least one, below
// 2^max_exponent, and their differences are below twice that.
template <class Real>
constexpr int most_bits = std::numeric_limits<Real>::max_exponent + 1 -
                          (std::numeric_limits<Real>::min_exponent - std::numeric_limits<Real>::digits);
template <class Real>
using AnyGrid = UpToWords<(most_bits<Real> + 63) / 64>;
static_assert(fits_in_words(most_bits<float>, 10) && fits_in_words(most_bits<double>, 66));

template <class Real>
typename AnyGrid<Real>::GivenInteger any_integer(Real x, int unit) {
  const Magnitude<Real> stored = magnitude(x);
  if (stored == 0) return typename AnyGrid<Real>::GivenInteger();
  const Magnitude<Real> bits = significand<Real>(stored);
  const int zeros = std::countr_zero(bits);
  const auto odd = static_cast<std::int64_t>(bits >> zeros);
  return AnyGrid<Real>::GivenInteger::shifted(x < 0 ? -odd : odd,
                                              static_cast<unsigned>(unit_exponent<Real>(stored) + zeros - unit));
}

// A valid query in units of the least bit that is set in it, 2^unit.
template <class Real>
struct OnAnyGrid {
  CentredNumbers<typename AnyGrid<Real>::GivenInteger> centred;
  int unit;
};
template <class Real>
OnAnyGrid<Real> on_any_grid(const Query<Real>& q) {
  using Integer = typename AnyGrid<Real>::GivenInteger;
  const auto numbers = coordinates(q);
  const int unit = least_set_bit(numbers);
  const std::array<Integer, 3> p = {any_integer(numbers[9], unit), any_integer(numbers[10], unit),
                                    any_integer(numbers[11], unit)};
  OnAnyGrid<Real> result{{}, unit};
  for (std::size_t i = 0; i < 9; ++i) result.centred[i] = any_integer(numbers[i], unit) - p[i % 3];
  result.centred[9] = any_integer(numbers[12], unit);
  return result;
}

}  // namespace axiscert

// Ball arithmetic: a midpoint and a bound of its error, with any exponent. It uses integers, so that every rounding is
// counted and no floating-point mode matters.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "kernel/sphere_triangle/certified/integer.h"

namespace axiscert::certified {

// A number between (middle - error) 2^exponent and (middle + error) 2^exponent; |middle|, error <= 2^62 + 1. It is
// exact while it needs at most 62 bits.
struct Ball {
  std::int64_t middle = 0, error = 0;
  int exponent = 0;

  Ball() = default;
  explicit Ball(const Dyadic& x) noexcept
      : middle(x.negative ? -static_cast<std::int64_t>(x.significand) : static_cast<std::int64_t>(x.significand)),
        exponent(x.exponent) {}

  // True only if certain.
  bool is_positive() const noexcept { return middle > error; }
  bool is_negative() const noexcept { return middle < -error; }
  bool is_at_least_zero() const noexcept { return middle >= error; }
  bool is_at_most_zero() const noexcept { return middle <= -error; }

  friend Ball operator-(const Ball& x) noexcept { return Ball(-x.middle, x.error, x.exponent); }
  friend Ball operator+(const Ball& x, const Ball& y) noexcept {
    if (x.is_zero()) return y;
    if (y.is_zero()) return x;
    return x.exponent >= y.exponent ? sum(x, y) : sum(y, x);
  }
  friend Ball operator-(const Ball& x, const Ball& y) noexcept { return x + -y; }
  // |x y - x.middle y.middle| <= |x.middle| y.error + x.error |y.middle| + x.error y.error < 2^126.
  friend Ball operator*(const Ball& x, const Ball& y) noexcept {
    const auto magnitude = [](std::int64_t m) { return Int128{m < 0 ? -m : m}; };
    return rounded(Int128{x.middle} * y.middle,
                   magnitude(x.middle) * y.error + Int128{x.error} * (magnitude(y.middle) + y.error),
                   x.exponent + y.exponent);
  }

 private:
  static constexpr int bits = 62;

  Ball(std::int64_t m, std::int64_t k, int e) noexcept : middle(m), error(k), exponent(e) {}
  bool is_zero() const noexcept { return middle == 0 && error == 0; }

  static int width(UInt128 x) noexcept {
    const auto high = static_cast<std::uint64_t>(x >> 64), low = static_cast<std::uint64_t>(x);
    return high != 0 ? 64 + static_cast<int>(std::bit_width(high)) : static_cast<int>(std::bit_width(low));
  }
  static int width(Int128 m, Int128 k) noexcept {
    return width(static_cast<UInt128>(m < 0 ? -m : m) | static_cast<UInt128>(k));
  }

  // x has the greater exponent.
  static Ball sum(const Ball& x, const Ball& y) noexcept {
    const int free = std::max(0, bits - width(x.middle, x.error)), apart = x.exponent - y.exponent;
    if (apart <= bits + free) {
      const Int128 unit = Int128{1} << apart;
      return rounded(x.middle * unit + y.middle, x.error * unit + y.error, y.exponent);
    }
    // |y| <= (2^63 + 2) 2^y.exponent < 2 2^(x.exponent - free).
    const Int128 unit = Int128{1} << free;
    return rounded(x.middle * unit, x.error * unit + 2, x.exponent - free);
  }
  // Rounds to `bits` bits, the middle downwards; the loss is added to the error.
  static Ball rounded(Int128 m, Int128 k, int exponent) noexcept {
    const int down = width(m, k) - bits;
    if (down <= 0) return {static_cast<std::int64_t>(m), static_cast<std::int64_t>(k), exponent};
    const Int128 lost = (Int128{1} << down) - 1;
    return {static_cast<std::int64_t>(m >> down),
            static_cast<std::int64_t>(k >> down) + ((m & lost) != 0) + ((k & lost) != 0), exponent + down};
  }
};

template <class>
Ball product(const Ball& x, const Ball& y) noexcept {
  return x * y;
}

}  // namespace axiscert::certified

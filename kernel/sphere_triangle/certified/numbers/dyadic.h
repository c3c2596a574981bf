// A double split into significand and exponent.
#pragma once

#include <bit>
#include <cstdint>

namespace axiscert::certified {

// A finite double as significand 2^exponent; the last `zeros` bits of the significand are zero.
struct Dyadic {
  std::uint64_t significand;
  int exponent, zeros;
  bool negative;

  explicit Dyadic(double x) noexcept {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const int stored = static_cast<int>((bits >> 52) & 0x7ff), is_normal = stored != 0;
    significand = (bits & ((std::uint64_t{1} << 52) - 1)) | (static_cast<std::uint64_t>(is_normal) << 52);
    exponent = stored - is_normal - 1074;
    zeros = std::countr_zero(significand | (std::uint64_t{1} << 63));
    negative = (bits >> 63) != 0;
  }
  int top() const noexcept { return exponent + static_cast<int>(std::bit_width(significand)); }
};

}  // namespace axiscert::certified

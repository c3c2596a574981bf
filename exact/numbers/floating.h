// A floating-point number of any precision up to 4096 bits, chosen at run time for the duration of a scope.
#pragma once

#include <mpfr.h>

#include <cfenv>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>

#include "kernel/base/enums.h"
#include "kernel/base/environment.h"
#include "kernel/names.h"

namespace axiscert {
// What a result beyond the greatest number becomes; an infinite one of finite operands, as 1/0, too. Where the rounding
// is toward zero it is the greatest number all the same, as IEEE 754 has it.
enum class Overflow : std::uint8_t { infinity, nan, greatest };
template <>
inline constexpr std::size_t enum_count<Overflow> = 3;
inline constexpr EnumArray<Overflow, std::string_view> overflow_names = {"infinity", "nan", "greatest"};
constexpr std::string_view name(Overflow overflow) { return overflow_names[overflow]; }

// Exponents e of the normal numbers m 2^e, 1 <= m < 2; below them underflow is gradual.
struct ExponentLimits {
  long least, greatest;
  Overflow overflow = Overflow::infinity;
  bool ones_are_nan = false;  // the significand of ones with the greatest exponent is no number, as in E4M3

  constexpr ExponentLimits(long e_min, long e_max) : least(e_min), greatest(e_max) {}
  constexpr ExponentLimits(Precision precision)
      : ExponentLimits(precision == Precision::binary32 ? -126 : -1022, precision == Precision::binary32 ? 127 : 1023) {
  }
  bool operator==(const ExponentLimits&) const = default;
};

// Whether a choice between the two neighbours of an inexact result is left to chance.
enum class Chance : std::uint8_t {
  none,        // the rounding says
  faithful,    // either, by a coin
  stochastic,  // either, with a probability proportional to the distance of the other: the mean is the exact result
};

// The rounding of the operations in a scope: to `precision` bits, with the exponent range of a format or an unbounded
// one.
struct FloatingFormat {
  int precision = 53;
  Rounding rounding = Rounding::nearest;
  std::optional<ExponentLimits> exponents;  // empty: unbounded (2^62 at least)
  Chance chance = Chance::none;             // other than none: instead of `rounding`
  std::uint64_t seed = 0;                   // of chance: a scope begins its numbers again
};

// Sets the format of this thread's Floating operations and restores the previous one at the end of the scope.
class FloatingScope {
 public:
  explicit FloatingScope(const FloatingFormat& format);
  ~FloatingScope();
  FloatingScope(const FloatingScope&) = delete;
  FloatingScope& operator=(const FloatingScope&) = delete;

  static constexpr int greatest_precision = 4096;

 private:
  FloatingFormat before_;
};

// Every operation rounds its exact result once, to the format in force. A number made from a double equals that double:
// it is not rounded, whatever the format; in_format() is for that. The limbs are stored in the object: no allocation.
class Floating {
 public:
  Floating() : Floating(0.0) {}
  explicit Floating(double x) {
    prepare(std::numeric_limits<double>::digits);
    mpfr_set_d(value_, x, MPFR_RNDN);
  }
  Floating(const Floating& other) {
    prepare(mpfr_get_prec(other.value_));
    mpfr_set(value_, other.value_, MPFR_RNDN);
  }
  Floating& operator=(const Floating& other) {
    prepare(mpfr_get_prec(other.value_));
    mpfr_set(value_, other.value_, MPFR_RNDN);
    return *this;
  }
  mpfr_srcptr get() const { return value_; }

  Floating operator-() const;
  friend Floating operator+(const Floating& a, const Floating& b);
  friend Floating operator-(const Floating& a, const Floating& b);
  friend Floating operator*(const Floating& a, const Floating& b);
  friend Floating operator/(const Floating& a, const Floating& b);
  friend Floating fused(const Floating& a, const Floating& b, const Floating& c);  // a b + c
  friend Floating square_root(const Floating& a);
  friend Floating magnitude(const Floating& a);
  friend Floating in_format(const Floating& a);
  // Every comparison with a NaN is false.
  friend bool operator>(const Floating& a, const Floating& b) { return mpfr_greater_p(a.value_, b.value_) != 0; }
  friend bool operator>=(const Floating& a, const Floating& b) { return mpfr_greaterequal_p(a.value_, b.value_) != 0; }

 private:
  struct Uninitialised {};
  explicit Floating(Uninitialised);
  // One between the two neighbours, with exact probabilities.
  template <class Operation, class... Operands>
  static Floating by_chance(Operation operation, const Operands&... operands);
  void prepare(mpfr_prec_t precision) {
    mpfr_custom_init(limbs_, precision);
    mpfr_custom_init_set(value_, MPFR_ZERO_KIND, 0, precision, limbs_);
  }
  template <class Operation, class... Operands>
  static Floating rounded(Operation operation, const Operands&... operands);

  mp_limb_t limbs_[FloatingScope::greatest_precision / GMP_NUMB_BITS];
  mpfr_t value_;
};

Floating fused(const Floating& a, const Floating& b, const Floating& c);
Floating square_root(const Floating& a);
Floating magnitude(const Floating& a);
// The number that the format in force has for this one.
Floating in_format(const Floating& a);

// Whether an evaluation stays in its format's range.

struct BitsInRange {
  ComparisonBits bits;
  // No operation that the bits depend on overflowed, underflowed or was invalid: every result was rounded in the normal
  // range or exact, so that the same operations with an unbounded exponent have the same bits.
  bool stayed;
};

// The processor's flags tell. `evaluate` has to read its operands from memory that others can reach, which keeps its
// operations between the two barriers.
template <class Evaluate>
BitsInRange bits_in_range(Evaluate&& evaluate) {
  constexpr int events = FE_OVERFLOW | FE_UNDERFLOW | FE_DIVBYZERO | FE_INVALID;
  std::feclearexcept(events);
  asm volatile("" ::: "memory");
  ComparisonBits bits = evaluate();
  asm volatile("" : "+r"(bits)::"memory");
  return {bits, std::fetestexcept(events) == 0};
}

}  // namespace axiscert

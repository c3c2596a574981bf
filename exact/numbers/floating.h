// A floating-point number of any precision up to 256 bits, chosen at run time for the duration of a scope.
#pragma once

#include <mpfr.h>

#include <cfenv>
#include <limits>
#include <optional>

#include "kernel/base/environment.h"
#include "kernel/names.h"

namespace axiscert {
// The rounding of the operations in a scope: to `precision` bits, with the exponent range of a format or an unbounded
// one.
struct FloatingFormat {
  int precision = 53;
  Rounding rounding = Rounding::nearest;
  // The exponents of binary32 or binary64, gradual underflow included; empty: unbounded (2^62 at least).
  std::optional<Precision> exponents;
};

// Sets the format of this thread's Floating operations and restores the previous one at the end of the scope.
class FloatingScope {
 public:
  explicit FloatingScope(const FloatingFormat& format);
  ~FloatingScope();
  FloatingScope(const FloatingScope&) = delete;
  FloatingScope& operator=(const FloatingScope&) = delete;

  static constexpr int greatest_precision = 256;

 private:
  FloatingFormat before_;
};

// Every operation rounds its exact result once, to the format in force. A number made from a double equals that double:
// it is not rounded, whatever the format. The limbs are stored in the object: no allocation.
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
  // Every comparison with a NaN is false.
  friend bool operator>(const Floating& a, const Floating& b) { return mpfr_greater_p(a.value_, b.value_) != 0; }
  friend bool operator>=(const Floating& a, const Floating& b) { return mpfr_greaterequal_p(a.value_, b.value_) != 0; }

 private:
  struct Uninitialised {};
  explicit Floating(Uninitialised);
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

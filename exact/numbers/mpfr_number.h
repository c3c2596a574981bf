// MPFR as a number type of the formulae: `Bits` bits of significand, an unbounded exponent, rounding to nearest even.
#pragma once

#include <mpfr.h>

namespace axiscert {

// The limbs are stored in the object: no allocation. MPFR's default exponent range (2^30) is far beyond the magnitude
// of any product of twelve binary64 numbers, so no operation here over- or underflows; mpfr_inexflag_p tells whether
// any operation rounded.
template <int Bits>
class Mpfr {
 public:
  Mpfr() {
    mpfr_custom_init(limbs_, Bits);
    mpfr_custom_init_set(value_, MPFR_ZERO_KIND, 0, Bits, limbs_);
  }
  explicit Mpfr(double x) : Mpfr() { mpfr_set_d(value_, x, MPFR_RNDN); }
  template <int Others>  // rounds if Bits is less than Others
  explicit Mpfr(const Mpfr<Others>& other) : Mpfr() {
    mpfr_set(value_, other.get(), MPFR_RNDN);
  }
  Mpfr(const Mpfr& other) : Mpfr() { mpfr_set(value_, other.value_, MPFR_RNDN); }
  Mpfr& operator=(const Mpfr& other) {
    mpfr_set(value_, other.value_, MPFR_RNDN);
    return *this;
  }
  static Mpfr of(mpz_srcptr x) {  // rounds if x has more bits
    Mpfr result;
    mpfr_set_z(result.value_, x, MPFR_RNDN);
    return result;
  }
  mpfr_srcptr get() const { return value_; }

  friend Mpfr operator+(const Mpfr& a, const Mpfr& b) { return apply(mpfr_add, a, b); }
  friend Mpfr operator-(const Mpfr& a, const Mpfr& b) { return apply(mpfr_sub, a, b); }
  friend Mpfr operator*(const Mpfr& a, const Mpfr& b) { return apply(mpfr_mul, a, b); }
  friend Mpfr operator/(const Mpfr& a, const Mpfr& b) { return apply(mpfr_div, a, b); }
  friend Mpfr square_root(const Mpfr& a) {
    Mpfr result;
    mpfr_sqrt(result.value_, a.value_, MPFR_RNDN);
    return result;
  }
  friend Mpfr magnitude(const Mpfr& a) {
    Mpfr result;
    mpfr_abs(result.value_, a.value_, MPFR_RNDN);
    return result;
  }
  friend bool operator>(const Mpfr& a, const Mpfr& b) { return mpfr_greater_p(a.value_, b.value_) != 0; }
  friend bool operator>=(const Mpfr& a, const Mpfr& b) { return mpfr_greaterequal_p(a.value_, b.value_) != 0; }
  // -1, 0 or 1 as a is less than, equal to or greater than b.
  friend int order(const Mpfr& a, const Mpfr& b) {
    const int c = mpfr_cmp(a.value_, b.value_);
    return (c > 0) - (c < 0);
  }

 private:
  using Operation = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t);
  static Mpfr apply(Operation operation, const Mpfr& a, const Mpfr& b) {
    Mpfr result;
    operation(result.value_, a.value_, b.value_, MPFR_RNDN);
    return result;
  }

  mp_limb_t limbs_[(Bits + GMP_NUMB_BITS - 1) / GMP_NUMB_BITS];
  mpfr_t value_;
};

}  // namespace axiscert

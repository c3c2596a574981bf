#include "exact/numbers/floating.h"

namespace axiscert {
namespace {

thread_local FloatingFormat format;
thread_local mpfr_rnd_t rounding = MPFR_RNDN;

// MPFR's exponent range belongs to the thread as well. Outside `limit` it is the widest possible, so that a number made
// from a double equals that double even if it lies outside the format's range.
void set_widest_exponents() {
  mpfr_set_emin(mpfr_get_emin_min());
  mpfr_set_emax(mpfr_get_emax_max());
}

void put_in_force(const FloatingFormat& wanted) {
  constexpr EnumArray<Rounding, mpfr_rnd_t> modes = {MPFR_RNDN, MPFR_RNDU, MPFR_RNDD, MPFR_RNDZ};
  format = wanted;
  rounding = modes[wanted.rounding];
  set_widest_exponents();
}

// Brings a result with unbounded exponent into the format's range: overflow, and gradual underflow without a second
// rounding. For the latter MPFR needs to know on which side of the exact result this one lies (`ternary`). MPFR's
// significands lie in [1/2, 1): exponents are one greater than IEEE's.
void limit(mpfr_ptr value, int ternary) {
  const bool single = *format.exponents == Precision::binary32;
  const mpfr_exp_t least_normal = single ? -125 : -1021, greatest = single ? 128 : 1024;
  if (!mpfr_regular_p(value)) return;
  const mpfr_exp_t exponent = mpfr_get_exp(value);
  if (exponent >= least_normal && exponent <= greatest) return;
  mpfr_set_emin(least_normal - format.precision + 1);  // exponent of the least subnormal number
  mpfr_set_emax(greatest);
  ternary = mpfr_check_range(value, ternary, rounding);
  mpfr_subnormalize(value, ternary, rounding);
  if (exponent < least_normal) mpfr_set_underflow();
  set_widest_exponents();
}

}  // namespace

FloatingScope::FloatingScope(const FloatingFormat& wanted) : before_(format) { put_in_force(wanted); }
FloatingScope::~FloatingScope() { put_in_force(before_); }

Floating::Floating(Uninitialised) { prepare(format.precision); }

template <class Operation, class... Operands>
Floating Floating::rounded(Operation operation, const Operands&... operands) {
  Floating result{Uninitialised()};
  const int ternary = operation(result.value_, operands.value_..., rounding);
  if (format.exponents) limit(result.value_, ternary);
  return result;
}

Floating Floating::operator-() const { return rounded(mpfr_neg, *this); }
Floating operator+(const Floating& a, const Floating& b) { return Floating::rounded(mpfr_add, a, b); }
Floating operator-(const Floating& a, const Floating& b) { return Floating::rounded(mpfr_sub, a, b); }
Floating operator*(const Floating& a, const Floating& b) { return Floating::rounded(mpfr_mul, a, b); }
Floating operator/(const Floating& a, const Floating& b) { return Floating::rounded(mpfr_div, a, b); }
Floating fused(const Floating& a, const Floating& b, const Floating& c) { return Floating::rounded(mpfr_fma, a, b, c); }
Floating square_root(const Floating& a) { return Floating::rounded(mpfr_sqrt, a); }
Floating magnitude(const Floating& a) {
  return Floating::rounded([](mpfr_ptr to, mpfr_srcptr x, mpfr_rnd_t mode) { return mpfr_abs(to, x, mode); }, a);
}

}  // namespace axiscert

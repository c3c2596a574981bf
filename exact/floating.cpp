#include "exact/floating.h"

namespace axiscert {
namespace {

thread_local FloatingFormat format;
thread_local mpfr_rnd_t rounding = MPFR_RNDN;

// MPFR's own exponent range belongs to the thread as well. Its significands lie in [1/2, 1): exponents are one more
// than IEEE's. The least exponent is that of the least subnormal number of `precision` bits.
void put_in_force(const FloatingFormat& wanted) {
  constexpr mpfr_rnd_t modes[] = {MPFR_RNDN, MPFR_RNDU, MPFR_RNDD, MPFR_RNDZ};
  format = wanted;
  rounding = modes[static_cast<std::size_t>(wanted.rounding)];
  if (!wanted.exponents) {
    mpfr_set_emin(mpfr_get_emin_min());
    mpfr_set_emax(mpfr_get_emax_max());
    return;
  }
  const bool single = *wanted.exponents == Precision::binary32;
  mpfr_set_emin((single ? -124 : -1020) - wanted.precision);
  mpfr_set_emax(single ? 128 : 1024);
}

}  // namespace

FloatingScope::FloatingScope(const FloatingFormat& wanted) : before_(format) { put_in_force(wanted); }
FloatingScope::~FloatingScope() { put_in_force(before_); }

Floating::Floating(Uninitialised) { prepare(format.precision); }

template <class Operation, class... Operands>
Floating Floating::rounded(Operation operation, const Operands&... operands) {
  Floating result{Uninitialised()};
  const int ternary = operation(result.value_, operands.value_..., rounding);
  if (format.exponents) mpfr_subnormalize(result.value_, ternary, rounding);
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

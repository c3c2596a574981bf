#include "exact/numbers/floating.h"

#include "kernel/base/split_mix.h"

namespace axiscert {
namespace {

thread_local FloatingFormat format;
thread_local mpfr_rnd_t rounding = MPFR_RNDN;
thread_local std::uint64_t chance_state = 0;

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
  chance_state = wanted.seed;
  set_widest_exponents();
}

// A number of the caller's own precision.
class WideNumber {
 public:
  explicit WideNumber(mpfr_prec_t precision) { mpfr_init2(value_, precision); }
  ~WideNumber() { mpfr_clear(value_); }
  WideNumber(const WideNumber&) = delete;
  WideNumber& operator=(const WideNumber&) = delete;
  mpfr_ptr get() { return value_; }

 private:
  mpfr_t value_;
};

// The exponent e of m 2^e, 1 <= m < 2; MPFR's significands lie in [1/2, 1).
mpfr_exp_t exponent_of(mpfr_srcptr value) { return mpfr_get_exp(value) - 1; }

// The greatest number of the format, with the sign of `value`.
void set_greatest(mpfr_ptr value, const ExponentLimits& limits) {
  const int sign = mpfr_signbit(value);
  mpfr_set_ui_2exp(value, 1, limits.greatest + 1, MPFR_RNDN);
  mpfr_nextbelow(value);
  if (limits.ones_are_nan) mpfr_nextbelow(value);
  mpfr_setsign(value, value, sign, MPFR_RNDN);
}

// `toward_zero`: the rounding of this result is.
void overflow(mpfr_ptr value, const ExponentLimits& limits, bool toward_zero) {
  const int sign = mpfr_signbit(value);
  if (toward_zero || limits.overflow == Overflow::greatest) set_greatest(value, limits);
  else if (limits.overflow == Overflow::infinity) mpfr_set_inf(value, sign != 0 ? -1 : 1);
  else mpfr_set_nan(value);
  mpfr_set_overflow();
}

// Whether a value of at most the format's bits is beyond its greatest number.
bool is_beyond(mpfr_srcptr value, const ExponentLimits& limits) {
  const mpfr_exp_t exponent = exponent_of(value);
  if (exponent != limits.greatest || !limits.ones_are_nan) return exponent > limits.greatest;
  WideNumber greatest(format.precision);
  set_greatest(greatest.get(), limits);
  return mpfr_cmpabs(value, greatest.get()) > 0;
}

// Brings a result with unbounded exponent into the format's range: overflow, and gradual underflow without a second
// rounding. For the latter MPFR needs to know on which side of the exact result this one lies (`ternary`).
void limit(mpfr_ptr value, int ternary) {
  const ExponentLimits& limits = *format.exponents;
  if (mpfr_inf_p(value) != 0 && limits.overflow != Overflow::infinity) return overflow(value, limits, false);
  if (mpfr_regular_p(value) == 0) return;
  if (is_beyond(value, limits)) {
    const bool negative = mpfr_signbit(value) != 0;
    return overflow(value, limits, rounding == MPFR_RNDZ || rounding == (negative ? MPFR_RNDU : MPFR_RNDD));
  }
  if (exponent_of(value) >= limits.least) return;
  mpfr_set_emin(limits.least + 1 - format.precision + 1);  // MPFR's exponent of the least subnormal number
  ternary = mpfr_check_range(value, ternary, rounding);
  mpfr_subnormalize(value, ternary, rounding);
  mpfr_set_underflow();
  set_widest_exponents();
}

// Takes the next 64 bits off a fraction in [0, 1).
std::uint64_t next_word(mpfr_ptr fraction) {
  mpfr_mul_2ui(fraction, fraction, 64, MPFR_RNDZ);
  const std::uint64_t word = mpfr_get_ui(fraction, MPFR_RNDZ);
  mpfr_frac(fraction, fraction, MPFR_RNDZ);
  return word;
}

}  // namespace

FloatingScope::FloatingScope(const FloatingFormat& wanted) : before_(format) { put_in_force(wanted); }
FloatingScope::~FloatingScope() { put_in_force(before_); }

Floating::Floating(Uninitialised) { prepare(format.precision); }

// The exact result is n + f units of the format's last place at its size, 0 <= f < 1 with the sign apart. It becomes
// n + 1 units where U < f, of U uniform in [0, 1): both are compared word by word, and a result that is truncated to
// more bits has the next word of f right. 64 bits decide all but one in 2^64.
template <class Operation, class... Operands>
Floating Floating::by_chance(Operation operation, const Operands&... operands) {
  Floating result{Uninitialised()};
  std::uint64_t drawn[64];  // words of U
  for (int words = 1; words <= 64; ++words) {
    WideNumber wide(format.precision + 64 * words);
    const int ternary = operation(wide.get(), operands.value_..., MPFR_RNDZ);
    if (mpfr_regular_p(wide.get()) == 0) {
      mpfr_set(result.value_, wide.get(), MPFR_RNDN);
      break;
    }
    mpfr_exp_t size = exponent_of(wide.get());
    const bool is_small = format.exponents && size < format.exponents->least;
    if (is_small) size = format.exponents->least;
    const mpfr_exp_t unit = size - format.precision + 1;
    mpfr_mul_2si(wide.get(), wide.get(), -unit, MPFR_RNDZ);
    const bool negative = mpfr_signbit(wide.get()) != 0;
    mpfr_trunc(result.value_, wide.get());  // at most `precision` bits: exact
    mpfr_frac(wide.get(), wide.get(), MPFR_RNDZ);
    mpfr_abs(wide.get(), wide.get(), MPFR_RNDZ);
    const bool is_exact = ternary == 0 && mpfr_zero_p(wide.get()) != 0;
    bool is_away = false;
    bool is_decided = is_exact;
    for (int i = 0; i < words && !is_decided; ++i) {
      if (i == words - 1) drawn[i] = split_mix(chance_state);
      const std::uint64_t word = next_word(wide.get());
      is_decided = word != drawn[i];
      is_away = drawn[i] < word;
    }
    if (!is_decided && (ternary != 0 || mpfr_zero_p(wide.get()) == 0) && words < 64) continue;
    if (is_away) (negative ? mpfr_sub_ui : mpfr_add_ui)(result.value_, result.value_, 1, MPFR_RNDN);
    mpfr_mul_2si(result.value_, result.value_, unit, MPFR_RNDN);
    if (mpfr_zero_p(result.value_) != 0) mpfr_setsign(result.value_, result.value_, negative ? 1 : 0, MPFR_RNDN);
    if (is_small) mpfr_set_underflow();
    break;
  }
  if (!format.exponents) return result;
  const bool is_infinite = mpfr_inf_p(result.value_) != 0 && format.exponents->overflow != Overflow::infinity;
  if (is_infinite || (mpfr_regular_p(result.value_) != 0 && is_beyond(result.value_, *format.exponents)))
    overflow(result.value_, *format.exponents, false);
  return result;
}

template <class Operation, class... Operands>
Floating Floating::rounded(Operation operation, const Operands&... operands) {
  if (format.chance == Chance::stochastic) return by_chance(operation, operands...);
  if (format.chance == Chance::faithful) rounding = split_mix(chance_state) >> 63 != 0 ? MPFR_RNDU : MPFR_RNDD;
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
Floating in_format(const Floating& a) {
  return Floating::rounded([](mpfr_ptr to, mpfr_srcptr x, mpfr_rnd_t mode) { return mpfr_set(to, x, mode); }, a);
}

}  // namespace axiscert

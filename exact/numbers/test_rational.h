// For tests: operations that GMP's rationals lack.
#pragma once

#include "exact/numbers/rational.h"

namespace axiscert::testing_support {

inline Rational times_power(const Rational& x, int exponent) {
  Rational result;
  if (exponent >= 0) mpq_mul_2exp(result.get_mpq_t(), x.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
  else mpq_div_2exp(result.get_mpq_t(), x.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
  return result;
}

}  // namespace axiscert::testing_support

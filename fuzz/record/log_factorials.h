// Logarithms of factorials to more digits than a probability needs.
#pragma once

#include <mpfr.h>

#include <algorithm>
#include <cstdint>

namespace axiscert {

// The exponential of a sum of log(n!), to 192 bits. For n < 2^64 such a logarithm is below 2^70, so nine of them and
// their sum together have an error below 10 * 2^(70 - 192) < 2^-118 in the logarithm.
class LogFactorials {
 public:
  LogFactorials() { mpfr_inits2(192, sum_, term_, nullptr); }
  LogFactorials(const LogFactorials&) = delete;
  ~LogFactorials() { mpfr_clears(sum_, term_, nullptr); }

  void start() { mpfr_set_zero(sum_, 1); }
  void add(std::uint64_t n, int sign) {
    mpfr_set_uj(term_, n, MPFR_RNDN);
    mpfr_add_ui(term_, term_, 1, MPFR_RNDN);
    mpfr_lngamma(term_, term_, MPFR_RNDN);
    if (sign > 0) mpfr_add(sum_, sum_, term_, MPFR_RNDN);
    else mpfr_sub(sum_, sum_, term_, MPFR_RNDN);
  }
  // The factor 2^-n.
  void halve(std::uint64_t n) {
    mpfr_const_log2(term_, MPFR_RNDN);
    mpfr_mul_ui(term_, term_, n, MPFR_RNDN);
    mpfr_sub(sum_, sum_, term_, MPFR_RNDN);
  }
  // exp of the sum, rounded up; at least 2^-1000, so that smaller terms, each wrong by up to 2^-1075 by underflow, are
  // together below 2^-53 of it.
  double exp() {
    mpfr_exp(term_, sum_, MPFR_RNDU);
    return std::max(mpfr_get_d(term_, MPFR_RNDU), 0x1p-1000);
  }

 private:
  mpfr_t sum_, term_;
};

}  // namespace axiscert

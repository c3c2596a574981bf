// A number for formulae in exact arithmetic: what finite floats become by +, -, * and /. C++17, with libgmp.
//
// A product or sum of floats has finitely many binary digits, and is kept as an integer times a power of two. A
// division adds a denominator, which is not cancelled: formulae compare few quotients.
#pragma once

#include <gmpxx.h>

#include <cmath>
#include <stdexcept>
#include <utility>

namespace axiscert::formulae {

// Thrown by a division by zero: over the reals the formula says nothing there.
struct Undefined : std::domain_error {
  Undefined() : std::domain_error("division by zero") {}
};

class Exact {
 public:
  Exact() = default;  // zero
  Exact(int whole) : top_(whole) { tidy(); }
  // `x` is finite.
  Exact(double x) {
    int exponent = 0;
    top_ = std::ldexp(std::frexp(x, &exponent), digits);  // an integer
    exponent_ = exponent - digits;
    tidy();
  }

  friend Exact operator+(const Exact& x, const Exact& y) { return sum(x, y, false); }
  friend Exact operator-(const Exact& x, const Exact& y) { return sum(x, y, true); }
  friend Exact operator*(const Exact& x, const Exact& y) {
    return Exact(x.top_ * y.top_, x.bottom_ * y.bottom_, x.exponent_ + y.exponent_);
  }
  friend Exact operator/(const Exact& x, const Exact& y) {
    if (y.top_ == 0) throw Undefined();
    mpz_class top = x.top_ * y.bottom_, bottom = x.bottom_ * y.top_;
    if (bottom < 0) {
      top = -top;
      bottom = -bottom;
    }
    return Exact(std::move(top), std::move(bottom), x.exponent_ - y.exponent_);
  }
  Exact operator-() const { return Exact(-top_, bottom_, exponent_); }
  Exact& operator+=(const Exact& y) { return *this = *this + y; }
  Exact& operator-=(const Exact& y) { return *this = *this - y; }
  Exact& operator*=(const Exact& y) { return *this = *this * y; }
  Exact& operator/=(const Exact& y) { return *this = *this / y; }

  friend bool operator<(const Exact& x, const Exact& y) { return order(x, y) < 0; }
  friend bool operator>(const Exact& x, const Exact& y) { return order(x, y) > 0; }
  friend bool operator<=(const Exact& x, const Exact& y) { return order(x, y) <= 0; }
  friend bool operator>=(const Exact& x, const Exact& y) { return order(x, y) >= 0; }
  friend bool operator==(const Exact& x, const Exact& y) { return order(x, y) == 0; }
  friend bool operator!=(const Exact& x, const Exact& y) { return order(x, y) != 0; }
  friend Exact abs(const Exact& x) { return x.top_ < 0 ? -x : x; }
  friend Exact fabs(const Exact& x) { return abs(x); }
  // A root has no finite form: square the comparison, as the published test does.
  friend Exact sqrt(const Exact&) = delete;

  // The same number as a fraction of GMP.
  mpq_class fraction() const {
    mpq_class q(top_, bottom_);
    q.canonicalize();
    if (exponent_ >= 0) mpq_mul_2exp(q.get_mpq_t(), q.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent_));
    else mpq_div_2exp(q.get_mpq_t(), q.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent_));
    return q;
  }

 private:
  static constexpr int digits = 53;  // of a double

  Exact(mpz_class top, mpz_class bottom, long exponent)
      : top_(std::move(top)), bottom_(std::move(bottom)), exponent_(exponent) {
    tidy();
  }

  // Takes the twos out of the numerator, so that it does not grow with the exponents.
  void tidy() {
    if (top_ == 0) {
      bottom_ = 1;
      exponent_ = 0;
      return;
    }
    const mp_bitcnt_t twos = mpz_scan1(top_.get_mpz_t(), 0);
    if (twos == 0) return;
    mpz_tdiv_q_2exp(top_.get_mpz_t(), top_.get_mpz_t(), twos);
    exponent_ += static_cast<long>(twos);
  }

  static mpz_class shifted(const mpz_class& x, long twos) { return x << static_cast<mp_bitcnt_t>(twos); }

  static Exact sum(const Exact& x, const Exact& y, bool minus) {
    const long exponent = x.exponent_ < y.exponent_ ? x.exponent_ : y.exponent_;
    mpz_class left = shifted(x.top_, x.exponent_ - exponent), right = shifted(y.top_, y.exponent_ - exponent);
    if (minus) right = -right;
    if (x.bottom_ == y.bottom_) return Exact(left + right, x.bottom_, exponent);
    return Exact(left * y.bottom_ + right * x.bottom_, x.bottom_ * y.bottom_, exponent);
  }

  // The sign of x - y.
  static int order(const Exact& x, const Exact& y) {
    const int left = sgn(x.top_), right = sgn(y.top_);
    return left != right ? (left < right ? -1 : 1) : sgn(sum(x, y, true).top_);
  }

  // top / bottom * 2^exponent; bottom is above zero.
  mpz_class top_ = 0, bottom_ = 1;
  long exponent_ = 0;
};

}  // namespace axiscert::formulae

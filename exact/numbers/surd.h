// Exact numbers for formulae that need one division or root beyond a ring: n sqrt(k) / d of binary numbers.
#pragma once

#include <stdexcept>

#include "exact/numbers/binary_number.h"

namespace axiscert {

// The early forms of the derivation divide and take one root, never a root of a root nor a sum of two different roots;
// this type is closed under these operations. 0/0 and x/0 are undefined, as is every result made from them, and no
// comparison with an undefined number holds.
class Surd {
 public:
  Surd() : Surd(BinaryNumber()) {}
  explicit Surd(const BinaryNumber& x) : numerator_(x), denominator_(1), radicand_(1) {}

  bool is_undefined() const { return undefined_; }
  bool is_rational() const { return rational_; }
  const BinaryNumber& numerator() const { return numerator_; }
  const BinaryNumber& denominator() const { return denominator_; }  // positive
  const BinaryNumber& radicand() const { return radicand_; }        // not negative; 1 where rational

  friend Surd operator+(const Surd& a, const Surd& b) { return sum(a, b, b.numerator_); }
  friend Surd operator-(const Surd& a, const Surd& b) { return sum(a, b, -b.numerator_); }
  friend Surd operator*(const Surd& a, const Surd& b) {
    Surd result(a.numerator_ * b.numerator_, product(a.denominator_, b.denominator_), a.undefined_ || b.undefined_);
    if (a.rational_ && b.rational_) return result;
    if (!a.rational_ && !b.rational_) {
      if (a.radicand_ != b.radicand_) throw std::logic_error("Surd: a product of two different roots");
      result.numerator_ = result.numerator_ * a.radicand_;
      return result;
    }
    return result.times_root(a.rational_ ? b.radicand_ : a.radicand_);
  }
  friend Surd operator/(const Surd& a, const Surd& b) {
    if (b.undefined_ || b.numerator_.is_zero() || b.radicand_.is_zero())
      return Surd(BinaryNumber(), BinaryNumber::one(), true);
    // 1 / (n sqrt(k) / d) = d sqrt(k) / (n k), the sign of n moved to the numerator.
    const bool negative = b.numerator_.sign() < 0;
    Surd inverse(negative ? -b.denominator_ : b.denominator_, negative ? -b.numerator_ : b.numerator_, false);
    if (!b.rational_) {
      inverse.denominator_ = inverse.denominator_ * b.radicand_;
      inverse = inverse.times_root(b.radicand_);
    }
    return a * inverse;
  }
  // The root of a non-negative number: sqrt(n / d) = sqrt(n d) / d.
  friend Surd square_root(const Surd& a) {
    if (!a.rational_) throw std::logic_error("Surd: a root of a root");
    return Surd(BinaryNumber::one(), a.denominator_, a.undefined_).times_root(a.numerator_ * a.denominator_);
  }
  friend Surd magnitude(const Surd& a) {
    Surd result = a;
    if (result.numerator_.sign() < 0) result.numerator_ = -result.numerator_;
    return result;
  }
  friend bool operator>(const Surd& a, const Surd& b) { return defined(a, b) && compared(a, b) > 0; }
  friend bool operator>=(const Surd& a, const Surd& b) { return defined(a, b) && compared(a, b) >= 0; }

 private:
  Surd(const BinaryNumber& numerator, const BinaryNumber& denominator, bool undefined)
      : numerator_(numerator), denominator_(denominator), radicand_(1), undefined_(undefined) {}
  Surd times_root(const BinaryNumber& radicand) const {
    Surd result = *this;
    result.radicand_ = radicand;
    result.rational_ = false;
    return result;
  }

  static bool defined(const Surd& a, const Surd& b) { return !a.undefined_ && !b.undefined_; }
  static BinaryNumber product(const BinaryNumber& a, const BinaryNumber& b) {
    return is_one(a) ? b : is_one(b) ? a : a * b;
  }
  static bool is_one(const BinaryNumber& x) { return x == BinaryNumber::one(); }

  static Surd sum(const Surd& a, const Surd& b, const BinaryNumber& signed_b) {
    if (a.is_zero()) return Surd(signed_b, b.denominator_, a.undefined_ || b.undefined_).with_root_of(b);
    if (b.is_zero()) return Surd(a.numerator_, a.denominator_, a.undefined_ || b.undefined_).with_root_of(a);
    if (a.rational_ != b.rational_ || a.radicand_ != b.radicand_) {
      throw std::logic_error("Surd: a sum of different roots");
    }
    const bool undefined = a.undefined_ || b.undefined_;
    // The sums in the formulae nearly always have a common denominator.
    if (a.denominator_ == b.denominator_) {
      return Surd(a.numerator_ + signed_b, a.denominator_, undefined).with_root_of(a);
    }
    return Surd(product(a.numerator_, b.denominator_) + product(signed_b, a.denominator_),
                product(a.denominator_, b.denominator_), undefined)
        .with_root_of(a);
  }
  Surd with_root_of(const Surd& other) const { return other.rational_ ? *this : times_root(other.radicand_); }
  bool is_zero() const { return numerator_.is_zero() || radicand_.is_zero(); }

  // Sign of a - b: by signs, then by squares.
  static int compared(const Surd& a, const Surd& b) {
    const int sign_a = a.is_zero() ? 0 : a.numerator_.sign(), sign_b = b.is_zero() ? 0 : b.numerator_.sign();
    if (sign_a != sign_b || sign_a == 0) return sign_a < sign_b ? -1 : sign_a > sign_b;
    const auto squared = [](const Surd& x, const Surd& other) {
      return x.numerator_ * x.numerator_ * x.radicand_ * other.denominator_ * other.denominator_;
    };
    return sign_a * order(squared(a, b), squared(b, a));
  }

  BinaryNumber numerator_, denominator_, radicand_;
  bool rational_ = true, undefined_ = false;
};

}  // namespace axiscert

#include "exact/numbers/binary_number.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace axiscert {

BinaryNumber::BinaryNumber(double x) {
  if (x == 0) return;
  int exponent = 0;
  constexpr int digits = std::numeric_limits<double>::digits;
  const auto significand = static_cast<std::uint64_t>(std::ldexp(std::frexp(std::fabs(x), &exponent), digits));
  const int last = exponent - digits;
  exponent_ = last >= 0 ? last / 64 : -((63 - last) / 64);
  const int shift = last - 64 * exponent_;
  word_[0] = significand << shift;
  word_[1] = shift == 0 ? 0 : significand >> (64 - shift);
  size_ = 2;
  is_negative_ = x < 0;
  trim();
}

BinaryNumber::BinaryNumber(mpz_srcptr x) {
  size_ = mpz_size(x);
  reserve(size_);
  std::copy_n(mpz_limbs_read(x), size_, word_);
  is_negative_ = mpz_sgn(x) < 0;
  trim();
}

void BinaryNumber::reserve(std::size_t words) {
  if (words <= capacity_) return;
  if (word_ != own_) std::free(word_);
  word_ = static_cast<mp_limb_t*>(std::malloc(words * sizeof(mp_limb_t)));
  if (word_ == nullptr) std::abort();
  capacity_ = words;
}

void BinaryNumber::copy(const BinaryNumber& other) {
  reserve(other.size_);
  std::copy_n(other.word_, other.size_, word_);
  size_ = other.size_;
  exponent_ = other.exponent_;
  is_negative_ = other.is_negative_;
}

void BinaryNumber::take(BinaryNumber& other) {
  size_ = other.size_;
  exponent_ = other.exponent_;
  is_negative_ = other.is_negative_;
  if (other.word_ == other.own_) {
    std::copy_n(other.own_, size_, own_);
    return;
  }
  word_ = other.word_;
  capacity_ = other.capacity_;
  other.word_ = other.own_;
  other.capacity_ = own_words;
  other.size_ = 0;
}

void BinaryNumber::trim_ends() {
  while (size_ > 0 && word_[size_ - 1] == 0) --size_;
  std::size_t low = 0;
  while (low < size_ && word_[low] == 0) ++low;
  if (low > 0) {
    std::copy(word_ + low, word_ + size_, word_);
    size_ -= low;
    exponent_ += static_cast<int>(low);
  }
  if (size_ == 0) {
    exponent_ = 0;
    is_negative_ = false;
  }
}

BinaryNumber operator*(const BinaryNumber& a, const BinaryNumber& b) {
  BinaryNumber result;
  if (a.size_ == 0 || b.size_ == 0) return result;
  result.reserve(a.size_ + b.size_);
  if (a.size_ >= b.size_) mpn_mul(result.word_, a.word_, a.length(), b.word_, b.length());
  else mpn_mul(result.word_, b.word_, b.length(), a.word_, a.length());
  result.size_ = a.size_ + b.size_;
  result.exponent_ = a.exponent_ + b.exponent_;
  result.is_negative_ = a.is_negative_ != b.is_negative_;
  result.trim();
  return result;
}

long double BinaryNumber::approximately() const {
  if (size_ == 0) return 0;
  const long double more = size_ > 1 ? static_cast<long double>(word_[size_ - 2]) * 0x1p-64L : 0;
  const long double size = std::ldexp(static_cast<long double>(word_[size_ - 1]) + more, 64 * (top() - 1));
  return is_negative_ ? -size : size;
}

double BinaryNumber::to_double() const {
  return as_mpz([](mpz_srcptr whole, long exponent) {
    long more = 0;
    const double mantissa = mpz_get_d_2exp(&more, whole);
    constexpr long least = -2000, greatest = 2000;  // beyond all exponents of double
    return std::ldexp(mantissa, static_cast<int>(std::clamp(exponent + more, least, greatest)));
  });
}

int order(const BinaryNumber& a, const BinaryNumber& b) {
  if (a.sign() != b.sign()) return a.sign() < b.sign() ? -1 : 1;
  const int by_magnitude = BinaryNumber::order_of_magnitudes(a, b);
  return a.is_negative_ ? -by_magnitude : by_magnitude;
}

int BinaryNumber::order_of_magnitudes(const BinaryNumber& a, const BinaryNumber& b) {
  if (a.size_ == 0 || b.size_ == 0) return static_cast<int>(a.size_ != 0) - static_cast<int>(b.size_ != 0);
  if (a.top() != b.top()) return a.top() < b.top() ? -1 : 1;
  const std::size_t common = std::min(a.size_, b.size_);
  const int upper = mpn_cmp(a.word_ + a.size_ - common, b.word_ + b.size_ - common, static_cast<mp_size_t>(common));
  // The first word of a number is not 0, so the longer of two that agree so far is the greater.
  if (upper != 0 || a.size_ == b.size_) return upper < 0 ? -1 : upper > 0 ? 1 : 0;
  return a.size_ < b.size_ ? -1 : 1;
}

void BinaryNumber::extend_to(const BinaryNumber& a, int exponent) {
  const auto below = static_cast<std::size_t>(a.exponent_ - exponent);
  reserve(a.size_ + below);
  std::fill_n(word_, below, mp_limb_t{0});
  std::copy_n(a.word_, a.size_, word_ + below);
  size_ = a.size_ + below;
  exponent_ = exponent;
  is_negative_ = a.is_negative_;
}

BinaryNumber BinaryNumber::sum(const BinaryNumber& a, const BinaryNumber& b, bool b_is_negative) {
  if (b.size_ == 0) return a;
  if (a.size_ == 0) {
    BinaryNumber result = b;
    result.is_negative_ = b_is_negative;
    return result;
  }
  if (a.exponent_ == b.exponent_) return aligned_sum(a, b, b_is_negative);
  BinaryNumber extended;
  if (a.exponent_ > b.exponent_) {
    extended.extend_to(a, b.exponent_);
    return aligned_sum(extended, b, b_is_negative);
  }
  extended.extend_to(b, a.exponent_);
  return aligned_sum(a, extended, b_is_negative);
}

BinaryNumber BinaryNumber::aligned_sum(const BinaryNumber& a, const BinaryNumber& b, bool b_is_negative) {
  BinaryNumber result;
  result.exponent_ = a.exponent_;
  int which = a.size_ != b.size_ ? (a.size_ < b.size_ ? -1 : 1) : mpn_cmp(a.word_, b.word_, a.length());
  const BinaryNumber &greater = which < 0 ? b : a, &less = which < 0 ? a : b;
  result.reserve(greater.size_ + 1);
  if (a.is_negative_ == b_is_negative) {
    const mp_limb_t carry = mpn_add(result.word_, greater.word_, greater.length(), less.word_, less.length());
    result.size_ = greater.size_;
    if (carry != 0) result.word_[result.size_++] = carry;
    result.is_negative_ = b_is_negative;
  } else if (which != 0) {
    mpn_sub(result.word_, greater.word_, greater.length(), less.word_, less.length());
    result.size_ = greater.size_;
    result.is_negative_ = which < 0 ? b_is_negative : a.is_negative_;
  }
  result.trim();
  return result;
}

}  // namespace axiscert

// Numbers of finitely many binary digits, of any size: what finite floats become by +, - and *, exactly. Words are in
// the object as long as they are few, so that most operations allocate nothing.
#pragma once

#include <gmp.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>

namespace axiscert {

// Sign and magnitude: the words, least significant first, times 2^(64 exponent). Neither the first word nor the last is
// 0, so a number has one form; 0 has no words. It shares nothing with CGAL's type of the same purpose, which the
// formulae are evaluated in (exact/trait/dyadic_number.h), so that each checks the other.
class BinaryNumber {
  static_assert(GMP_NUMB_BITS == 64);

 public:
  BinaryNumber() = default;
  // Finite.
  explicit BinaryNumber(double x) {
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
  explicit BinaryNumber(mpz_srcptr x) {
    size_ = mpz_size(x);
    reserve(size_);
    std::copy_n(mpz_limbs_read(x), size_, word_);
    is_negative_ = mpz_sgn(x) < 0;
    trim();
  }
  BinaryNumber(const BinaryNumber& other) { copy(other); }
  BinaryNumber(BinaryNumber&& other) noexcept { take(other); }
  BinaryNumber& operator=(const BinaryNumber& other) {
    if (this != &other) copy(other);
    return *this;
  }
  BinaryNumber& operator=(BinaryNumber&& other) noexcept {
    if (this == &other) return *this;
    if (word_ != own_) std::free(word_);
    word_ = own_;
    capacity_ = own_words;
    take(other);
    return *this;
  }
  ~BinaryNumber() {
    if (word_ != own_) std::free(word_);
  }

  // -1, 0 or 1.
  int sign() const { return size_ == 0 ? 0 : is_negative_ ? -1 : 1; }

  BinaryNumber operator-() const {
    BinaryNumber result = *this;
    result.is_negative_ = !is_negative_;
    return result;
  }
  friend BinaryNumber operator+(const BinaryNumber& a, const BinaryNumber& b) { return sum(a, b, b.is_negative_); }
  friend BinaryNumber operator-(const BinaryNumber& a, const BinaryNumber& b) { return sum(a, b, !b.is_negative_); }
  friend BinaryNumber operator*(const BinaryNumber& a, const BinaryNumber& b) {
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
  friend BinaryNumber magnitude(const BinaryNumber& a) {
    BinaryNumber result = a;
    result.is_negative_ = false;
    return result;
  }

  // -1, 0 or 1, as a is less than b, equal or greater.
  friend int order(const BinaryNumber& a, const BinaryNumber& b) {
    if (a.sign() != b.sign()) return a.sign() < b.sign() ? -1 : 1;
    const int by_magnitude = order_of_magnitudes(a, b);
    return a.is_negative_ ? -by_magnitude : by_magnitude;
  }
  friend bool operator==(const BinaryNumber& a, const BinaryNumber& b) { return order(a, b) == 0; }
  friend bool operator>(const BinaryNumber& a, const BinaryNumber& b) { return order(a, b) > 0; }
  friend bool operator>=(const BinaryNumber& a, const BinaryNumber& b) { return order(a, b) >= 0; }
  friend bool operator<(const BinaryNumber& a, const BinaryNumber& b) { return order(a, b) < 0; }
  friend bool operator<=(const BinaryNumber& a, const BinaryNumber& b) { return order(a, b) <= 0; }

  // Calls use(mpz, exponent) with a view of the words as an integer of GMP; the number is mpz 2^exponent.
  template <class Use>
  auto as_mpz(Use&& use) const {
    mpz_t view;
    return use(static_cast<mpz_srcptr>(mpz_roinit_n(view, word_, is_negative_ ? -length() : length())),
               64L * exponent_);
  }

 private:
  static constexpr std::size_t own_words = 16;

  mp_size_t length() const { return static_cast<mp_size_t>(size_); }
  int top() const { return exponent_ + static_cast<int>(size_); }

  // Room for so many words, whose values are then arbitrary.
  void reserve(std::size_t words) {
    if (words <= capacity_) return;
    if (word_ != own_) std::free(word_);
    word_ = static_cast<mp_limb_t*>(std::malloc(words * sizeof(mp_limb_t)));
    if (word_ == nullptr) std::abort();
    capacity_ = words;
  }
  void copy(const BinaryNumber& other) {
    reserve(other.size_);
    std::copy_n(other.word_, other.size_, word_);
    size_ = other.size_;
    exponent_ = other.exponent_;
    is_negative_ = other.is_negative_;
  }
  // Precondition: the words are in the object.
  void take(BinaryNumber& other) {
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
  // Removes the words at both ends that are 0.
  void trim() {
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

  static int order_of_magnitudes(const BinaryNumber& a, const BinaryNumber& b) {
    if (a.size_ == 0 || b.size_ == 0) return static_cast<int>(a.size_ != 0) - static_cast<int>(b.size_ != 0);
    if (a.top() != b.top()) return a.top() < b.top() ? -1 : 1;
    const std::size_t common = std::min(a.size_, b.size_);
    const int upper = mpn_cmp(a.word_ + a.size_ - common, b.word_ + b.size_ - common, static_cast<mp_size_t>(common));
    // The first word of a number is not 0, so the longer of two that agree so far is the greater.
    if (upper != 0 || a.size_ == b.size_) return upper < 0 ? -1 : upper > 0 ? 1 : 0;
    return a.size_ < b.size_ ? -1 : 1;
  }

  // The same with its lowest word at `exponent`, which is not above its own.
  void extend_to(const BinaryNumber& a, int exponent) {
    const auto below = static_cast<std::size_t>(a.exponent_ - exponent);
    reserve(a.size_ + below);
    std::fill_n(word_, below, mp_limb_t{0});
    std::copy_n(a.word_, a.size_, word_ + below);
    size_ = a.size_ + below;
    exponent_ = exponent;
    is_negative_ = a.is_negative_;
  }

  // a + b or a - b; `b_is_negative` is the sign to use for b.
  static BinaryNumber sum(const BinaryNumber& a, const BinaryNumber& b, bool b_is_negative) {
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
  // Of numbers of one exponent, neither of them 0.
  static BinaryNumber aligned_sum(const BinaryNumber& a, const BinaryNumber& b, bool b_is_negative) {
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

  std::size_t size_ = 0, capacity_ = own_words;
  mp_limb_t* word_ = own_;
  int exponent_ = 0;
  bool is_negative_ = false;
  mp_limb_t own_[own_words];
};

}  // namespace axiscert

// Numbers of finitely many binary digits, of any size: what finite floats become by +, - and *, exactly. Words are in
// the object as long as they are few, so that most operations allocate nothing.
#pragma once

#include <gmp.h>

#include <cstddef>
#include <cstdlib>

namespace axiscert {

// Sign and magnitude: the words, least significant first, times 2^(64 exponent). Neither the first word nor the last is
// 0, so a number has one form; 0 has no words. It shares nothing with CGAL's type of the same purpose
// (exact/boxes/clipping.h), so that each checks the other.
class BinaryNumber {
  static_assert(GMP_NUMB_BITS == 64);

 public:
  BinaryNumber() = default;
  // Finite.
  explicit BinaryNumber(double x);
  static BinaryNumber one() {
    BinaryNumber result;
    result.size_ = 1;
    result.own_[0] = 1;
    return result;
  }
  explicit BinaryNumber(mpz_srcptr x);
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
  bool is_zero() const { return size_ == 0; }

  BinaryNumber operator-() const {
    BinaryNumber result = *this;
    result.is_negative_ = !is_negative_;
    return result;
  }
  friend BinaryNumber operator+(const BinaryNumber& a, const BinaryNumber& b) { return sum(a, b, b.is_negative_); }
  friend BinaryNumber operator-(const BinaryNumber& a, const BinaryNumber& b) { return sum(a, b, !b.is_negative_); }
  friend BinaryNumber operator*(const BinaryNumber& a, const BinaryNumber& b);
  friend BinaryNumber magnitude(const BinaryNumber& a) {
    BinaryNumber result = a;
    result.is_negative_ = false;
    return result;
  }

  // -1, 0 or 1, as a is less than b, equal or greater.
  friend int order(const BinaryNumber& a, const BinaryNumber& b);
  friend bool operator==(const BinaryNumber& a, const BinaryNumber& b) { return order(a, b) == 0; }
  friend bool operator>(const BinaryNumber& a, const BinaryNumber& b) { return order(a, b) > 0; }
  friend bool operator>=(const BinaryNumber& a, const BinaryNumber& b) { return order(a, b) >= 0; }
  friend bool operator<(const BinaryNumber& a, const BinaryNumber& b) { return order(a, b) < 0; }
  friend bool operator<=(const BinaryNumber& a, const BinaryNumber& b) { return order(a, b) <= 0; }

  // Within 2^-62 of its size: the words from the third on are left out, and a sum is rounded where long double has 64
  // bits. Infinite, or 0, beyond the exponents of long double.
  long double approximately() const;

  // Its 53 leading bits; infinite, or subnormal, beyond the exponents of double.
  double to_double() const;

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
  void reserve(std::size_t words);
  void copy(const BinaryNumber& other);
  // Precondition: the words are in the object.
  void take(BinaryNumber& other);
  // Removes the words at both ends that are 0.
  void trim() {
    if (size_ == 0 || word_[0] == 0 || word_[size_ - 1] == 0) trim_ends();
  }
  void trim_ends();

  static int order_of_magnitudes(const BinaryNumber& a, const BinaryNumber& b);

  // The same with its lowest word at `exponent`, which is not above its own.
  void extend_to(const BinaryNumber& a, int exponent);

  // a + b or a - b; `b_is_negative` is the sign to use for b.
  static BinaryNumber sum(const BinaryNumber& a, const BinaryNumber& b, bool b_is_negative);
  // The same of numbers of one exponent, neither of them 0.
  static BinaryNumber aligned_sum(const BinaryNumber& a, const BinaryNumber& b, bool b_is_negative);

  std::size_t size_ = 0, capacity_ = own_words;
  mp_limb_t* word_ = own_;
  int exponent_ = 0;
  bool is_negative_ = false;
  mp_limb_t own_[own_words];
};

}  // namespace axiscert

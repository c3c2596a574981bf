#include "exact/numbers/roots.h"

#include <algorithm>
#include <cstdlib>
#include <optional>

namespace axiscert {
namespace {

Rational power_of_ten(long n) {
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(std::labs(n)));
  return n < 0 ? Rational(mpz_class(1), power) : Rational(power);
}

// d.ddd times 10^exponent as doubles are written: without an exponent from 1e-4 to the last digit before the point.
std::string decimal_form(std::string digits, long exponent, int most) {
  while (digits.size() > 1 && digits.back() == '0') digits.pop_back();
  const auto count = static_cast<long>(digits.size());
  if (exponent >= -4 && exponent < 0) return "0." + std::string(static_cast<std::size_t>(-exponent - 1), '0') + digits;
  if (exponent >= 0 && exponent < most) {
    if (count <= exponent) return digits + std::string(static_cast<std::size_t>(exponent + 1 - count), '0');
    if (count > exponent + 1) digits.insert(static_cast<std::size_t>(exponent + 1), ".");
    return digits;
  }
  if (count > 1) digits.insert(1, ".");
  const std::string power = std::to_string(std::labs(exponent));
  return digits + (exponent < 0 ? "e-" : "e+") + (power.size() < 2 ? "0" : "") + power;
}

}  // namespace

int compare(const RootNumber& x, const Rational& y) {
  const Rational rest = x.rest - y;
  const int rest_sign = sgn(rest), root_sign = x.sign * sgn(x.square);
  if (rest_sign == 0 || root_sign == 0 || rest_sign == root_sign) return rest_sign != 0 ? rest_sign : root_sign;
  return rest_sign * sgn(Rational(rest * rest - x.square));
}

Rational root_below(const Rational& q) {
  constexpr long bits = 256;
  const mpz_class product = q.get_num() * q.get_den();
  const long length = static_cast<long>(mpz_sizeinbase(product.get_mpz_t(), 2));
  const auto shift = static_cast<mp_bitcnt_t>(std::max(0L, bits - length / 2));
  mpz_class shifted = product << 2 * shift;
  mpz_sqrt(shifted.get_mpz_t(), shifted.get_mpz_t());
  Rational root(shifted, q.get_den() << shift);
  root.canonicalize();
  return root;
}

std::optional<Rational> rational_root(const Rational& q) {
  if (!mpz_perfect_square_p(q.get_num_mpz_t()) || !mpz_perfect_square_p(q.get_den_mpz_t())) return std::nullopt;
  return Rational(sqrt(q.get_num()), sqrt(q.get_den()));
}

Rational approximate_magnitude(const RootNumber& x) {
  const Rational root = root_below(x.square), rest = abs(x.rest);
  if (sgn(x.rest) * x.sign >= 0) return rest + root;
  return abs(Rational(x.rest * x.rest - x.square)) / (rest + root);
}

std::string decimal_text(const Rational& guess, const std::function<int(const Rational& y)>& order, int digits) {
  // 10^exponent is not above the number, and ten times that is.
  long exponent = static_cast<long>(mpz_sizeinbase(guess.get_num_mpz_t(), 10)) -
                  static_cast<long>(mpz_sizeinbase(guess.get_den_mpz_t(), 10));
  while (order(power_of_ten(exponent)) < 0) --exponent;
  while (order(power_of_ten(exponent + 1)) >= 0) ++exponent;
  // So many units of the last digit are not above it, and one more is.
  const Rational unit = power_of_ten(exponent + 1 - digits), units = guess / unit;
  mpz_class count = units.get_num() / units.get_den();
  while (order(Rational(count * unit)) < 0) --count;
  while (order(Rational((count + 1) * unit)) >= 0) ++count;
  const int beyond_half = order(Rational((2 * count + 1) * unit / 2));
  if (beyond_half > 0 || (beyond_half == 0 && mpz_odd_p(count.get_mpz_t()))) ++count;
  std::string text = count.get_str();
  if (text.size() > static_cast<std::size_t>(digits)) ++exponent;
  return decimal_form(text, exponent, digits);
}

std::string decimal_text(const RootNumber& x, int digits) {
  const int sign = compare(x, 0);
  if (sign == 0) return "0";
  const auto order = [&](const Rational& y) { return sign * compare(x, Rational(sign * y)); };
  return (sign < 0 ? "-" : "") + decimal_text(approximate_magnitude(x), order, digits);
}

std::string exact_text(const RootNumber& x) {
  if (const std::optional<Rational> root = rational_root(x.square)) return Rational(x.rest + x.sign * *root).get_str();
  const std::string root = "sqrt(" + x.square.get_str() + ")";
  if (sgn(x.rest) == 0) return (x.sign < 0 ? "-" : "") + root;
  return x.rest.get_str() + (x.sign < 0 ? " - " : " + ") + root;
}

TwoRoots TwoRootField::product(const TwoRoots& x, const TwoRoots& y) const {
  return {x.a * y.a + x.b * y.b * p_ + x.c * y.c * q_ + x.d * y.d * p_ * q_,
          x.a * y.b + x.b * y.a + (x.c * y.d + x.d * y.c) * q_, x.a * y.c + x.c * y.a + (x.b * y.d + x.d * y.b) * p_,
          x.a * y.d + x.d * y.a + x.b * y.c + x.c * y.b};
}

int TwoRootField::sign(const Rational& a, const Rational& b) const {
  const int first = sgn(a), second = sgn(p_) == 0 ? 0 : sgn(b);
  if (first == 0 || second == 0 || first == second) return first != 0 ? first : second;
  return first * cmp(Rational(a * a), Rational(b * b * p_));
}

// x = u + v sqrt(q), u and v with sqrt(p) alone: where their signs differ, u^2 against v^2 q decides.
int TwoRootField::sign(const TwoRoots& x) const {
  const int first = sign(x.a, x.b), second = sgn(q_) == 0 ? 0 : sign(x.c, x.d);
  if (first == 0 || second == 0 || first == second) return first != 0 ? first : second;
  const Rational rational = x.a * x.a + x.b * x.b * p_ - (x.c * x.c + x.d * x.d * p_) * q_,
                 with_root = 2 * (x.a * x.b - x.c * x.d * q_);
  return first * sign(rational, with_root);
}

namespace {

int sign_of(const RootTerm& x) { return sgn(x.factor) * sgn(x.square); }
Rational square_of(const RootTerm& x) { return x.factor * x.factor * x.square; }

}  // namespace

int sign_of_sum(const RootTerm& x, const RootTerm& y) {
  const int of_x = sign_of(x), of_y = sign_of(y);
  if (of_x == 0 || of_y == 0 || of_x == of_y) return of_x != 0 ? of_x : of_y;
  return of_x * sgn(Rational(square_of(x) - square_of(y)));
}

int sign_of_sum(const RootTerm& x, const RootTerm& y, const RootTerm& z) {
  const int of_both = sign_of_sum(x, y), of_z = sign_of(z);
  if (of_both == 0 || of_z == 0 || of_both == of_z) return of_both != 0 ? of_both : of_z;
  // (x + y)^2 - z^2, in which one root is left.
  const RootTerm rational{square_of(x) + square_of(y) - square_of(z)};
  return of_both * sign_of_sum(rational, {2 * x.factor * y.factor, Rational(x.square * y.square)});
}

Decimal6 round_up(const Rational& guess, const std::function<int(const Rational& y)>& order) {
  Decimal6 found = round_up(guess);
  if (found.is_zero()) return found;
  while (order(exact(found)) > 0) found = next(found);
  for (Decimal6 less = previous(found); order(exact(less)) <= 0; less = previous(found)) found = less;
  return found;
}

}  // namespace axiscert

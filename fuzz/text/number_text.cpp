#include "fuzz/text/number_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>

#include "exact/numbers/rational.h"
#include "kernel/base/error.h"
#include "kernel/names.h"

namespace axiscert {
namespace {

bool is_digit(char c, int base) {
  const bool decimal = c >= '0' && c <= '9';
  return decimal || (base == 16 && ((c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F')));
}

// digits * base^-fraction * (2 or 10)^exponent. No leading zeros: an empty `digits` is zero.
struct ScannedNumber {
  std::string digits;
  std::int64_t fraction = 0;
  std::int64_t exponent = 0;
};

// Far beyond any exponent that matters, and far below the overflow of 64 bits.
constexpr std::int64_t exponent_limit = std::int64_t{1} << 40;

// False if the text is not DIGITS[.DIGITS][EXPONENT] with at least one digit.
bool scan(std::string_view text, int base, ScannedNumber& out) {
  std::size_t i = 0;
  bool any = false, point = false;
  for (; i < text.size(); ++i) {
    if (text[i] == '.' && !point) {
      point = true;
      continue;
    }
    if (!is_digit(text[i], base)) break;
    any = true;
    out.fraction += point ? 1 : 0;
    if (!out.digits.empty() || text[i] != '0') out.digits += text[i];
  }
  if (!any) return false;
  if (i == text.size()) return true;
  const char letter = base == 16 ? 'p' : 'e';
  if ((text[i] | 0x20) != letter) return false;
  if (++i == text.size()) return false;
  const bool negative = text[i] == '-';
  if (negative || text[i] == '+') ++i;
  if (i == text.size()) return false;
  for (; i < text.size(); ++i) {
    if (!is_digit(text[i], 10)) return false;
    out.exponent = std::min(exponent_limit, out.exponent * 10 + (text[i] - '0'));
  }
  if (negative) out.exponent = -out.exponent;
  return true;
}

// Digits beyond `kept` matter only if one of them is not zero: one additional digit records that. Returns the number of
// digits removed.
std::int64_t shorten(std::string& digits, std::size_t kept) {
  const std::size_t size = digits.size();
  while (digits.size() > 1 && digits.back() == '0') digits.pop_back();
  if (digits.size() > kept + 1) {
    digits.resize(kept);
    digits += '1';
  }
  return static_cast<std::int64_t>(size - digits.size());
}

// digits (base 16 or 10) * root^exponent.
Rational product_with_power(const std::string& digits, int base, unsigned long root, std::int64_t exponent) {
  Rational q;
  q.get_num().set_str(digits, base);
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), root, static_cast<unsigned long>(std::abs(exponent)));
  if (exponent < 0) q.get_den() = power;
  else q.get_num() *= power;
  return q;
}

template <class Real>
[[noreturn]] void throw_overflow(std::string_view text) {
  throw Error(fmt::format("{} overflows {}; the greatest number is {}", shown(text), name(precision_of<Real>),
                          format_number(std::numeric_limits<Real>::max())));
}

template <class Real>
Real hex_value(std::string_view text, bool negative, ScannedNumber& scanned) {
  // Both formats lie within 2^-1075 and 2^1024; 20 hex digits are more than either can represent.
  const std::int64_t cut = shorten(scanned.digits, 20);
  const std::int64_t exponent = scanned.exponent - 4 * (scanned.fraction - cut);
  const std::int64_t top = 4 * static_cast<std::int64_t>(scanned.digits.size()) + exponent;
  if (top > 1200) throw_overflow<Real>(text);
  Real nearest_value = 0;
  bool is_exact = false;
  if (top > -1200) {
    const Rational q = product_with_power(scanned.digits, 16, 2, exponent);
    nearest_value = nearest<Real>(q);
    if (std::isinf(nearest_value)) throw_overflow<Real>(text);
    // q is not in lowest terms, which mpq's == would require.
    is_exact = exact(nearest_value) * Rational(q.get_den()) == Rational(q.get_num());
  }
  const Real value = negative ? -nearest_value : nearest_value;
  if (!is_exact) {
    throw Error(fmt::format("{} is not exact in {}; nearest is {}", shown(text), name(precision_of<Real>),
                            format_number(value)));
  }
  return value;
}

template <class Real>
Real decimal_value(std::string_view text, bool negative, ScannedNumber& scanned) {
  // A midpoint between two binary64 numbers has at most 768 significant digits.
  const std::int64_t cut = shorten(scanned.digits, 800);
  const std::int64_t exponent = scanned.exponent - (scanned.fraction - cut);
  const std::int64_t top = static_cast<std::int64_t>(scanned.digits.size()) + exponent;
  Real magnitude = 0;
  if (top > 400) throw_overflow<Real>(text);
  if (top > -400) magnitude = nearest<Real>(product_with_power(scanned.digits, 10, 10, exponent));
  if (std::isinf(magnitude)) throw_overflow<Real>(text);
  return negative ? -magnitude : magnitude;
}

}  // namespace

template <class Real>
Real parse_number(std::string_view text) {
  if (text == "nan") return std::numeric_limits<Real>::quiet_NaN();
  if (text == "inf") return std::numeric_limits<Real>::infinity();
  if (text == "-inf") return -std::numeric_limits<Real>::infinity();
  std::string_view body = text;
  const bool negative = body.starts_with('-');
  if (negative) body.remove_prefix(1);
  const bool hex = body.starts_with("0x") || body.starts_with("0X");
  if (hex) body.remove_prefix(2);
  ScannedNumber scanned;
  if (!scan(body, hex ? 16 : 10, scanned)) {
    throw Error(fmt::format(
        "'{}' is not a number; write C hexadecimal (0x1.8p-3), a decimal (0.1875), nan, inf or -inf", shown(text)));
  }
  if (scanned.digits.empty()) return negative ? -Real(0) : Real(0);
  return hex ? hex_value<Real>(text, negative, scanned) : decimal_value<Real>(text, negative, scanned);
}
template float parse_number<float>(std::string_view);
template double parse_number<double>(std::string_view);

template <class Real>
std::string format_number(Real x) {
  if (std::isnan(x)) return "nan";
  if (std::isinf(x)) return x > 0 ? "inf" : "-inf";
  const char* sign = std::signbit(x) ? "-" : "";
  if (x == 0) return fmt::format("{}0x0p+0", sign);
  // As a binary64 every binary32 is exact and normal, and frexp normalises binary64's own subnormals.
  int exponent;
  const double half = std::frexp(std::abs(static_cast<double>(x)), &exponent);
  const auto significand = static_cast<std::uint64_t>(std::ldexp(half, 53));
  std::string digits = fmt::format("{:013x}", significand & ((std::uint64_t{1} << 52) - 1));
  while (!digits.empty() && digits.back() == '0') digits.pop_back();
  return fmt::format("{}0x1{}{}p{:+d}", sign, digits.empty() ? "" : ".", digits, exponent - 1);
}
template std::string format_number<float>(float);
template std::string format_number<double>(double);

std::string bit_string(std::uint64_t bits, std::size_t count) {
  std::string text(count, '0');
  for (std::size_t i = 0; i < count; ++i) {
    if (has_bit(bits, i)) text[i] = '1';
  }
  return text;
}

std::string shown(std::string_view text) {
  constexpr std::size_t limit = 60;
  std::string line(text.substr(0, limit));
  if (text.size() > limit) {
    // Moves back to the start of a UTF-8 character.
    while (!line.empty() && (static_cast<unsigned char>(text[line.size()]) & 0xc0) == 0x80) line.pop_back();
  }
  line = printable_line(line);
  if (text.size() > limit) line += fmt::format("... ({} characters)", text.size());
  return line;
}

namespace {

constexpr LengthUnit all_units[] = {{"m", 1},     {"cm", 1e-2},   {"mm", 1e-3},  {"um", 1e-6},
                                    {"km", 1000}, {"in", 0.0254}, {"ft", 0.3048}};

}  // namespace

const LengthUnit* find_length_unit(std::string_view name) {
  const auto* const found = std::ranges::find(all_units, name, &LengthUnit::name);
  return found == std::end(all_units) ? nullptr : found;
}

std::vector<std::string_view> length_unit_names() {
  std::vector<std::string_view> names;
  for (const LengthUnit& unit : all_units) names.push_back(unit.name);
  return names;
}

std::string metric_text(double metres) {
  if (metres == 0) return "0 m";
  constexpr std::string_view metric[] = {"km", "m", "cm", "mm", "um"};
  const double size = std::fabs(metres);
  if (size < 1e-9 || size >= 1e6) return fmt::format("{:.3g} m", metres);
  const auto* const fits = std::ranges::find_if(
      metric, [&](std::string_view name) { return size >= find_length_unit(name)->metres * 0.9995; });
  const std::string_view name = fits == std::end(metric) ? "um" : *fits;
  return fmt::format("{:.3g} {}", metres / find_length_unit(name)->metres, name);
}

std::string length_text(double length, const LengthUnit* unit) {
  if (unit == nullptr) return fmt::format("{:.3g} units", length);
  const bool is_metric = unit->name != "in" && unit->name != "ft";
  return is_metric ? metric_text(length * unit->metres) : fmt::format("{:.3g} {}", length, unit->name);
}

std::optional<double> length_in_metres(std::string_view text) {
  double number = 0;
  const char* const end = text.data() + text.size();
  auto [stop, problem] = std::from_chars(text.data(), end, number);
  while (stop != end && *stop == ' ') ++stop;
  const LengthUnit* const unit = find_length_unit({stop, static_cast<std::size_t>(end - stop)});
  if (problem != std::errc() || unit == nullptr || !(number > 0) || !std::isfinite(number)) return std::nullopt;
  return number * unit->metres;
}

}  // namespace axiscert

#include "exact/numbers/number_format.h"

#include <fmt/format.h>

#include <charconv>

#include "kernel/base/error.h"

namespace axiscert {
namespace {

constexpr long greatest_exponent = 1L << 30;

NumberFormat ieee(std::string name, int bits, long greatest) {
  return {std::move(name), bits, ExponentLimits(1 - greatest, greatest)};
}

// OCP 8-bit Floating Point Specification 1.0. E4M3 has one exponent more than its bias allows, for it has no infinity
// and one NaN of each sign, S.1111.111; its greatest number is 1.75 x 2^8 = 448.
NumberFormat e4m3(std::string name, Overflow overflow) {
  ExponentLimits exponents(-6, 8);
  exponents.overflow = overflow;
  exponents.ones_are_nan = true;
  return {std::move(name), 4, exponents};
}
NumberFormat e5m2(std::string name, Overflow overflow) {
  ExponentLimits exponents(-14, 15);
  exponents.overflow = overflow;
  return {std::move(name), 3, exponents};
}

// The value of "KEY=NUMBER".
long number_after(std::string_view given, std::string_view part, std::string_view key, long least, long most) {
  const std::string_view digits = part.substr(key.size() + 1);
  long value = 0;
  const char* end = digits.data() + digits.size();
  const auto [stop, problem] = std::from_chars(digits.data(), end, value);
  const bool is_beyond = problem == std::errc::result_out_of_range || value < least || value > most;
  if (stop != end || digits.empty() || is_beyond) {
    throw Error(fmt::format("number format '{}': {}= takes a whole number from {} to {}, not '{}'", given, key, least,
                            most, digits));
  }
  return value;
}

}  // namespace

NumberFormat format_of_bits(int bits) { return {fmt::format("bits={}", bits), bits}; }

const std::vector<NamedFormat>& named_formats() {
  static const std::vector<NamedFormat> all = {
      {e4m3("fp8-e4m3", Overflow::nan), "8 bits, greatest number 448, no infinity: what is beyond is NaN (OCP)"},
      {e4m3("fp8-e4m3-saturating", Overflow::greatest), "the same, but what is beyond is 448"},
      {e5m2("fp8-e5m2", Overflow::infinity), "8 bits, greatest number 57344, with infinities (OCP)"},
      {e5m2("fp8-e5m2-saturating", Overflow::greatest), "the same, but what is beyond is 57344"},
      {ieee("bfloat16", 8, 127), "8 bits of precision with the exponents of binary32"},
      {ieee("binary16", 11, 15), "half precision (IEEE 754)"},
      {ieee("tf32", 11, 127), "11 bits of precision with the exponents of binary32"},
      {ieee("binary32", 24, 127), "single precision (IEEE 754)"},
      {ieee("binary64", 53, 1023), "double precision (IEEE 754)"},
      {ieee("x87", 64, 16383), "the 80-bit format of x87"},
      {ieee("binary128", 113, 16383), "quadruple precision (IEEE 754)"},
  };
  return all;
}

std::string number_formats_text() {
  std::string text;
  for (const NamedFormat& each : named_formats()) text += each.format.name + ", ";
  return text + fmt::format("or bits=P,emax=E with P from {} to {}", least_bits, greatest_bits);
}

NumberFormat parse_number_format(std::string_view text) {
  for (const NamedFormat& each : named_formats()) {
    if (each.format.name == text) return each.format;
  }
  const std::size_t comma = text.find(',');
  const std::string_view first = text.substr(0, comma);
  if (!first.starts_with("bits=") && text.find('=') != text.npos) {
    throw Error(fmt::format("number format '{}': the form is bits=P,emax=E, for instance bits=11,emax=15", text));
  }
  if (!first.starts_with("bits=")) {
    std::vector<std::string_view> names;
    for (const NamedFormat& each : named_formats()) names.push_back(each.format.name);
    names.emplace_back("bits=P,emax=E");
    throw Error(unknown_name("number format", "number formats", text, names));
  }
  const auto bits = static_cast<int>(number_after(text, first, "bits", least_bits, greatest_bits));
  if (comma == text.npos) return format_of_bits(bits);
  const std::string_view second = text.substr(comma + 1);
  if (!second.starts_with("emax=")) {
    throw Error(fmt::format("number format '{}': '{}' stands where emax=E is expected; an example: bits=11,emax=15",
                            text, second));
  }
  const long greatest = number_after(text, second, "emax", 1, greatest_exponent);
  return ieee(fmt::format("bits={},emax={}", bits, greatest), bits, greatest);
}

FloatingFormat floating(const NumberFormat& format, RoundingRule rule, const ExponentLimits& exponents,
                        std::uint64_t seed) {
  constexpr EnumArray<RoundingRule, Rounding> modes = {Rounding::nearest,     Rounding::upward,  Rounding::downward,
                                                       Rounding::toward_zero, Rounding::nearest, Rounding::nearest};
  const Chance chance = rule == RoundingRule::faithful     ? Chance::faithful
                        : rule == RoundingRule::stochastic ? Chance::stochastic
                                                           : Chance::none;
  return {format.bits, modes[rule], format.exponents.value_or(exponents), chance, seed};
}

}  // namespace axiscert

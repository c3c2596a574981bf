#include "cli/values.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "kernel/base/alike.h"

namespace axiscert {
namespace {

constexpr std::uint64_t no_limit = std::numeric_limits<std::uint64_t>::max();

std::optional<double> number_of(const std::string& text) {
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, problem] = std::from_chars(text.data(), end, value);
  return problem == std::errc() && stop == end && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

// The digits of a whole number that is written in another way, as 1e6, 2^20, 1,000 or 1_000; empty for anything else.
std::string in_digits(const std::string& text) {
  const auto whole = [](double value) {
    return value >= 0 && value < 0x1p53 && value == std::floor(value)
               ? fmt::format("{}", static_cast<std::uint64_t>(value))
               : "";
  };
  if (text.starts_with("2^")) {
    const auto power = number_of(text.substr(2));
    return power && *power >= 0 && *power < 53 ? whole(std::exp2(*power)) : "";
  }
  std::string bare = text;
  std::erase_if(bare, [](char c) { return c == ',' || c == '_'; });
  const auto value = number_of(bare);
  return value ? whole(*value) : "";
}

std::string range_text(std::uint64_t least, std::uint64_t most) {
  return most == no_limit ? fmt::format(">= {}", least) : fmt::format("from {} to {}", least, most);
}

// The fault of the text; empty where it has none.
std::string wrong_whole_number(const std::string& text, std::uint64_t least, std::uint64_t most) {
  if (text.empty() || text.find_first_not_of("0123456789") != text.npos) {
    const std::string digits = in_digits(text);
    return fmt::format("'{}' is not a whole number {}, in digits{}", text, range_text(least, most),
                       digits.empty() ? "" : ": write " + digits);
  }
  std::uint64_t value = 0;
  const auto [stop, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (problem == std::errc::result_out_of_range || value > most)
    return fmt::format("{} is too large; the greatest is {}", text, most);
  return value < least ? fmt::format("{} is too small; the least is {}", text, least) : "";
}

}  // namespace

CLI::Validator whole_number(std::uint64_t least, std::uint64_t most) {
  const bool any = least == 0 && most == no_limit;
  return {[=](std::string& text) { return wrong_whole_number(text, least, most); },
          any                ? ""
          : most == no_limit ? fmt::format("UINT >= {}", least)
                             : fmt::format("UINT in [{} - {}]", least, most)};
}

CLI::Validator number_above_zero() {
  return {[](std::string& text) {
            const auto value = number_of(text);
            return value && *value > 0 ? "" : fmt::format("'{}' is not a number > 0, such as 0.5", text);
          },
          "POSITIVE"};
}

CLI::Validator number_between(double least, double most) {
  return {[=](std::string& text) {
            const auto value = number_of(text);
            return value && *value >= least && *value <= most
                       ? ""
                       : fmt::format("'{}' is not a number from {} to {}", text, least, most);
          },
          fmt::format("FLOAT in [{} - {}]", least, most)};
}

CLI::Validator one_of(std::vector<std::string> words) {
  std::string description = fmt::format("{{{}}}", fmt::join(words, ","));
  return {[words = std::move(words)](std::string& text) -> std::string {
            if (std::find(words.begin(), words.end(), text) != words.end()) return "";
            const std::vector<std::string_view> known(words.begin(), words.end());
            return fmt::format("unknown value '{}'{} values: {}", text, did_you_mean(text, known),
                               fmt::join(known, ", "));
          },
          std::move(description)};
}

}  // namespace axiscert

#include "reports/wording/depths.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>

#include "reports/wording/summary.h"

namespace axiscert {
namespace {

constexpr int first_column_decade = -8;  // two columns before it: zero, and all that is less
constexpr std::size_t last_column = 2 - first_column_decade - 1;

std::size_t column_of(const std::string& decade) {
  if (decade == "zero") return 0;
  if (decade == "less") return 1;
  int exponent = 0;
  std::from_chars(decade.data(), decade.data() + decade.size(), exponent);
  if (exponent < first_column_decade) return 1;
  return std::min(static_cast<std::size_t>(exponent - first_column_decade) + 2, last_column);
}

}  // namespace

const std::vector<std::string>& depth_columns() {
  static const std::vector<std::string> columns = [] {
    std::vector<std::string> names = {"zero", fmt::format("< 1e{}", first_column_decade)};
    for (int decade = first_column_decade; decade < -3; ++decade) names.push_back(fmt::format("1e{}", decade));
    for (const char* name : {"0.001", "0.01", "0.1"}) names.emplace_back(name);
    return names;
  }();
  return columns;
}

std::vector<std::uint64_t> depth_counts(const Json& decades) {
  std::vector<std::uint64_t> counts(depth_columns().size());
  for (const auto& [decade, count] : decades.items()) counts[column_of(decade)] += count.get<std::uint64_t>();
  return counts;
}

bool has_depths(const Json& family) {
  return !family.empty() && family["verdict"].contains("depths") && !family["verdict"]["depths"].is_null();
}

std::string depths_text(const Json& decades) {
  std::vector<std::string> parts;
  const std::vector<std::uint64_t> counts = depth_counts(decades);
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] != 0) parts.push_back(fmt::format("{}: {}", depth_columns()[i], thousands(counts[i])));
  }
  return parts.empty() ? "none" : fmt::format("{}", fmt::join(parts, ", "));
}

std::string engine_text(const Json& family) {
  if (!family["verdict"].contains("engine_like") || family["verdict"]["engine_like"].is_null()) return "";
  const Json& engine = family["verdict"]["engine_like"];
  const auto count = [&](const char* member) { return thousands(engine[member].get<std::uint64_t>()); };
  return fmt::format("{} missed and {} phantom contacts on {} engine-like queries", count("false_separation"),
                     count("false_contact"), count("queries"));
}

std::string bias_text(const Json& family) {
  const Json &verdict = family["verdict"], &radius = family["critical_radius"];
  const auto missed = verdict["false_separation"].get<std::uint64_t>();
  const auto phantom = verdict["false_contact"].get<std::uint64_t>();
  std::vector<std::string> parts;
  const auto ratio = [](std::uint64_t more, std::uint64_t less) {
    return amount(static_cast<double>(more) / static_cast<double>(less), 2);
  };
  if (missed != 0 && phantom != 0) {
    parts.push_back(phantom >= missed ? fmt::format("{} phantom contacts for each missed one", ratio(phantom, missed))
                                      : fmt::format("{} missed contacts for each phantom one", ratio(missed, phantom)));
  } else if (missed + phantom != 0) {
    parts.push_back(missed != 0 ? "missed contacts alone" : "phantom contacts alone");
  }
  if (radius.contains("early") && radius["sampled"] != 0) {
    const auto count = [&](const char* member) { return thousands(radius[member].get<std::uint64_t>()); };
    std::string text =
        fmt::format("critical radius early on {}, late on {} of {}", count("early"), count("late"), count("sampled"));
    if (!radius["signed_median_ulps"].is_null())
      text += fmt::format(", signed median {:+.3g} ulps", radius["signed_median_ulps"].get<double>());
    parts.push_back(text);
  }
  return fmt::format("{}", fmt::join(parts, "; "));
}

}  // namespace axiscert

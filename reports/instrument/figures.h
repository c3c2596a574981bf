// The format of figures that several instruments show, and how much an instrument looked at, in words.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "fuzz/instruments/extreme.h"
#include "fuzz/queries/source.h"
#include "fuzz/record/looked_at.h"
#include "fuzz/text/values.h"
#include "reports/wording/summary.h"

namespace axiscert {
// Errors of the smallest radius that a kernel calls a contact.
struct RadiusSummary {
  std::uint64_t sampled = 0;
  std::optional<double> median_ulps, largest_ulps;
  std::uint64_t unbounded = 0;

  static constexpr std::string_view about = "The smallest radius that the kernel calls a contact.";
  AXISCERT_FIELDS(RadiusSummary, AXISCERT_FIELD(sampled, "Triangles that were measured."),
                  AXISCERT_FIELD(median_ulps, "The median error of the critical radius, in ulps of the exact distance.",
                                 "ulps"),
                  AXISCERT_FIELD(largest_ulps, "The greatest.", "ulps"),
                  AXISCERT_FIELD(unbounded, "Triangles for which no radius is a contact."))
};
inline RadiusSummary radius_summary(const std::vector<double>& ascending, std::uint64_t unbounded) {
  const auto at = [&](std::size_t i) { return ascending.empty() ? std::nullopt : std::optional(ascending[i]); };
  return {ascending.size() + unbounded, at((ascending.size() - 1) / 2), at(ascending.size() - 1), unbounded};
}

// The number to four significant digits.
inline std::string shown(const Decimal6& decimal) {
  const double value = decimal.value();
  return std::isfinite(value) ? amount(value, 4) : decimal.text();
}

// The origin of an instrument's queries, for their addresses.
struct QueryOrigin {
  std::uint64_t seed;
  Precision precision;

  std::string address(const Source& source, std::uint64_t position) const {
    return text(address_of(source, seed, precision, position));
  }
};

// How much an instrument looked at, in words.

// "44 declined, 2 called invalid, 7 without an answer, 2,655 outside its limits, 3 not valid": those that show
// nothing; empty where there are none. A decline that the kernel does not declare is called so.
inline std::string not_decided_text(const LookedAt& looked_at, bool may_decline) {
  std::vector<std::string> parts =
      no_verdict_words({looked_at.undecided, looked_at.invalid, looked_at.unanswered},
                       may_decline ? "declined" : "declined, which it does not declare that it may");
  add_count(parts, looked_at.outside_limits, "outside its limits");
  add_count(parts, looked_at.no_query, "not valid");
  return fmt::format("{}", fmt::join(parts, ", "));
}

// "1,234 of 1,300 decided, 66 declined".
inline std::string looked_at_text(const LookedAt& looked_at, bool may_decline) {
  std::string text = fmt::format("{} of {} decided", thousands(looked_at.decided), thousands(looked_at.asked()));
  if (const std::string others = not_decided_text(looked_at, may_decline); !others.empty()) text += ", " + others;
  return text;
}

// The sentence about answers that no kernel may give to a query within its limits; empty where there are none.
inline std::string faults_text(const LookedAt& looked_at, bool may_decline) {
  const std::uint64_t faults = looked_at.faults(may_decline);
  if (faults == 0) return "";
  std::string text = fmt::format("Fault: no verdict on {} valid {} within its limits.", thousands(faults),
                                 faults == 1 ? "query" : "queries");
  if (looked_at.first_fault) {
    text += fmt::format(" The first, {}: {}", name(looked_at.first_fault->said), looked_at.first_fault->query);
  }
  return text;
}

}  // namespace axiscert

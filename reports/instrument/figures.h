// The format of figures that several instruments show.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "fuzz/fields/json_form.h"
#include "fuzz/queries/address.h"
#include "fuzz/instruments/extreme.h"
#include "reports/wording/summary.h"

namespace axiscert {

// Errors of the smallest radius that a kernel calls a contact.
struct RadiusSummary {
  std::uint64_t sampled = 0;
  std::optional<double> median_ulps, largest_ulps;
  std::uint64_t unbounded = 0;

  static constexpr std::string_view about = "The smallest radius that the kernel calls a contact.";
  static constexpr auto fields(auto&& visit) {
    using Of = RadiusSummary;
    return visit(
        field(&Of::sampled, {"sampled", "Triangles that were measured."}),
        field(&Of::median_ulps,
              {"median_ulps", "The median error of the critical radius, in ulps of the exact distance.", "ulps"}),
        field(&Of::largest_ulps, {"largest_ulps", "The greatest.", "ulps"}),
        field(&Of::unbounded, {"unbounded", "Triangles for which no radius is a contact."}));
  }
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

}  // namespace axiscert

// The distance from zero of the exact margins of a kernel's comparisons, on the scale on which its rounding errors are
// measured: a finite comparison has the wrong sign only if its error is no less than its margin.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string_view>

#include "fuzz/text/values.h"
#include "kernel/sphere_triangle/names.h"

namespace axiscert {

struct ComparisonTally;
struct ExactComparison;
struct ExactSides;

// Margins are measured on the first queries of each source, however the others are decided: this few are cheap, and the
// first ones are the same for any number of threads and shards and with any filters.
inline constexpr std::uint64_t margin_queries = 32;
constexpr bool has_margins(std::uint64_t position) { return position < margin_queries; }

// The k with 2^k < |l - r| / (u (|l| + |r|)) <= 2^(k+1), exactly, for exact sides l and r and u = 2^-24 or 2^-53
// depending on Real; least_margin_exponent also represents all smaller exponents. `tied_margin` if l = r; empty if l or
// r is undefined.
inline constexpr int least_margin_exponent = -8, greatest_margin_exponent = 52;
inline constexpr int tied_margin = least_margin_exponent - 1;
template <class Real>
std::optional<int> margin_exponent(const ExactComparison& exact);

// Counts by exponent. Without zeros: empty for most units.
struct MarginCounts {
  std::map<int, std::uint64_t> by_exponent;

  void merge(const MarginCounts& other) {
    for (const auto& [exponent, count] : other.by_exponent) by_exponent[exponent] += count;
  }
  void put(auto& encoder) const { encoder.put(by_exponent); }
  void get(auto& decoder) { decoder.get(by_exponent); }
  bool operator==(const MarginCounts&) const = default;
};
template <>
struct JsonForm<MarginCounts> {
  static Json write(const MarginCounts& counts);
  static void read(const JsonPlace& place, MarginCounts& into);
  static Json schema();
};

// The counts of one comparison, according to its computed sign.
struct MarginTally {
  MarginCounts right, wrong;

  bool operator==(const MarginTally&) const = default;
  static constexpr std::string_view about =
      "Numbers of queries by exact margin |lhs - rhs| / (u (|lhs| + |rhs|)), over those of the first "
      "plan.margin_queries queries that have an answer and exact sides. A comparison with finite computed sides is "
      "wrong "
      "only where its error is no less than its margin.";
  AXISCERT_FIELDS(MarginTally,
                  AXISCERT_FIELD(right,
                                 "Queries where the kernel's comparison agrees with its formula in exact arithmetic."),
                  AXISCERT_FIELD(wrong, "Queries where it does not."))
};

// One query with a valid truth: `exact` and `computed` are the signs, each by the kernel's own strictness.
template <class Real>
void count_margins(NamedValues<ComparisonTally>& tallies, const ExactSides& sides, ComparisonBits exact,
                   ComparisonBits computed);

}  // namespace axiscert

// The distance from zero of the exact margins of a kernel's comparisons, on the scale on which its rounding errors are
// measured: a finite comparison has the wrong sign only if its error is no less than its margin.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

#include "kernel/sphere_triangle/names.h"

namespace axiscert {

struct ExactComparison;
struct ExactSides;

// Margins are measured on the first queries of each source, however the others are decided: this few are cheap, and the
// first ones are the same for any number of threads and shards and with any filters.
inline constexpr std::uint64_t margin_queries = 32;
constexpr bool has_margins(std::uint64_t position) { return position < margin_queries; }

// The k with 2^k < |l - r| / (u (|l| + |r|)) <= 2^(k+1), exactly, for exact sides l and r and u = 2^-24 or 2^-53
// depending on Real; least_margin_exponent also represents all smaller exponents. `tied_margin` if l = r; empty if l or
// r is undefined.
inline constexpr int least_margin_exponent = -8;
inline constexpr int tied_margin = least_margin_exponent - 1;
template <class Real>
std::optional<int> margin_exponent(const ExactComparison& exact);

struct MarginCount {
  std::uint64_t right = 0, wrong = 0;  // according to the computed sign
};

// Counts by comparison and exponent; the result of merging does not depend on the order. Contains no zeros: it is empty
// for most units.
class MarginTally {
 public:
  using Counts = std::map<std::pair<std::uint8_t, std::int8_t>, MarginCount>;

  void add(std::size_t comparison, int exponent, MarginCount more);
  void merge(const MarginTally& other);
  const Counts& counts() const { return counts_; }

 private:
  Counts counts_;
};

// One query with a valid truth: `exact` and `computed` are the signs, each by the kernel's own strictness.
template <class Real>
void count_margins(MarginTally& tally, const ExactSides& sides, ComparisonBits exact, ComparisonBits computed);

}  // namespace axiscert

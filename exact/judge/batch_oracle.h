// The truths of a batch of queries: those that are certain without arbitrary precision, at once.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "exact/judge/judge.h"
#include "kernel/base/enums.h"
#include "kernel/query.h"

namespace axiscert {
// The steps that decide the signs of a query, cheapest first; each step either is certain or passes the query on. A
// predicate without filters has the last alone.

enum class Step : std::uint8_t {
  lanes,     // the SIMD filter
  grid,      // integers of a few words (exact/sphere_triangle/oracles/grid_signs.h)
  wide,      // doubles with bounds and exponents of their own (exact/sphere_triangle/oracles/wide_margins.h)
  integers,  // integers of any size (exact/sphere_triangle/oracles/grid_signs.h): every valid query that gets this far
  exact,     // arbitrary precision and the geometric oracle: invalid queries, and all queries if no filter is used
};
template <>
inline constexpr std::size_t enum_count<Step> = 5;
constexpr std::string_view name(Step step) {
  constexpr EnumArray<Step, std::string_view> names = {"lanes", "grid", "wide", "integers", "exact"};
  return names[step];
}

// Planted faults of a filter, which the cross-checks have to detect.
enum class FilterFault : std::uint8_t {
  none,
  small_bound,         // bounds 2^-12 of their right size
  no_underflow_guard,  // binary64 accepted whatever its exponents
  swapped_sign,        // the sign of one comparison
  rounding_mode,       // rounding upwards, a mode that other code may have left set
};
template <>
inline constexpr std::size_t enum_count<FilterFault> = 5;
inline constexpr EnumArray<FilterFault, std::string_view> filter_fault_names = {
    "none", "small-bound", "no-underflow-guard", "swapped-sign", "rounding-mode"};

struct Kernel;

// The signs of the comparisons of formulae on a query: those that hold, with their relations, those with equal sides,
// and those whose sign the bounds of the quickest filter determine.
struct KnownSigns {
  ComparisonBits holds = 0, ties = 0, certain = 0;
};

// Serves one thread. A predicate without filters has AskedOneByOne.
template <class Real>
class BatchOracle {
 public:
  virtual ~BatchOracle() = default;
  // Finds what is certain of each query. The batch has to last as long as known() is called.
  virtual void decide(const QueryBatch<Real>& batch) = 0;
  // The truth of query `i` of the batch decided last. Empty: only its oracles know (Oracles::about).
  virtual std::optional<Truth> known(std::size_t i) const = 0;
  // The signs from which a known truth follows; empty where no filter finds them.
  virtual std::optional<KnownSigns> signs(std::size_t) const { return std::nullopt; }
  // The signs of the formulae that a kernel claims, on a query whose truth is known; empty: only its oracles have them
  // (AskedQuery::chain).
  virtual std::optional<KnownSigns> claimed(std::size_t, const Kernel&) const { return std::nullopt; }
  // Has exact arithmetic and a second opinion repeat a sample of what filters decided, by the query's position in a
  // longer sequence: one in `stride` (0: none but the hardest), and more of the hardest. Throws OracleDisagreement.
  virtual void check(std::size_t /*i*/, std::uint64_t /*position*/, std::uint64_t /*stride*/) const {}
};

template <class Real>
class AskedOneByOne final : public BatchOracle<Real> {
 public:
  void decide(const QueryBatch<Real>&) override {}
  std::optional<Truth> known(std::size_t) const override { return std::nullopt; }
};

}  // namespace axiscert

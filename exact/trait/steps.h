// The steps that decide the signs of a query, cheapest first; each step either is certain or passes the query on. A
// predicate without filters has the last alone.
#pragma once

#include <cstdint>
#include <string_view>

#include "kernel/base/enum_array.h"

namespace axiscert {

enum class Step : std::uint8_t {
  lanes,     // the SIMD filter
  grid,      // integers of a few words (exact/sphere_triangle/filters/grid_signs.h)
  wide,      // doubles with bounds and exponents of their own (exact/sphere_triangle/filters/wide_margins.h)
  integers,  // integers of any size (exact/sphere_triangle/filters/grid_signs.h): every valid query that gets this far
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

}  // namespace axiscert

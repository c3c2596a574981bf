// Steps from one form of the predicate to the next: the effect of each rewriting, and the most costly ones.
#pragma once

#include <string_view>

#include "fuzz/sphere_triangle/formulae/ladder.h"

namespace axiscert {

// Kinds of axes that are rewritten in the same way.
enum class AxisKind : std::uint8_t { plane, vertex, edge };
template <>
inline constexpr std::size_t enum_count<AxisKind> = 3;
inline constexpr std::size_t axis_kind_count = enum_count<AxisKind>;
inline constexpr EnumArray<AxisKind, std::string_view> axis_kind_names = {"plane", "vertex", "edge"};
// The axes of a kind, and their comparisons.
AxisBits axes_of_kind(AxisKind kind);
ComparisonBits comparisons_of_kind(AxisKind kind);

// The interval in which all of the axes are sound.
std::optional<ExponentWindow> common_window(const AxisWindows& windows, AxisBits axes);

// Positions among the entries.
struct LadderStep {
  std::size_t from, to;
};
// Each kernel with the one from which it was made, if both are among the entries: rung k from rung k - 1, a rung past
// the last (the reduced forms) from ladder-9 or otherwise published, a rung in another arithmetic from the rung.
std::vector<LadderStep> ladder_steps(const std::vector<LadderEntry>& entries);

// The step that worsens a figure most, among the steps that worsen it at all.
struct CostliestSteps {
  std::optional<std::size_t> sign_errors;           // the greatest increase
  std::optional<std::size_t> rounding_sign_errors;  // the same, without sign errors by range
  std::optional<std::size_t> worst_error;           // the greatest factor
  std::optional<std::size_t> range;                 // the most octaves lost
};
CostliestSteps costliest_steps(const std::vector<LadderEntry>& entries, const std::vector<LadderStep>& steps,
                               AxisKind kind);

// The positions of the entries for which no other entry is both faster and wrong less often; the fastest first. All
// entries must have `speed`.
std::vector<std::size_t> accuracy_speed_front(const std::vector<LadderEntry>& entries);

}  // namespace axiscert

// Which rewritings a form has: what two forms differ in, and the combinations of four choices that make the factorial.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "kernel/base/enums.h"
#include "kernel/formulae_list.h"
#include "kernel/kernel.h"
#include "kernel/sphere_triangle/forms/ladder.h"

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

// The kinds of axes whose operations differ: of all others the two kernels have the same bits on every query.
EnumArray<AxisKind, bool> rewritten_kinds(const Kernel& from, const Kernel& to);

// The choices of the factorial. The two of the plane are those of `division` and `root`, of the plane's comparison.
enum class Factor : std::uint8_t { frame, division, root, degree, plane_division, plane_root };
template <>
inline constexpr std::size_t enum_count<Factor> = 6;
struct FactorWords {
  std::string_view name, from, to;
};
inline constexpr EnumArray<Factor, FactorWords> factor_words = {
    FactorWords{"frame", "world", "centred"},
    {"division", "divided", "multiplied"},
    {"root", "rooted", "squared"},
    {"degree", "6", "4"},
    {"plane division", "divided", "multiplied"},
    {"plane root", "rooted", "squared"},
};

// Bit f is set where a cell has factor f's second level.
struct FactorialCell {
  Formulae formulae;
  std::uint8_t levels;
  bool has(Factor factor) const { return has_bit(levels, index_of(factor)); }
};
// The sixteen cells of the edges, then the four of the plane. The plane and the vertices of the former are the
// published ones; the vertices and edges of the latter those of ladder-0.
const std::vector<FactorialCell>& factorial_cells();
// That of a kernel in plain arithmetic, with `>`.
const FactorialCell* factorial_cell(const Kernel& kernel);
inline constexpr std::size_t edge_cell_count = 16;
constexpr bool is_of_plane(Factor factor) { return factor == Factor::plane_division || factor == Factor::plane_root; }

}  // namespace axiscert

// Forms against each other on the same queries: what one gets wrong and the other right, by clusters of queries.
#pragma once

#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "fuzz/fields/field.h"
#include "fuzz/fields/merge.h"
#include "fuzz/queries/source.h"
#include "fuzz/sphere_triangle/formulae/choices.h"
#include "fuzz/statistics/paired.h"

namespace axiscert {

// Positions among the kernels of a plan.
struct LadderStep {
  std::size_t from, to;
};
// Each kernel with the one from which it was made, if both are there: rung k from rung k - 1, a rung past the last (the
// reduced forms) from ladder-9 or otherwise published, a rung in another arithmetic from the rung.
std::vector<LadderStep> ladder_steps(const std::vector<const Kernel*>& kernels);

// What a form gets wrong: its verdict, in either direction, or signs of comparisons against its own exact ones.
enum class Figure : std::uint8_t { missed, phantom, plane_signs, vertex_signs, edge_signs };
template <>
inline constexpr std::size_t enum_count<Figure> = 5;
inline constexpr EnumArray<Figure, std::string_view> figure_names = {"missed", "phantom", "plane signs", "vertex signs",
                                                                     "edge signs"};
std::optional<AxisKind> kind_of(Figure figure);
// How many of them there are in a query: comparisons, or 1.
std::uint64_t trials_per_query(Figure figure);

enum class ContrastKind : std::uint8_t {
  step,   // from one form of the ladder to the next
  pair,   // two cells of the factorial that differ in one factor
  effect  // the main effect of a factor: all of its pairs together
};
template <>
inline constexpr std::size_t enum_count<ContrastKind> = 3;
inline constexpr EnumArray<ContrastKind, std::string_view> contrast_kind_names = {"step", "pair", "effect"};
constexpr std::string_view name(ContrastKind which) { return contrast_kind_names[which]; }

struct Contrast {
  ContrastKind kind;
  std::optional<Factor> factor;    // of a pair and an effect
  std::vector<LadderStep> pairs;   // one, but of an effect
  EnumArray<Figure, bool> counts;  // the others are 0 on every query
};
// The steps; and of kernels that are cells of the factorial their pairs, and the effect of a factor of which all pairs
// are there.
std::vector<Contrast> contrasts_of(const std::vector<const Kernel*>& kernels);

// A sum for each cluster of queries. Those of clusters that recur stay open until all queries are counted.
struct ClusterTally {
  ClusterSums sums;
  std::map<std::uint64_t, std::int64_t> open;

  ClusterSums all() const;
  bool operator==(const ClusterTally&) const = default;
  static constexpr auto fields(auto&& visit) { return merged(visit, &ClusterTally::sums, &ClusterTally::open_); }
};

}  // namespace axiscert

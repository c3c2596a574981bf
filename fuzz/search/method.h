// How the queries of a predicate are searched: for what, by which guide, and how much work each aim gets.
#pragma once

#include <memory>
#include <string>
#include <type_traits>
#include <vector>

#include "fuzz/search/guide.h"

namespace axiscert {

// The number of islands of an aim in every epoch, and the evaluations of each.
struct IslandShare {
  std::size_t islands;
  std::uint64_t evaluations;
};
inline constexpr std::size_t most_islands = 12;

// What a search has where nothing is given.
struct SearchDefaults {
  std::uint64_t evaluations;
  std::uint64_t first_queries;             // of each family in the run from which it begins
  std::vector<std::string> families = {};  // that islands start from; empty: all of the kernel's entry
};

class SearchMethod {
 public:
  virtual ~SearchMethod() = default;
  // The aims that a search can have for a kernel, restricted to the comparisons `only` unless that is empty; verdicts
  // only if `only` is empty.
  virtual std::vector<Aim> aims(const Kernel& kernel, const std::vector<std::size_t>& only) const = 0;
  // The reason for which there are none.
  virtual std::string why_no_aims(const Kernel& kernel) const = 0;
  virtual IslandShare share(const Aim& aim) const = 0;
  // A guide keeps a reference to the kernel.
  virtual std::unique_ptr<Guide<float>> guide(const Kernel& kernel, std::string_view target,
                                              std::type_identity<float>) const = 0;
  virtual std::unique_ptr<Guide<double>> guide(const Kernel& kernel, std::string_view target,
                                               std::type_identity<double>) const = 0;
  // For a goal of range: the exponent that a value of it stands for.
  virtual int exponent(Goal, Precision, double /*value*/) const { return 0; }
  virtual const SearchDefaults& defaults() const = 0;
  // What a report says of the values found.
  virtual std::vector<std::string> notes() const = 0;
};

// That of Capabilities; of a predicate that has none, by its kernels' verdicts and the oracles' depth (VerdictGuide).
const SearchMethod& search_method_of(const Predicate& predicate);

}  // namespace axiscert

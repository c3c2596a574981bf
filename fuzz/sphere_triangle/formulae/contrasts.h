// Forms against each other on the same queries: what one gets wrong and the other right, by clusters of queries.
#pragma once

#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "fuzz/queries/source.h"
#include "fuzz/record/paired.h"
#include "fuzz/sphere_triangle/formulae/choices.h"
#include "fuzz/text/field.h"
#include "fuzz/text/merge.h"

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
inline constexpr EnumArray<Figure, std::string_view> figure_names = {"missed", "phantom", "plane_signs", "vertex_signs",
                                                                     "edge_signs"};
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

// A sum for each cluster of queries. Clusters that recur stay open until all queries are counted.
class ClusterTally {
 public:
  void add(std::int64_t sum) { closed_.add(sum); }
  void add_open(std::uint64_t cluster, std::int64_t sum) {
    if (sum != 0) open_[cluster] += sum;
  }
  void merge(const ClusterTally& other);
  ClusterSums sums() const;
  bool operator==(const ClusterTally&) const = default;

 private:
  ClusterSums closed_;
  std::map<std::uint64_t, std::int64_t> open_;
};

struct ContrastTally {
  std::uint64_t only_from = 0, only_to = 0;
  ClusterTally sums;
  void merge(const ContrastTally& other);
  bool operator==(const ContrastTally&) const = default;
};

// What the forms get wrong on one query.
struct QueryErrors {
  bool missed = false, phantom = false;
  ComparisonBits signs = 0;
};

// The queries of one source.
class SourceContrasts {
 public:
  SourceContrasts() = default;
  SourceContrasts(std::size_t kernels, std::size_t contrasts) : forms_(kernels), contrasts_(contrasts) {}

  std::uint64_t queries() const { return queries_; }
  std::uint64_t clusters() const { return clusters_ + recurring_.size(); }
  // Counts of a form by itself, and of two against each other, in so many pairs.
  ClusteredTrials trials(Figure figure, std::size_t pairs = 1) const;
  ClusterSums form(std::size_t kernel, Figure figure) const { return forms_[kernel][figure].sums(); }
  PairedCounts paired(std::size_t contrast, std::size_t pairs, Figure figure) const;

  void merge(const SourceContrasts& other);
  bool operator==(const SourceContrasts&) const = default;

 private:
  friend class ContrastCounter;
  std::uint64_t queries_ = 0, clusters_ = 0;
  std::set<std::uint64_t> recurring_;
  std::vector<EnumArray<Figure, ClusterTally>> forms_;
  std::vector<EnumArray<Figure, ContrastTally>> contrasts_;
};

// Counts a batch of a source that begins and ends with a cluster, or whose clusters recur. One thread's.
class ContrastCounter {
 public:
  ContrastCounter(std::span<const Contrast> contrasts, const Source& source, Precision precision,
                  SourceContrasts& into);
  ContrastCounter(const ContrastCounter&) = delete;
  ~ContrastCounter() { close(); }
  // The errors of each kernel on a valid query; positions ascend.
  void add(std::uint64_t position, std::span<const QueryErrors> errors);

 private:
  void close();

  std::span<const Contrast> contrasts_;
  const Source& source_;
  Precision precision_;
  SourceContrasts& into_;
  std::optional<std::uint64_t> cluster_;
  std::vector<EnumArray<Figure, std::int64_t>> forms_, differences_;  // of the cluster so far
};

// The least number of queries, at least `least`, that begins and ends with a cluster of every source.
std::uint64_t block_of_whole_clusters(const std::vector<SourcePtr>& sources, std::uint64_t least);

}  // namespace axiscert

// How the queries of a predicate are searched: for what, by which guide, and how much work each aim gets.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "exact/judge/oracles.h"
#include "fuzz/queries/query_shape.h"
#include "fuzz/record/measure_fault.h"
#include "fuzz/search/moves.h"
#include "kernel/ask.h"
#include "kernel/kernel.h"
#include "kernel/predicate.h"

namespace axiscert {
// The aim of a search: the worst query for one kernel in one respect.

enum class Goal : std::uint8_t {
  // |(l^ - r^) - (l - r)| of a comparison's computed sides in u, on the queries that a proved bound is for (of
  // sphere-triangle those in the box of fuzz/sphere_triangle/search_ranges.h).
  error,
  // The same over |l| + |r|, as in the record. It is unbounded where both sides vanish.
  relative_error,
  // The exponent m of the first factor 2^m, up or down, at which a query of size 1/2 to 1 that is far from every change
  // of sign makes the comparison leave the range.
  overflow,
  underflow,
  // Depth of a wrong verdict; the length that a query has, as its radius, is the kernel's own critical one, or the
  // float below it.
  missed_contact,
  phantom_contact,
  // The kernel's critical radius relative to the exact distance, in ulps of the latter.
  critical_radius,
  // The error of a number beside the verdict.
  number,
};
template <>
inline constexpr std::size_t enum_count<Goal> = 8;
inline constexpr EnumArray<Goal, std::string_view> goal_names = {"error",           "relative_error", "overflow",
                                                                 "underflow",       "missed_contact", "phantom_contact",
                                                                 "critical_radius", "number"};
constexpr bool is_about_a_comparison(Goal goal) { return goal < Goal::missed_contact; }
constexpr bool is_about_a_verdict(Goal goal) { return goal >= Goal::missed_contact && goal < Goal::number; }
// Whether it is about what answers have beside the verdict, and may lack.
constexpr bool is_about_a_part(Goal goal) {
  return goal == Goal::error || goal == Goal::relative_error || goal == Goal::number;
}
constexpr bool is_about_range(Goal goal) { return goal == Goal::overflow || goal == Goal::underflow; }

struct Aim {
  Goal goal;
  std::size_t which = 0;  // the comparison, for the goals about one; of a number its MeasureFault
  bool operator==(const Aim&) const = default;
};
constexpr MeasureFault fault_of(const Aim& aim) { return static_cast<MeasureFault>(aim.which); }

// "error plane.radius", "missed_contact", "number left".
inline std::string name(const Aim& aim, const Predicate& predicate) {
  const std::string goal(goal_names[aim.goal]);
  if (aim.goal == Goal::number) return goal + ' ' + std::string(word(fault_of(aim)));
  return is_about_a_comparison(aim.goal) ? goal + ' ' + std::string(predicate.comparisons[aim.which].name) : goal;
}

// The guide of a search: how much of its aim a query shows, and which queries it is about.

template <class Real>
class Guide {
 public:
  explicit Guide(const QueryShape& shape) : shape_(shape) {}
  virtual ~Guide() = default;
  const QueryShape& shape() const { return shape_; }

  // Writes the score of each query, not negative; 0 if it shows nothing. It may change the queries, as the goals about
  // verdicts do: they solve each query's length. `said`: the kernel's verdict on each query as it is left.
  virtual void evaluate(const Aim& aim, QueryBatch<Real>& batch, std::vector<double>& scores,
                        std::vector<Verdict>& said) = 0;
  // The queries so far whose answers had what an aim is about (is_about_a_part), and it was compared.
  virtual std::uint64_t judged() const { return 0; }
  // Brings a query to where the aim is looked for.
  virtual void settle(Numbers<Real>& q) const = 0;
  // A step that an aim has besides the moves that all have; false where this one was not to be taken.
  virtual bool step(const Aim&, Dice&, Numbers<Real>&) const { return false; }
  // Queries that may show of another comparison what this one shows of one.
  virtual std::vector<Numbers<Real>> images(const Numbers<Real>& q) const { return {q}; }

 private:
  QueryShape shape_;
};

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

// The guide of a search in any predicate whose oracles have a depth: by the kernel's verdicts and the oracles alone.

// A query scores the depth of its wrong verdict: of floats in double where the predicate tells it, else as the oracles
// have it. Where the entry has a length, the first of them is set to where the kernel's verdict changes: to the least
// float that bisection finds in contact, or the one below it for a missed contact. So every query comes to where it is
// wrong, if it is for any length. Keeps a reference to the kernel.
template <class Real>
class VerdictGuide final : public Guide<Real> {
 public:
  VerdictGuide(const Kernel& kernel, std::string_view target);
  void evaluate(const Aim& aim, QueryBatch<Real>& batch, std::vector<double>& scores,
                std::vector<Verdict>& said) override;
  void settle(Numbers<Real>& q) const override;

 private:
  void solve_lengths(Goal goal, QueryBatch<Real>& batch);
  double score(Goal goal, const Numbers<Real>& q, Verdict said) const;

  const Kernel& kernel_;
  const Oracles& oracles_;
  Implementation<Real> implementation_;
  std::optional<std::size_t> length_;  // the column that is solved
};

}  // namespace axiscert

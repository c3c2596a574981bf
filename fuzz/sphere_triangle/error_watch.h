// The errors of a kernel's computed sides, by the filter: exact arithmetic is asked about those only that may be the
// largest, or whose side of a tolerance is not certain. What is counted and stored is exact.
#pragma once

#include <limits>
#include <string>

#include "exact/judge/side_error.h"
#include "exact/sphere_triangle/oracles/cascade.h"
#include "exact/sphere_triangle/oracles/wide_margins.h"
#include "fuzz/campaign/unit.h"
#include "fuzz/record/tally.h"
#include "kernel/formulae_list.h"

namespace axiscert {

// How an error watch looks at a query.
enum class Screening : std::uint8_t {
  skipped,        // not looked at: no truth, or counted elsewhere
  screened,       // by the watch
  cross_checked,  // counted elsewhere, exactly; what the filter says of it is kept for the cross-check
};

// A batch of which the filters have decided what they can: for each query how it is judged, by signs that a filter
// decided, or by exact arithmetic.
template <class Real>
struct DecidedBatch : MadeBatch<Real> {
  const std::vector<DecidedSigns>& signs;
  const std::vector<Screening>& screening;  // of the error watches

  // A filter decided query `i`, whether or not exact arithmetic judges it again.
  bool is_filtered(std::size_t i) const { return signs[i].step != Step::exact; }
  bool is_exact(std::size_t i) const { return screening[i] != Screening::screened; }
};

// Whether the filter knows the sides of these formulae.
constexpr bool has_filtered_errors(Formulae formulae) {
  return formulae == Formulae::published || formulae == Formulae::reduced || formulae == Formulae::reduced_along ||
         formulae == Formulae::reduced_determinant || formulae == Formulae::reduced_shared;
}

// One kernel over one unit, its batches in the order of their positions. What it borrows has to outlive it.
template <class Real>
class ErrorWatch {
 public:
  ErrorWatch(Formulae formulae, const Tolerances& tolerances, const Filter<Real>& filter,
             const StandingLeaders& standing, std::uint64_t first_position, Tally& tally);

  // `screening` by query; it differs from the batch's own for queries that the kernel did not answer. `batch` has to
  // last until the next call.
  void look(const DecidedBatch<Real>& batch, const std::vector<Screening>& screening, const Answers<Real>& computed);
  // Evaluates what is left. To be called once, after the last batch.
  void settle();

  // Compares the filter's answer about a checked query of the last batch with the exact error; returns what is wrong,
  // or nothing.
  std::string contradiction(std::size_t query, std::size_t comparison, const SideError& exact) const;

 private:
  struct Suspect {
    Query<Real> query;
    std::uint64_t position;
    Real lhs, rhs;
    double upper;
  };
  // Errors up to `passed` can no longer be the largest; the one that is, is among `suspects` or in the tally.
  struct Largest {
    double passed = 0;
    int passed_exponent = std::numeric_limits<int>::min();  // or below 2^passed_exponent: beyond binary64 too
    std::vector<Suspect> suspects;
  };

  void judge(const SuspectError& suspect);
  // Whether binary64 evaluates the whole batch without any rounding, and to the computed sides: no error but zero.
  bool is_batch_exact();
  double threshold(std::size_t comparison) const;
  // Whether a query of the batch at hand is evaluated in binary64 without any rounding, and its computed sides are
  // these.
  bool is_exactly_zero(std::size_t query, std::size_t comparison);
  // The same error, enclosed without a range: what the filter does not know of a query that leaves it.
  WideMargins::ErrorRange wide_error(const SuspectError& suspect);
  void raise_passed(std::size_t comparison);  // after what the tally has as the largest
  // The exact sides of a query of the batch at hand.
  const ExactSides& sides_of(std::size_t query);
  void settle(std::size_t comparison);

  Formulae formulae_;
  const Tolerances& tolerances_;
  Filter<Real> filter_;
  Tally& tally_;
  std::array<Largest, comparison_count> largest_;
  std::array<double, comparison_count> tolerated_;  // certainly below the tolerance; infinite without one

  // Kept from batch to batch: whether the last one was nearly all exact, so that the next may be as a whole.
  bool expects_exact_ = false;
  QueryBatch<double> widened_{1, coordinate_count};
  Answers<double> in_binary64_;

  // State for the batch at hand.
  const DecidedBatch<Real>* batch_ = nullptr;
  const std::vector<Screening>* screening_ = nullptr;
  const Answers<Real>* computed_ = nullptr;
  std::vector<ComparisonBits> failing_;  // by query, the comparisons above their tolerance
  std::vector<std::optional<ComparisonBits>>
      zero_;  // by query, the comparisons whose error is zero; none: not evaluated
  // The last queries whose exact sides were asked for: the comparisons of a vector of queries come one after the other.
  std::array<std::pair<std::size_t, std::optional<ExactSides>>, 16> sides_;
  std::array<std::pair<std::size_t, std::optional<WideMargins>>, 16> wide_;  // likewise
  bool any_failing_ = false;
  std::vector<SuspectError> suspects_, checked_;  // what the filter left of the batch; the checked ones among them
};

}  // namespace axiscert

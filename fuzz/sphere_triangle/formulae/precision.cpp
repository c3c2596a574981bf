#include "fuzz/sphere_triangle/formulae/precision.h"

#include <fmt/format.h>

#include <limits>

#include "exact/sphere_triangle/unbounded/unbounded.h"
#include "fuzz/campaign/campaign.h"
#include "fuzz/fields/merge.h"
#include "fuzz/sphere_triangle/formulae/valid_queries.h"
#include "fuzz/instruments/for_each_judged.h"

namespace axiscert {
namespace {

using enum ExponentRange;

constexpr std::size_t block = 32;  // queries; a query takes milliseconds

PrecisionTally no_precision(const PrecisionPlan& plan) {
  PrecisionTally tally;
  tally.kernels.resize(plan.kernels.size());
  for (KernelPrecision& kernel : tally.kernels) kernel.steps.resize(plan.bits.size());
  return tally;
}

void count_step(VerdictFlips& flips, Verdict found, Verdict truth) {
  flips.false_separation += found == Verdict::separated && truth == Verdict::contact;
  flips.false_contact += found == Verdict::contact && truth == Verdict::separated;
}

void count_step(PrecisionCounts& counts, const Outcome& found, const Outcome& exact, Verdict truth) {
  count_step(counts.verdict, found.verdict, truth);
  if (!exact.bits) return;
  const auto flips = static_cast<ComparisonBits>(*found.bits ^ *exact.bits);
  for (std::size_t i = 0; i < comparison_count; ++i) counts.comparisons[i] += has_bit(flips, i);
}

template <class Real>
void measure_kernel(const PrecisionPlan& plan, const Kernel& kernel, const Query<Real>& q, const Outcome& exact,
                    Verdict truth, KernelPrecision& out) {
  count_step(out.exact, exact.verdict, truth);
  for (std::size_t i = 0; i < plan.bits.size(); ++i) {
    const BothRanges found =
        at_precision_in_both_ranges(formulae_of(kernel), kernel.strictness, q, plan.bits[i], plan.precision);
    if (plan.bits[i] == std::numeric_limits<Real>::digits) {
      const Outcome reference = axiscert::reference(formulae_of(kernel), Arithmetic::plain, kernel.strictness, q);
      if (!(found.limited == reference)) {
        throw HarnessFault(
            fmt::format("kernel {}: MPFR at {} bits with the exponents of {} is not the scalar reference", kernel.id,
                        plan.bits[i], name(plan.precision)));
      }
    }
    PrecisionStep& step = out.steps[i];
    count_step(step.unlimited, found.unlimited, exact, truth);
    count_step(step.limited, found.limited, exact, truth);
    step.rounding += found.unlimited.verdict != exact.verdict;
    step.range += found.limited.verdict != found.unlimited.verdict;
  }
}

template <class Real>
void measure_batch(const PrecisionPlan& plan, JudgedBatch<Real>& batch, PrecisionTally& tally) {
  for_each_valid(batch, [&](std::size_t, AskedSphereTriangle<Real>& asked) {
    const Query<Real>& q = asked.query();
    ++tally.queries;
    for (std::size_t k = 0; k < plan.kernels.size(); ++k) {
      const Kernel& kernel = *plan.kernels[k];
      const ExactSides* own = asked.sides(kernel);
      const Outcome exact = own ? outcome_of(own->holding(nonstrict_comparisons(kernel.strictness)))
                                : Outcome{exact_verdict(formulae_of(kernel), q), std::nullopt};
      measure_kernel(plan, kernel, q, exact, asked.truth().verdict, tally.kernels[k]);
    }
  });
}

using PrecisionTallies = std::vector<PrecisionTally>;  // by source

template <class Real>
PrecisionTallies measure_sources(const PrecisionPlan& plan, const ShowProgress& report) {
  JudgedPlan judged = judged_plan(plan.sources, plan.trials, plan.seed, block, plan.threads);
  judged.second_opinion_stride = second_opinion_stride;
  const auto visit = [&](JudgedBatch<Real>& batch, PrecisionTallies& tallies) {
    measure_batch(plan, batch, tallies[batch.source_index()]);
  };
  const PrecisionTallies none(plan.sources.size(), no_precision(plan));
  return for_each_judged<Real>(judged, none, report, {}, visit, axiscert::merge<PrecisionTallies>).counts;
}

// The least number of bits from which on `flips` counts none.
template <class Flips>
std::optional<int> sufficient(const PrecisionPlan& plan, const KernelPrecision& kernel, Flips&& flips) {
  std::optional<int> least;
  for (std::size_t i = plan.bits.size(); i-- > 0;) {
    if (flips(kernel.steps[i]) != 0) break;
    least = plan.bits[i];
  }
  return least;
}

}  // namespace

std::vector<int> default_precision_bits() {
  return {8, 10, 11, 12, 14, 16, 18, 20, 22, 24, 26, 28, 32, 36, 40, 44, 48, 53, 64, 80, 96, 113, 128, 160, 192, 256};
}

std::vector<PrecisionTally> measure_precision(const PrecisionPlan& plan, const ShowProgress& report) {
  for (const Kernel* kernel : plan.kernels) {
    if (formulae_of(*kernel) == Formulae::none || kernel->arithmetic != Arithmetic::plain) {
      throw Error(
          fmt::format("kernel {}: claims no formulae in plain arithmetic, so there is nothing to evaluate at "
                      "another precision",
                      kernel->id));
    }
  }
  return plan.precision == Precision::binary32 ? measure_sources<float>(plan, report)
                                               : measure_sources<double>(plan, report);
}

PrecisionTally total(const std::vector<PrecisionTally>& tallies) {
  PrecisionTally sum = tallies.front();
  for (std::size_t i = 1; i < tallies.size(); ++i) merge_fields(sum, tallies[i]);
  return sum;
}

SufficientVerdictBits sufficient_verdict_bits(const PrecisionPlan& plan, const KernelPrecision& kernel) {
  return {sufficient(plan, kernel, [](const PrecisionStep& step) { return step.in(unlimited).verdict.total(); }),
          sufficient(plan, kernel, [](const PrecisionStep& step) { return step.rounding; })};
}

std::optional<int> sufficient_bits(const PrecisionPlan& plan, const KernelPrecision& kernel, ComparisonBits which) {
  return sufficient(plan, kernel, [which](const PrecisionStep& step) {
    std::uint64_t flips = 0;
    for_each_bit(which, [&](std::size_t i) { flips += step.in(unlimited).comparisons[i]; });
    return flips;
  });
}

}  // namespace axiscert

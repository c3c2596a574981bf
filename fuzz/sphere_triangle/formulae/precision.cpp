#include "fuzz/sphere_triangle/formulae/precision.h"

#include <fmt/format.h>

#include <bit>
#include <limits>

#include "exact/sphere_triangle/unbounded.h"
#include "fuzz/campaign/campaign.h"
#include "fuzz/text/merge.h"
#include "fuzz/sphere_triangle/formulae/valid_queries.h"
#include "fuzz/instruments/for_each_judged.h"
#include "kernel/base/split_mix.h"

namespace axiscert {
namespace {

using enum ExponentRange;

constexpr std::size_t block = 32;  // queries; a query takes milliseconds

PrecisionTally no_precision(const PrecisionPlan& plan) {
  PrecisionTally tally;
  tally.kernels.resize(plan.kernels.size());
  for (KernelPrecision& kernel : tally.kernels) kernel.steps.resize(plan.step_count());
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

// The arithmetic whose scalar reference a step has to agree with, in the format of the queries; empty: there is none.
std::optional<Arithmetic> same_arithmetic(const PrecisionPlan& plan, std::size_t step, Formulae formulae) {
  const NumberFormat& number = plan.number_of(step);
  const ExponentLimits own = plan.precision;
  const bool is_own = plan.precision == Precision::binary32 ? number.bits == std::numeric_limits<float>::digits
                                                            : number.bits == std::numeric_limits<double>::digits;
  if (!is_own || number.exponents.value_or(own) != own) return std::nullopt;
  if (plan.contraction == Contraction::dots) {
    return plan.rounding == RoundingRule::nearest ? std::optional(Arithmetic::fma) : std::nullopt;
  }
  if (plan.rounding == RoundingRule::nearest) return Arithmetic::plain;
  if (kind_of(formulae) != FormulaeKind::rung) return std::nullopt;
  switch (plan.rounding) {
    case RoundingRule::up:
      return Arithmetic::up;
    case RoundingRule::down:
      return Arithmetic::down;
    case RoundingRule::zero:
      return Arithmetic::chop;
    case RoundingRule::nearest:
    case RoundingRule::faithful:
    case RoundingRule::stochastic:
      return std::nullopt;
  }
  return std::nullopt;
}

// A seed for the numbers of a query: the same at every position of every source.
template <class Real>
std::uint64_t chance_seed(std::uint64_t seed, const Query<Real>& q) {
  std::uint64_t hash = seed;
  for (const double x : coordinates(widened(q))) hash = mixed(hash + (golden_gamma ^ std::bit_cast<std::uint64_t>(x)));
  return hash;
}

// A query, and all that is known of it before its formulae are rounded.
template <class Real>
struct PrecisionQuery {
  Query<Real> query;
  std::vector<Outcome> exact;  // of each kernel's formulae
  Verdict truth;

  PrecisionQuery(const PrecisionPlan& plan, AskedSphereTriangle<Real>& asked)
      : query(asked.query()), truth(asked.truth().verdict) {
    for (const Kernel* kernel : plan.kernels) {
      const ExactSides* own = asked.sides(*kernel);
      exact.push_back(own ? outcome_of(own->holding(nonstrict_comparisons(kernel->strictness)))
                          : Outcome{exact_verdict(formulae_of(*kernel), query), std::nullopt});
    }
  }
};

template <class Real>
void measure_step(const PrecisionPlan& plan, std::size_t step, const PrecisionQuery<Real>& known,
                  PrecisionTally& tally) {
  const Query<Real>& q = known.query;
  const NumberFormat& number = plan.number_of(step);
  const std::optional<std::uint64_t> seed = plan.seed_of(step);
  const FloatingFormat format = floating(number, plan.rounding, plan.precision, seed ? chance_seed(*seed, q) : 0);
  for (std::size_t k = 0; k < plan.kernels.size(); ++k) {
    const Kernel& kernel = *plan.kernels[k];
    const Formulae formulae = formulae_of(kernel);
    const Outcome& exact = known.exact[k];
    const BothRanges found = in_both_ranges(formulae, kernel.strictness, q, format, plan.contraction);
    if (const auto arithmetic = same_arithmetic(plan, step, formulae)) {
      if (!(found.limited == axiscert::reference(formulae, *arithmetic, kernel.strictness, q))) {
        throw HarnessFault(fmt::format("kernel {}: MPFR in {} is not the scalar reference in {}", kernel.id,
                                       number.name, name(plan.precision)));
      }
    }
    PrecisionStep& counts = tally.kernels[k].steps[step];
    ++counts.queries;
    count_step(counts.exact, exact.verdict, known.truth);
    count_step(counts.unlimited, found.unlimited, exact, known.truth);
    count_step(counts.limited, found.limited, exact, known.truth);
    counts.rounding += found.unlimited.verdict != exact.verdict;
    counts.range += found.limited.verdict != found.unlimited.verdict;
  }
}

template <class Real>
void measure_batch(const PrecisionPlan& plan, JudgedBatch<Real>& batch, PrecisionTally& tally) {
  for_each_valid(batch, [&](std::size_t i, AskedSphereTriangle<Real>& asked) {
    ++tally.queries;
    const PrecisionQuery<Real> known(plan, asked);
    for (std::size_t k = 0; k < plan.kernels.size(); ++k)
      count_step(tally.kernels[k].exact, known.exact[k].verdict, known.truth);
    const auto measure = [&](std::size_t number, const PrecisionQuery<Real>& query) {
      for (std::size_t s = 0; s < plan.seeds(); ++s) measure_step(plan, number * plan.seeds() + s, query, tally);
    };
    for (std::size_t n = 0; n < plan.numbers.size(); ++n) {
      if (!plan.round_inputs) {
        measure(n, known);
        continue;
      }
      const FloatingFormat format = floating(plan.numbers[n], RoundingRule::nearest, plan.precision);
      const std::optional<Query<Real>> rounded = rounded_to(known.query, format);
      if (!rounded) continue;
      AskedSphereTriangle<Real> rounded_asked(*rounded, batch.opinion(i));
      measure(n, PrecisionQuery<Real>(plan, rounded_asked));
    }
  });
}

using PrecisionTallies = std::vector<PrecisionTally>;  // by source

template <class Real>
PrecisionTallies measure_sources(const PrecisionPlan& plan, const ShowProgress& report) {
  JudgedPlan judged = judged_plan(plan.sources, plan.trials, plan.seed, block, plan.threads);
  take_whole_files(judged, plan.precision);
  judged.second_opinion_stride = second_opinion_stride;
  const auto visit = [&](JudgedBatch<Real>& batch, PrecisionTallies& tallies) {
    measure_batch(plan, batch, tallies[batch.source_index()]);
  };
  const PrecisionTallies none(plan.sources.size(), no_precision(plan));
  return for_each_judged<Real>(judged, none, report, {}, visit, axiscert::merge<PrecisionTallies>).counts;
}

// The least number of bits from which on `flips` counts none, in formats that have some of the queries.
template <class Flips>
std::optional<int> sufficient(const PrecisionPlan& plan, const KernelPrecision& kernel, Flips&& flips) {
  std::optional<int> least, greater;  // greater: the bits before them in the list
  for (std::size_t i = plan.step_count(); i-- > 0;) {
    if (kernel.steps[i].queries == 0 || flips(kernel.steps[i]) != 0) {
      // Nothing is said of bits of which one step flips, or was measured on nothing.
      if (least == plan.number_of(i).bits) least = greater;
      break;
    }
    if (least != plan.number_of(i).bits) greater = least;
    least = plan.number_of(i).bits;
  }
  return least;
}

}  // namespace

std::vector<NumberFormat> default_precision_numbers() {
  std::vector<NumberFormat> numbers;
  for (const int bits :
       {8, 10, 11, 12, 14, 16, 18, 20, 22, 24, 26, 28, 32, 36, 40, 44, 48, 53, 64, 80, 96, 113, 128, 160, 192, 256})
    numbers.push_back(format_of_bits(bits));
  return numbers;
}

std::vector<PrecisionTally> measure_precision(const PrecisionPlan& plan, const ShowProgress& report) {
  for (const Kernel* kernel : plan.kernels) {
    if (formulae_of(*kernel) == Formulae::none || kernel->arithmetic != Arithmetic::plain) {
      throw Error(
          fmt::format("kernel {}: claims no formulae in plain arithmetic, so there is nothing to evaluate at "
                      "another precision",
                      kernel->id));
    }
    if (!has_contraction(formulae_of(*kernel), plan.contraction)) {
      throw Error(
          fmt::format("--contraction {}: kernel {} has no form with fused dot and cross products; the rungs "
                      "have, `axiscert kernels` lists them with their arithmetics",
                      name(plan.contraction), kernel->id));
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

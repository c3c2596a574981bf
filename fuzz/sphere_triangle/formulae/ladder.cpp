#include "fuzz/sphere_triangle/formulae/ladder.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "exact/judge/side_error.h"
#include "exact/sphere_triangle/measures/critical_radius.h"
#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "exact/sphere_triangle/unbounded.h"
#include "fuzz/campaign/campaign.h"
#include "fuzz/instruments/for_each_judged.h"
#include "fuzz/sphere_triangle/formulae/valid_queries.h"
#include "fuzz/text/merge.h"
#include "kernel/formulae_list.h"

namespace axiscert {
namespace {

// Source by source, the kernels in each; and what they get wrong, by source.
struct LadderCounts {
  std::vector<KernelAccuracy> accuracies;
  std::vector<SourceContrasts> contrasts;
  static constexpr auto fields(auto&& visit) {
    return merged(visit, &LadderCounts::accuracies, &LadderCounts::contrasts);
  }
};

void count_verdict(KernelAccuracy& into, const Truth& truth, Verdict verdict, QueryErrors& errors) {
  const bool is_wrong = verdict != truth.verdict;
  errors.missed = is_wrong && verdict == Verdict::separated;
  errors.phantom = is_wrong && !errors.missed;
  ++into.queries;
  into.false_separation += errors.missed;
  into.false_contact += errors.phantom;
  into.touching_flips += is_wrong && truth.touching;
}

// Those of the flips that range alone explains: the reference has them too, but an unbounded exponent does not.
template <class Real>
ComparisonBits flips_by_range(ComparisonBits flips, const Kernel& kernel, ComparisonBits exact, const Query<Real>& q) {
  if (flips == 0) return 0;
  const RoundedDecisions found = rounded(formulae_of(kernel), kernel.arithmetic, kernel.strictness, q);
  return static_cast<ComparisonBits>(flips & (*found.reference.bits ^ exact) & ~(*found.range_free.bits ^ exact));
}

// Returns the flips.
template <class Real>
ComparisonBits count_comparisons(KernelAccuracy& into, const Kernel& kernel, const ExactSides& sides,
                                 const Query<Real>& q, const Answers<Real>& answers, std::size_t i) {
  const ComparisonBits computed = answers.bits[i], exact = sides.holding(nonstrict_comparisons(kernel.strictness));
  const auto flips = static_cast<ComparisonBits>(computed ^ exact);
  const ComparisonBits by_range = flips_by_range(flips, kernel, exact, q);
  for (std::size_t k = 0; k < comparison_count; ++k) {
    ComparisonAccuracy& comparison = into.comparisons[k];
    if (has_bit(flips, k)) ++(has_bit(computed, k) ? comparison.false_separation : comparison.missed_separation);
    comparison.by_range += has_bit(by_range, k);
    if (kernel.exposes != Exposure::sides) continue;
    const SideError error(answers.lhs[k][i], answers.rhs[k][i], sides.comparison(k));
    switch (error.kind()) {
      case SideError::Kind::range_event:
        ++comparison.range_events;
        break;
      case SideError::Kind::without_scale:
        ++comparison.without_scale;
        break;
      case SideError::Kind::finite:
        comparison.errors.add(error);
        break;
    }
  }
  return flips;
}

template <class Real>
void count_critical_radius(KernelAccuracy& into, const Implementation<Real>& kernel, const Query<Real>& q,
                           const Rational& squared_distance) {
  const auto error = critical_radius_error(kernel, q, squared_distance).ulps;
  if (error && std::isfinite(*error)) into.radius_errors_ulps.push_back(*error);
  else if (error) ++into.radius_unbounded;
}

// `into` points to the kernels' results on the batch's source.
template <class Real>
void judge_formulae(const LadderPlan& plan, JudgedBatch<Real>& batch, KernelAccuracy* into, ContrastCounter& counter) {
  std::vector<QueryErrors> errors(plan.kernels.size());
  for_each_valid(batch, [&](std::size_t i, AskedSphereTriangle<Real>& asked) {
    const Query<Real>& q = asked.query();
    std::optional<Rational> distance;
    if (has_critical_radius(batch.position(i))) distance = squared_distance(q);
    for (std::size_t k = 0; k < plan.kernels.size(); ++k) {
      const Reply<Real>& reply = batch.reply(k);
      count_verdict(into[k], asked.truth(), reply.verdicts[i], errors[k]);
      errors[k].signs =
          count_comparisons(into[k], *plan.kernels[k], *asked.sides(*plan.kernels[k]), q, reply.answers, i);
      if (distance) count_critical_radius(into[k], batch.kernel(k), q, *distance);
    }
    counter.add(batch.position(i), errors);
  });
}

template <class Real>
LadderCounts ladder_counts(const LadderPlan& plan, const std::vector<Contrast>& contrasts, const ShowProgress& report) {
  const std::uint64_t block = block_of_whole_clusters(plan.sources, 1024);
  JudgedPlan judged = judged_plan(plan.sources, plan.trials, plan.seed, block, plan.threads);
  take_whole_files(judged, plan.precision);
  judged.kernels = plan.kernels;
  judged.second_opinion_stride = second_opinion_stride;
  const auto visit = [&](JudgedBatch<Real>& batch, LadderCounts& found) {
    const std::size_t source = batch.source_index();
    ContrastCounter counter(contrasts, batch.source(), plan.precision, found.contrasts[source]);
    judge_formulae(plan, batch, found.accuracies.data() + source * plan.kernels.size(), counter);
  };
  const LadderCounts none{
      std::vector<KernelAccuracy>(plan.sources.size() * plan.kernels.size()),
      std::vector<SourceContrasts>(plan.sources.size(), SourceContrasts(plan.kernels.size(), contrasts.size()))};
  return for_each_judged<Real>(judged, none, report, "accuracy", visit, axiscert::merge<LadderCounts>).counts;
}

template <class Real>
void measure_range_and_speed(const LadderPlan& plan, std::vector<LadderEntry>& entries, const ShowProgress& report) {
  run_on_threads(plan.threads, [&] {
    ProgressCount progress(report, entries.size(), "exponent windows");
    tbb::parallel_for(std::size_t{0}, entries.size(), [&](std::size_t k) {
      entries[k].windows = exponent_windows<Real>(*entries[k].kernel);
      progress.finish_unit();
    });
  });
  if (!plan.speed) return;
  const std::vector<KernelSpeed> speeds = measure_speed<Real>(plan.kernels, speed_repetitions, report);
  for (std::size_t k = 0; k < entries.size(); ++k) entries[k].speed = speeds[k];
}

}  // namespace

ComparisonAccuracy KernelAccuracy::of(ComparisonBits which) const {
  ComparisonAccuracy sum;
  for_each_bit(which, [&](std::size_t i) { merge_fields(sum, comparisons[i]); });
  return sum;
}

LadderResult measure_ladder(const LadderPlan& plan, const ShowProgress& report) {
  std::vector<Contrast> contrasts = contrasts_of(plan.kernels);
  LadderCounts found = plan.precision == Precision::binary32 ? ladder_counts<float>(plan, contrasts, report)
                                                             : ladder_counts<double>(plan, contrasts, report);
  std::vector<LadderEntry> entries;
  for (std::size_t k = 0; k < plan.kernels.size(); ++k) {
    LadderEntry& entry = entries.emplace_back();
    entry.kernel = plan.kernels[k];
    for (std::size_t s = 0; s < plan.sources.size(); ++s) {
      KernelAccuracy& one = found.accuracies[s * plan.kernels.size() + k];
      std::sort(one.radius_errors_ulps.begin(), one.radius_errors_ulps.end());
      merge_fields(entry.all, one);
      entry.by_source.push_back(std::move(one));
    }
    std::sort(entry.all.radius_errors_ulps.begin(), entry.all.radius_errors_ulps.end());
  }
  if (plan.precision == Precision::binary32) measure_range_and_speed<float>(plan, entries, report);
  else measure_range_and_speed<double>(plan, entries, report);
  return {std::move(entries), std::move(contrasts), std::move(found.contrasts)};
}

namespace {

double log10_of(Decimal6 error) { return std::log10(error.mantissa) + error.exponent; }

}  // namespace

std::optional<ExponentWindow> common_window(const AxisWindows& windows, AxisBits axes) {
  std::optional<ExponentWindow> common;
  for (std::size_t i = 0; i < axis_count; ++i) {
    if (!has_bit(axes, i)) continue;
    if (!windows[i]) return std::nullopt;
    if (!common) common = windows[i];
    *common = {std::max(common->low, windows[i]->low), std::min(common->high, windows[i]->high)};
  }
  return common;
}

CostliestSteps costliest_steps(const std::vector<LadderEntry>& entries, const std::vector<LadderStep>& steps,
                               AxisKind kind, std::size_t source) {
  CostliestSteps costliest;
  double most_signs = 0, most_rounding = 0, most_error = 0, most_range = 0;
  const auto take = [](std::optional<std::size_t>& place, double& most, std::size_t step, double cost) {
    if (!(cost > most)) return;
    most = cost;
    place = step;
  };
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const LadderEntry &from = entries[steps[i].from], &to = entries[steps[i].to];
    const ComparisonBits which = comparisons_of_kind(kind);
    const ComparisonAccuracy before = from.by_source[source].of(which), after = to.by_source[source].of(which);
    const auto increase = [](std::uint64_t a, std::uint64_t b) {
      return static_cast<double>(b) - static_cast<double>(a);
    };
    take(costliest.sign_errors, most_signs, i, increase(before.sign_errors(), after.sign_errors()));
    take(costliest.rounding_sign_errors, most_rounding, i,
         increase(before.rounding_sign_errors(), after.rounding_sign_errors()));
    if (!before.errors.worst().is_zero() && !after.errors.worst().is_zero()) {
      take(costliest.worst_error, most_error, i, log10_of(after.errors.worst()) - log10_of(before.errors.worst()));
    }
    const auto width = [&](const LadderEntry& entry) {
      const auto window = common_window(entry.windows, axes_of_kind(kind));
      return window ? window->width() : 0;
    };
    take(costliest.range, most_range, i, width(from) - width(to));
  }
  return costliest;
}

std::vector<std::size_t> accuracy_speed_front(const std::vector<LadderEntry>& entries) {
  const auto dominates = [](const LadderEntry& a, const LadderEntry& b) {
    const double fast_a = a.speed->scalar_ns, fast_b = b.speed->scalar_ns;
    const std::uint64_t wrong_a = a.all.verdict_flips(), wrong_b = b.all.verdict_flips();
    return fast_a <= fast_b && wrong_a <= wrong_b && (fast_a < fast_b || wrong_a < wrong_b);
  };
  std::vector<std::size_t> front;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (std::none_of(entries.begin(), entries.end(), [&](const auto& other) { return dominates(other, entries[i]); })) {
      front.push_back(i);
    }
  }
  std::stable_sort(front.begin(), front.end(), [&](std::size_t a, std::size_t b) {
    return entries[a].speed->scalar_ns < entries[b].speed->scalar_ns;
  });
  return front;
}

bool LadderResult::is_of_nothing() const {
  return std::ranges::all_of(entries, [](const LadderEntry& entry) {
    return std::ranges::all_of(entry.by_source, [](const KernelAccuracy& here) { return here.queries == 0; });
  });
}

}  // namespace axiscert

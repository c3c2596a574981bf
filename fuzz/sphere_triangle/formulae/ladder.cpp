#include "fuzz/sphere_triangle/formulae/ladder.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "exact/sphere_triangle/measures/critical_radius.h"
#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "exact/sphere_triangle/unbounded/unbounded.h"
#include "exact/trait/side_error.h"
#include "fuzz/campaign/campaign.h"
#include "fuzz/fields/merge.h"
#include "fuzz/instruments/for_each_judged.h"
#include "fuzz/sphere_triangle/formulae/valid_queries.h"
#include "kernel/formulae_list.h"

namespace axiscert {
namespace {

using Accuracies = std::vector<KernelAccuracy>;  // source by source, the kernels in each

void count_verdict(KernelAccuracy& into, const Truth& truth, Verdict verdict) {
  ++into.queries;
  if (verdict == truth.verdict) return;
  ++(verdict == Verdict::separated ? into.false_separation : into.false_contact);
  into.touching_flips += truth.touching;
}

// Those of the flips that range alone explains: the reference has them too, but an unbounded exponent does not.
template <class Real>
ComparisonBits flips_by_range(ComparisonBits flips, const Kernel& kernel, ComparisonBits exact, const Query<Real>& q) {
  if (flips == 0) return 0;
  const RoundedDecisions found = rounded(formulae_of(kernel), kernel.arithmetic, kernel.strictness, q);
  return static_cast<ComparisonBits>(flips & (*found.reference.bits ^ exact) & ~(*found.range_free.bits ^ exact));
}

template <class Real>
void count_comparisons(KernelAccuracy& into, const Kernel& kernel, const ExactSides& sides, const Query<Real>& q,
                       const Answers<Real>& answers, std::size_t i) {
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
void judge_formulae(const LadderPlan& plan, JudgedBatch<Real>& batch, KernelAccuracy* into) {
  for_each_valid(batch, [&](std::size_t i, AskedSphereTriangle<Real>& asked) {
    const Query<Real>& q = asked.query();
    std::optional<Rational> distance;
    if (has_critical_radius(batch.position(i))) distance = squared_distance(q);
    for (std::size_t k = 0; k < plan.kernels.size(); ++k) {
      const Reply<Real>& reply = batch.reply(k);
      count_verdict(into[k], asked.truth(), reply.verdicts[i]);
      count_comparisons(into[k], *plan.kernels[k], *asked.sides(*plan.kernels[k]), q, reply.answers, i);
      if (distance) count_critical_radius(into[k], batch.kernel(k), q, *distance);
    }
  });
}

template <class Real>
Accuracies accuracies(const LadderPlan& plan, const ShowProgress& report) {
  JudgedPlan judged = judged_plan(plan.sources, plan.trials, plan.seed, 1024, plan.threads);
  take_whole_files(judged, plan.precision);
  judged.kernels = plan.kernels;
  judged.second_opinion_stride = second_opinion_stride;
  const auto visit = [&](JudgedBatch<Real>& batch, Accuracies& found) {
    judge_formulae(plan, batch, found.data() + batch.source_index() * plan.kernels.size());
  };
  const Accuracies none(plan.sources.size() * plan.kernels.size());
  return for_each_judged<Real>(judged, none, report, "accuracy", visit, axiscert::merge<Accuracies>).counts;
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

std::vector<LadderEntry> measure_ladder(const LadderPlan& plan, const ShowProgress& report) {
  Accuracies found =
      plan.precision == Precision::binary32 ? accuracies<float>(plan, report) : accuracies<double>(plan, report);
  std::vector<LadderEntry> entries;
  for (std::size_t k = 0; k < plan.kernels.size(); ++k) {
    LadderEntry& entry = entries.emplace_back();
    entry.kernel = plan.kernels[k];
    for (std::size_t s = 0; s < plan.sources.size(); ++s) {
      KernelAccuracy& one = found[s * plan.kernels.size() + k];
      std::sort(one.radius_errors_ulps.begin(), one.radius_errors_ulps.end());
      merge_fields(entry.all, one);
      entry.by_source.push_back(std::move(one));
    }
    std::sort(entry.all.radius_errors_ulps.begin(), entry.all.radius_errors_ulps.end());
  }
  if (plan.precision == Precision::binary32) measure_range_and_speed<float>(plan, entries, report);
  else measure_range_and_speed<double>(plan, entries, report);
  return entries;
}

namespace {

// The formulae from which a set of formulae was rewritten, the nearest first.
std::vector<Formulae> origins(Formulae formulae) {
  using enum Formulae;
  if (formulae == none) return {};
  switch (formulae) {
    case ladder_1:
    case ladder_2:
    case ladder_3:
    case ladder_4:
    case ladder_5:
    case ladder_6:
    case ladder_7:
    case ladder_8:
    case ladder_9:
      return {static_cast<Formulae>(static_cast<int>(formulae) - 1)};
    case published:
    case ladder_0:
      return {};
    default:
      if (kind_of(formulae) != FormulaeKind::rung) return {};
      return {ladder_9, published};
  }
}

std::optional<std::size_t> find(const std::vector<LadderEntry>& entries, Formulae formulae, Arithmetic arithmetic,
                                Strictness strictness) {
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const Kernel& kernel = *entries[i].kernel;
    if (formulae_of(kernel) == formulae && kernel.arithmetic == arithmetic && kernel.strictness == strictness) return i;
  }
  return std::nullopt;
}

double log10_of(Decimal6 error) { return std::log10(error.mantissa) + error.exponent; }

}  // namespace

AxisBits axes_of_kind(AxisKind kind) {
  constexpr EnumArray<AxisKind, AxisBits> axes = {0b0000001, 0b0001110, 0b1110000};
  return axes[kind];
}

ComparisonBits comparisons_of_kind(AxisKind kind) {
  ComparisonBits bits = 0;
  for_each_bit(axes_of_kind(kind), [&](std::size_t axis) { bits |= axis_comparisons[axis]; });
  return bits;
}

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

std::vector<LadderStep> ladder_steps(const std::vector<LadderEntry>& entries) {
  std::vector<LadderStep> steps;
  for (std::size_t to = 0; to < entries.size(); ++to) {
    const Kernel& kernel = *entries[to].kernel;
    std::optional<std::size_t> from;
    if (kernel.arithmetic != Arithmetic::plain) {
      from = find(entries, formulae_of(kernel), Arithmetic::plain, kernel.strictness);
    } else {
      for (const Formulae origin : origins(formulae_of(kernel))) {
        if (!from) from = find(entries, origin, kernel.arithmetic, kernel.strictness);
      }
    }
    if (from) steps.push_back({*from, to});
  }
  return steps;
}

CostliestSteps costliest_steps(const std::vector<LadderEntry>& entries, const std::vector<LadderStep>& steps,
                               AxisKind kind) {
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
    const ComparisonAccuracy before = from.all.of(which), after = to.all.of(which);
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

}  // namespace axiscert

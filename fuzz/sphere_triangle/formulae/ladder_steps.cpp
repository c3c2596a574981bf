#include "fuzz/sphere_triangle/formulae/ladder_steps.h"
#include "kernel/formulae_list.h"

#include <algorithm>
#include <cmath>

namespace axiscert {
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

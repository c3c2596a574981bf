#include "fuzz/sphere_triangle/error_watch.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cfenv>
#include <cmath>
#include <limits>

#include "exact/judge/side_error.h"
#include "exact/sphere_triangle/oracles/vertex_sides.h"
#include "kernel/sphere_triangle/forms/scalar.h"
#include "kernel/sphere_triangle/forms/simd.h"

namespace axiscert {
namespace {

// A double that is certainly not above the number it was rounded from.
constexpr double below_the_rounding = 1 - 0x1p-50;

constexpr std::size_t most_suspects = 64;

// Whatever is no greater comes to no greater a decimal. Decimals beyond binary64 are compared exactly, each of them.
double passed_by(const Decimal6& decimal) {
  return std::min(decimal.value(), std::numeric_limits<double>::max()) * below_the_rounding;
}

// The decimal is more than twice as much as any number below 2^exponent, so no rounding makes the two the same. A
// decimal is at least 2^n for n = floor(log2(mantissa)) + floor(3.3219 exponent), since 10 > 2^3.3219.
int passed_exponent_by(const Decimal6& decimal) {
  if (decimal.is_zero() || decimal.exponent < 0) return std::numeric_limits<int>::min();
  return std::bit_width(decimal.mantissa) - 1 + static_cast<int>(std::int64_t{decimal.exponent} * 33219 / 10000) - 1;
}

}  // namespace

template <class Real>
ErrorWatch<Real>::ErrorWatch(Formulae formulae, const Tolerances& tolerances, const Filter<Real>& filter,
                             const StandingLeaders& standing, std::uint64_t first_position, Tally& tally)
    : formulae_(formulae), tolerances_(tolerances), filter_(filter), tally_(tally) {
  for (std::size_t k = 0; k < comparison_count; ++k) {
    tolerated_[k] = tolerances[k] ? tolerances[k]->get_d() * below_the_rounding : INFINITY;
    const auto& known = standing.largest_error[k].candidates();
    if (known.empty()) continue;
    // The same error at an earlier position would take the place of a known one.
    largest_[k].passed = passed_by(known[0].rank) * (known[0].position < first_position ? 1 : Decimal6::least_ratio);
    largest_[k].passed_exponent = passed_exponent_by(known[0].rank);
  }
}

template <class Real>
void ErrorWatch<Real>::look(const DecidedBatch<Real>& batch, const std::vector<Screening>& screening,
                            const Answers<Real>& computed) {
  batch_ = &batch;
  screening_ = &screening;
  computed_ = &computed;
  checked_.clear();
  failing_.assign(batch.size(), 0);
  any_failing_ = false;
  if (expects_exact_ && is_batch_exact()) return;
  zero_.assign(batch.size(), std::nullopt);
  for (auto& [query, sides] : sides_) sides.reset();
  for (auto& [query, margins] : wide_) margins.reset();
  ErrorThresholds thresholds;
  for (std::size_t k = 0; k < comparison_count; ++k) thresholds[k] = threshold(k);
  suspects_.clear();
  filter_.errors(batch.queries.columns(), computed, formulae_ != Formulae::published, thresholds, suspects_);
  for (const SuspectError& suspect : suspects_) {
    // An earlier suspect of the batch may have raised the threshold.
    if (suspect.upper > threshold(suspect.comparison)) judge(suspect);
  }
  constexpr auto all = ComparisonBits{0xffff};
  expects_exact_ =
      std::count(zero_.begin(), zero_.end(), std::optional(all)) > static_cast<std::ptrdiff_t>(batch.size() / 2);
  if (!any_failing_) return;
  for (const ComparisonBits failing : failing_) {
    for (std::size_t i = 0; i < axis_count; ++i)
      *tally_.axes[i].tolerance_failures += (failing & axis_comparisons[i]) != 0;
  }
}

template <class Real>
bool ErrorWatch<Real>::is_batch_exact() {
  const SimdForms* forms = simd_forms(formulae_);
  if (!forms) return false;
  const auto columns = batch_->queries.columns();
  if (widened_.capacity() < columns.size) widened_ = QueryBatch<double>(columns.size, coordinate_count);
  widened_.resize(columns.size);
  const auto wide = widened_.mutable_columns();
  for (std::size_t k = 0; k < coordinate_count; ++k) {
    std::copy_n(columns.column[k], columns.size, wide.column[k]);
  }
  in_binary64_.resize(columns.size, comparison_count);
  constexpr int events = FE_INEXACT | FE_OVERFLOW | FE_UNDERFLOW;
  std::feclearexcept(events);
  forms->on<double>(simd_targets().front(), Strictness::strict).explain(widened_.columns(), in_binary64_);
  if (std::fetestexcept(events) != 0) return false;
  const auto is_same = [](const auto& ours, const auto& theirs) {
    return std::equal(theirs.begin(), theirs.end(), ours.begin(), [](double x, Real y) { return x == y; });
  };
  for (std::size_t k = 0; k < comparison_count; ++k) {
    if (!is_same(computed_->lhs[k], in_binary64_.lhs[k]) || !is_same(computed_->rhs[k], in_binary64_.rhs[k]))
      return false;
  }
  return true;
}

template <class Real>
double ErrorWatch<Real>::threshold(std::size_t comparison) const {
  return std::min(largest_[comparison].passed, tolerated_[comparison]);
}

template <class Real>
bool ErrorWatch<Real>::is_exactly_zero(std::size_t i, std::size_t comparison) {
  if (!zero_[i]) {
    constexpr int events = FE_INEXACT | FE_OVERFLOW | FE_UNDERFLOW;
    Sides<double> sides;
    std::feclearexcept(events);
    reference(formulae_, Arithmetic::plain, Strictness::strict, widened(batch_->queries[i]), &sides);
    const bool is_exact = std::fetestexcept(events) == 0;
    zero_[i] = 0;
    for (std::size_t k = 0; k < comparison_count && is_exact; ++k) {
      const bool is_same = computed_->lhs[k][i] == sides.lhs[k] && computed_->rhs[k][i] == sides.rhs[k];
      *zero_[i] |= bit_if<ComparisonBits>(is_same, k);
    }
  }
  return has_bit(*zero_[i], comparison);
}

template <class Real>
const ExactSides& ErrorWatch<Real>::sides_of(std::size_t i) {
  auto& [query, sides] = sides_[i % sides_.size()];
  if (!sides || query != i) {
    query = i;
    sides = exact_sides(formulae_, query_from(batch_->queries[i]));
  }
  return *sides;
}

template <class Real>
WideMargins::ErrorRange ErrorWatch<Real>::wide_error(const SuspectError& suspect) {
  const auto [i, k, lower, upper] = suspect;
  auto& [query, margins] = wide_[i % wide_.size()];
  if (!margins || query != i) {
    query = i;
    margins.emplace(widened(batch_->queries[i]));
  }
  const EdgeSides sides = formulae_ == Formulae::published ? EdgeSides::published : EdgeSides::reduced;
  auto range = margins->error(static_cast<Comparison>(k), sides, computed_->lhs[k][i], computed_->rhs[k][i],
                              std::numeric_limits<Real>::digits);
  range.lower = std::max(range.lower, lower);
  range.upper = std::min(range.upper, upper);
  return range;
}

template <class Real>
void ErrorWatch<Real>::raise_passed(std::size_t k) {
  const Decimal6 best = tally_.comparisons[k].largest_error.best();
  largest_[k].passed = std::max(largest_[k].passed, passed_by(best));
  largest_[k].passed_exponent = std::max(largest_[k].passed_exponent, passed_exponent_by(best));
}

template <class Real>
void ErrorWatch<Real>::judge(const SuspectError& suspect) {
  auto [i, k, lower, upper] = suspect;
  if ((*screening_)[i] == Screening::skipped) return;
  const Real lhs = computed_->lhs[k][i], rhs = computed_->rhs[k][i];
  if ((*screening_)[i] == Screening::cross_checked) {
    checked_.push_back(suspect);
    if (std::isfinite(lhs) && std::isfinite(rhs) && upper > 2 * lower) {
      const WideMargins::ErrorRange range = wide_error(suspect);
      checked_.push_back({i, k, range.lower, range.upper});
    }
    return;
  }
  ComparisonTally& comparison = tally_.comparisons[k];
  if (!std::isfinite(lhs) || !std::isfinite(rhs)) {
    ++*comparison.range_events;
    return;
  }
  if (!std::isfinite(upper) && has_bit(both_sides_zero(batch_->signs[i].signs), k)) {
    *comparison.error_without_scale += lhs != rhs;  // any difference is over |0| + |0|
    return;
  }
  if (lower == 0 && is_exactly_zero(i, k)) return;
  if (upper > 2 * lower) {
    const WideMargins::ErrorRange range = wide_error(suspect);
    lower = range.lower;
    upper = range.upper;
    if (upper <= threshold(k)) return;
    if (!tolerances_[k] && range.exponent_above <= largest_[k].passed_exponent) return;
  }
  Largest& largest = largest_[k];
  const auto exactly = [&] { return SideError(lhs, rhs, sides_of(i).comparison(k)); };
  const auto fail = [&] {
    ++*comparison.tolerance_failures;
    failing_[i] |= one_bit<ComparisonBits>(k);
    any_failing_ = true;
  };
  if (!std::isfinite(upper)) {
    const SideError error = exactly();
    if (error.kind() == SideError::Kind::without_scale) {
      ++*comparison.error_without_scale;
      return;
    }
    if (tolerances_[k] && error.exceeds(*tolerances_[k])) fail();
    if (error.upper() > largest.passed) {
      comparison.largest_error.offer({error.rounded_up(), batch_->position + i});
      raise_passed(k);
    }
    return;
  }
  if (tolerances_[k] && upper > tolerated_[k]) {
    const bool is_certain = lower > tolerances_[k]->get_d() * (1 + 0x1p-50);
    if (is_certain || exactly().exceeds(*tolerances_[k])) fail();
  }
  if (upper > largest.passed) {
    largest.suspects.push_back({batch_->queries[i], batch_->position + i, lhs, rhs, upper});
    largest.passed = std::max(largest.passed, lower * Decimal6::least_ratio);
    if (largest.suspects.size() == most_suspects) settle(k);
  }
}

template <class Real>
void ErrorWatch<Real>::settle(std::size_t k) {
  Largest& largest = largest_[k];
  Leaders<Decimal6>& leaders = tally_.comparisons[k].largest_error;
  for (const Suspect& suspect : largest.suspects) {
    // The error that passed it may have a later position, so the same decimal is not enough.
    if (suspect.upper <= largest.passed * Decimal6::least_ratio) continue;
    // Where products underflow many errors are the same but for parts in 10^15: the first stands for the others.
    const auto& known = leaders.candidates();
    if (!known.empty() && known[0].position < suspect.position && suspect.upper <= passed_by(known[0].rank)) continue;
    const auto offer = [&](const ExactComparison& exact) {
      const SideError error(suspect.lhs, suspect.rhs, exact);
      if (error.upper() > 0) leaders.offer({error.rounded_up(), suspect.position});
    };
    if (is_of_vertex(k)) offer(VertexSides(suspect.query, k).comparison());
    else offer(exact_sides(formulae_, suspect.query).comparison(k));
  }
  largest.suspects.clear();
  // Errors from here on have later positions: they have to be greater.
  raise_passed(k);
}

template <class Real>
void ErrorWatch<Real>::settle() {
  for (std::size_t k = 0; k < comparison_count; ++k) settle(k);
}

template <class Real>
std::string ErrorWatch<Real>::contradiction(std::size_t query, std::size_t k, const SideError& exact) const {
  bool was_suspect = false;
  for (const SuspectError& suspect : checked_) {
    if (suspect.query != query || suspect.comparison != k) continue;
    was_suspect = true;
    if (exact.kind() != SideError::Kind::finite) return {};
    if (exact.upper() >= suspect.lower && exact.lower() <= suspect.upper) continue;
    return fmt::format("the filter has the error of {} between {} u and {} u, it is {} u", comparisons[k].name,
                       suspect.lower, suspect.upper, exact.rounded_up().text());
  }
  if (was_suspect) return {};
  if (exact.kind() == SideError::Kind::finite && exact.lower() <= threshold(k)) return {};
  return fmt::format("the filter has the error of {} at most {} u, and it is not", comparisons[k].name, threshold(k));
}

template class ErrorWatch<float>;
template class ErrorWatch<double>;

}  // namespace axiscert

#include "fuzz/campaign/runner.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "exact/sphere_triangle/measures/error_measure.h"
#include "exact/sphere_triangle/measures/depth.h"
#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "exact/sphere_triangle/measures/grid_distance.h"

namespace axiscert {

namespace {

// axes_of(), for loops in which it counts.
const std::array<AxisBits, 0x10000> axes_table = [] {
  std::array<AxisBits, 0x10000> all{};
  for (unsigned bits = 0; bits <= 0xffff; ++bits) all[bits] = axes_of(static_cast<ComparisonBits>(bits));
  return all;
}();

}  // namespace

template <class Real>
const Rational& LazyDistance<Real>::squared() {
  if (!squared_) squared_ = squared_distance(query_);
  return *squared_;
}
template <class Real>
std::optional<Real> LazyDistance<Real>::within(const RadiusRange<Real>& range) {
  if (exact_only_) return distance_within(squared(), range);
  if (!rounded_) rounded_ = rounded_distance(query_);
  return rounded_distance_within(*rounded_, range);
}
template <class Real>
double LazyDistance<Real>::at_most() {
  if (!at_most_) at_most_ = exact_only_ ? exactly() : depth_range(query_).high;
  return *at_most_;
}
template <class Real>
double LazyDistance<Real>::exactly() {
  if (!depth_ && !exact_only_) depth_ = depth_on_grid(query_);
  if (!depth_) depth_ = depth(query_, squared());
  return *depth_;
}
template <class Real>
void LazyDistance<Real>::is_zero() {
  if (!exact_only_) at_most_ = depth_ = 0;
}
template class LazyDistance<float>;
template class LazyDistance<double>;

template <class Real>
Runner<Real>::Runner(const Kernel& kernel, const Plan& plan, const Filter<Real>& filter, const Standing& known,
                     std::uint64_t first_position, Tally& tally)
    : kernel_(kernel),
      tolerances_(plan.tolerances),
      standing_(known),
      tally_(tally),
      implementation_(kernel.on<Real>(plan.target)),
      radii_(radii_within<Real>(kernel.limits)),
      by_signs_(!plan.exact_only && !kernel.limits.any() &&
                (kernel.formulae == Formulae::none || has_filtered_errors(kernel.formulae))),
      reference_(kernel),
      errors_(kernel.formulae, plan.tolerances, filter, known, first_position, tally) {}

template <class Real>
void Runner<Real>::ask_about(const QueryBatch<Real>& batch) {
  ask(implementation_, batch.columns(), reply_);
  for (const Finding& finding : reply_.findings) {
    count_finding(tally_, finding.kind, position_ + finding.index, finding.detail);
  }
}

template <class Real>
void Runner<Real>::look_at_sides(const QueryBatch<Real>& batch, const std::vector<Attention>& attention,
                                 const std::vector<DecidedSigns>& decided) {
  if (kernel_.is_reference) reference_.evaluate(batch.columns());
  if (!exposes_sides()) return;
  if (std::find(reply_.verdicts.begin(), reply_.verdicts.end(), Verdict::unanswered) == reply_.verdicts.end()) {
    errors_.look(batch, position_, attention, decided, reply_.answers);
    return;
  }
  std::vector<Attention> answered = attention;
  for (std::size_t i = 0; i < answered.size(); ++i) {
    if (!is_answered(i)) answered[i] = Attention::none;
  }
  errors_.look(batch, position_, answered, decided, reply_.answers);
}

// Without ties strict and non-strict signs are the same, no query touches, and each test is one comparison of flat
// arrays.
template <class Real>
void Runner<Real>::count_plain(const QueryColumns<Real>& batch, const std::vector<DecidedSigns>& decided,
                               const std::vector<char>& exactly) {
  counted_.assign(batch.size, false);
  if (kernel_.formulae == Formulae::none || (kernel_.is_reference && !reference_.has_form())) return;
  const Real* radii = batch.column[coordinate_count - 1];
  const ComparisonBits* bits = reply_.has_bits ? reply_.answers.bits.data() : nullptr;
  for (std::size_t i = 0; i < batch.size; ++i) {
    const Signs signs = decided[i].signs;
    const AxisBits axes = axes_table[signs.strict];
    const bool is_plain = !exactly[i] && signs.ties == 0 && radii[i] != 0;
    const bool is_right = reply_.verdicts[i] == verdict_of(axes) && (!bits || bits[i] == signs.strict) &&
                          (!kernel_.is_reference || reference_.are_both(i, signs.strict));
    if (!(is_plain && is_right)) continue;
    clean_.add(axes, 0, false);
    counted_[i] = true;
  }
}

template <class Real>
bool Runner<Real>::count_if_clean(std::size_t i, const Signs& signs, bool radius_is_zero, const Answer& answer) {
  const Verdict right = verdict_of(axes_table[signs.bits(Strictness::nonstrict)]);
  if (answer.verdict != right) return false;
  const bool touching = (signs.ties != 0 || radius_is_zero) && is_touching(signs, radius_is_zero);
  if (touching && kernel_.touching != Touching::contact) return false;
  if (kernel_.formulae == Formulae::none) {
    clean_.add_verdict(right, touching);
    return true;
  }
  const ComparisonBits exact = signs.bits(kernel_.strictness);
  const AxisBits axes = axes_table[exact];
  if (verdict_of(axes) != right || (answer.bits && *answer.bits != exact)) return false;
  if (kernel_.is_reference && reference_.shared(i) != exact) return false;
  clean_.add(axes, signs.ties, touching);
  return true;
}

template <class Real>
void Runner<Real>::judge_by_signs(std::size_t i, const Query<Real>& q, const Signs& signs, const Answer& answer,
                                  LazyDistance<Real>& depth) {
  std::optional<RoundedBits> batched;
  if (kernel_.formulae != Formulae::none && kernel_.is_reference) batched = reference_.rounded(i);
  // A kernel that differs from the SIMD form is told so by the scalar reference itself.
  if (answer.bits && batched && *answer.bits != batched->reference) batched.reset();
  RepeatedJudgement* repeated = nullptr;
  if (batched) {
    const JudgementPattern pattern{signs,          batched->range_free,     batched->reference,
                                   answer.verdict, answer.bits.has_value(), q.r == 0};
    repeated = repeated_.find(pattern);
    if (repeated && repeated->is_known) {
      ++repeated->repetitions;
      if (repeated->is_touching) depth.is_zero();
      if (const auto flip = repeated->verdict_flip()) count_depth(tally_, position_ + i, *flip, depth, standing_);
      return;
    }
    if (repeated) repeated->pattern = pattern;
  }
  const Truth truth{verdict_of(signs), is_touching(signs, q.r == 0)};
  std::optional<Reference> chain;
  if (kernel_.formulae != Formulae::none) {
    chain = Reference{outcome_of(signs.bits(kernel_.strictness)), std::nullopt, signs.ties};
    if (batched) chain->rounded = batched->outcomes();
    else if (kernel_.is_reference)
      chain->rounded = rounded(kernel_.formulae, kernel_.arithmetic, kernel_.strictness, q);
  }
  const Judgement judgement = judge(truth, chain, answer, kernel_.touching);
  if (truth.touching) depth.is_zero();
  count(tally_, position_ + i, truth, chain ? signs.ties : ComparisonBits{0}, answer, judgement, depth, standing_);
  if (repeated) *repeated = {repeated->pattern, truth.verdict, truth.touching, answer, judgement, true, 0};
}

template <class Real>
void Runner<Real>::judge_exactly(std::size_t i, const Query<Real>& q, const Truth& truth, Claims<Real>* claims,
                                 const Answer& answer, bool is_filtered, LazyDistance<Real>& depth) {
  std::optional<Reference> chain;
  const FormulaTruth* sides = nullptr;
  if (claims) {
    chain = claims->chain(kernel_);
    sides = claims->sides(kernel_.formulae);
  }
  const Judgement judgement = judge(truth, chain, answer, kernel_.touching);
  if (truth.touching) depth.is_zero();
  if (claims && kernel_.limits.any() && !is_within(kernel_.limits, q)) {
    count_outside(tally_, truth, answer, judgement, depth);
    return;
  }
  count(tally_, position_ + i, truth, sides ? sides->ties : ComparisonBits{0}, answer, judgement, depth, standing_);
  if (!claims || answer.verdict == Verdict::unanswered || !sides) return;
  const bool is_checked = is_filtered && by_signs_;
  if (is_checked && kernel_.is_reference) {
    const auto batched = reference_.rounded(i);
    const Rounded& scalar = *chain->rounded;
    if (batched && (batched->reference != scalar.reference.bits || batched->range_free != scalar.range_free.bits)) {
      throw OracleDisagreement(
          fmt::format("{}: the SIMD reference has the comparisons {:016b} and with an unbounded exponent {:016b}, the "
                      "scalar one {:016b} and {:016b} (bit 0 is the first comparison)",
                      kernel_.id, batched->reference, batched->range_free, *scalar.reference.bits,
                      *scalar.range_free.bits),
          q);
    }
  }
  if (!exposes_sides()) return;
  const Sides<Real> computed = reply_.sides(i);
  count_errors(tally_, position_ + i, *sides, computed, tolerances_);
  if (!is_checked) return;
  for (std::size_t k = 0; k < comparison_count; ++k) {
    const ComparisonError error(computed.lhs[k], computed.rhs[k], sides->comparison(k));
    if (const std::string wrong = errors_.contradiction(i, k, error); !wrong.empty()) {
      throw OracleDisagreement(kernel_.id + ": " + wrong, q);
    }
  }
}

template <class Real>
void Runner<Real>::measure_margins(const Query<Real>& q, Claims<Real>& claims, const Answer& answer) {
  if (!answer.bits || (kernel_.limits.any() && !is_within(kernel_.limits, q))) return;
  const FormulaTruth* sides = claims.sides(kernel_.formulae);
  if (sides == nullptr) return;
  count_margins<Real>(tally_.margins, *sides, sides->bits(kernel_.strictness), *answer.bits);
}

template <class Real>
void Runner<Real>::sample(const Query<Real>& q, std::size_t i, LazyDistance<Real>& distance) {
  if (!is_answered(i) || (kernel_.limits.any() && !is_within(kernel_.limits, q))) return;
  if (const auto within = distance.within(radii_)) {
    sampled_.push_back(q);
    distances_.push_back(*within);
  }
}

// The critical radii of the unit's sample at once: a kernel in another process takes longer to ask than to answer.
template <class Real>
void Runner<Real>::finish() {
  errors_.settle();
  clean_.add_to(tally_);
  repeated_.add_to(tally_);
  CriticalRadiusTally& tally = tally_.critical_radius;
  const auto critical = critical_radii(implementation_, sampled_, radii_);
  for (std::size_t i = 0; i < critical.size(); ++i) {
    const CriticalRadiusError error = critical_radius_error(critical[i], distances_[i]);
    if (!error.answered) ++tally.unanswered;
    else if (std::isfinite(*error.ulps)) tally.errors_ulps.push_back(*error.ulps);
    else ++tally.unbounded;
  }
}

template class Runner<float>;
template class Runner<double>;

}  // namespace axiscert

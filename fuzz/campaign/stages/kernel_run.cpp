#include "fuzz/campaign/stages/kernel_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "exact/sphere_triangle/measures/error_measure.h"
#include "kernel/sphere_triangle/shown_sides.h"

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
KernelRun<Real>::KernelRun(const Kernel& kernel, const Plan& plan, const Source& source, const Filter<Real>& filter,
                           const Standing& known, std::uint64_t first_position, Tally& tally)
    : kernel_(kernel),
      source_(source),
      replies_(plan.replies.get()),
      tolerances_(plan.tolerances),
      standing_(known),
      tally_(tally),
      implementation_(kernel.on<Real>(plan.target)),
      radii_(radii_within<Real>(kernel.limits)),
      has_classes_(has_input_classes(kernel)),
      exact_only_(plan.exact_only),
      by_signs_(!plan.exact_only && !kernel.limits.any() &&
                (kernel.formulae == Formulae::none || has_filtered_errors(kernel.formulae))),
      reference_(kernel),
      errors_(kernel.formulae, plan.tolerances, filter, known, first_position, tally) {}

template <class Real>
void KernelRun<Real>::ask_about(const MadeBatch<Real>& batch) {
  position_ = batch.position;
  if (replies_) return;
  ask(implementation_, batch.queries.columns(), reply_);
  for (const Finding& finding : reply_.findings) {
    count_finding(tally_, finding.kind, position_ + finding.index, finding.detail);
  }
}

template <class Real>
Answer KernelRun<Real>::answer(std::size_t i) const {
  return replies_ ? replies_->at(source_, precision_of<Real>, position_ + i) : reply_.outcome(i);
}

template <class Real>
void KernelRun<Real>::look_at_errors(const DecidedBatch<Real>& batch) {
  if (!by_signs_) return;
  if (kernel_.is_reference) reference_.evaluate(batch.queries.columns());
  if (!exposes_sides()) return;
  if (std::find(reply_.verdicts.begin(), reply_.verdicts.end(), Verdict::unanswered) == reply_.verdicts.end()) {
    errors_.look(batch, batch.attention, reply_.answers);
    return;
  }
  std::vector<Attention> answered = batch.attention;
  for (std::size_t i = 0; i < answered.size(); ++i) {
    if (!is_answered(i)) answered[i] = Attention::none;
  }
  errors_.look(batch, answered, reply_.answers);
}

// Without ties strict and non-strict signs are the same, no query touches, and each test is one comparison of flat
// arrays.
template <class Real>
void KernelRun<Real>::count_plain(const DecidedBatch<Real>& batch) {
  counted_.clear();
  if (!by_signs_ || replies_) return;
  if (kernel_.formulae == Formulae::none || (kernel_.is_reference && !reference_.has_form())) return;
  counted_.assign(batch.size(), false);
  const Real* radii = batch.queries.columns().column[coordinate_count - 1];
  const ComparisonBits* bits = reply_.has_bits ? reply_.answers.bits.data() : nullptr;
  for (std::size_t i = 0; i < batch.size(); ++i) {
    const Signs signs = batch.signs[i].signs;
    const AxisBits axes = axes_table[signs.strict];
    const bool is_plain = !batch.is_exact(i) && signs.ties == 0 && radii[i] != 0;
    const bool is_right = reply_.verdicts[i] == verdict_of(axes) && (!bits || bits[i] == signs.strict) &&
                          (!kernel_.is_reference || reference_.are_both(i, signs.strict));
    if (!(is_plain && is_right)) continue;
    clean_.add(axes, 0, false);
    counted_[i] = true;
  }
}

template <class Real>
void KernelRun<Real>::count_engine_like(std::uint64_t queries) {
  if (!kernel_.limits.any()) tally_.verdict.engine.queries += queries;
}

template <class Real>
void KernelRun<Real>::judge(const DecidedBatch<Real>& batch, std::size_t i, bool radius_is_zero,
                            CloseLooks<Real>& looks) {
  const Answer said = answer(i);
  if (batch.is_exact(i) || !by_signs_) {
    judge_exactly(said, batch.is_filtered(i) && batch.is_exact(i), looks.at(i));
  } else if (!count_if_clean(i, batch.signs[i].signs, radius_is_zero, said)) {
    judge_by_signs(batch.signs[i].signs, said, looks.at(i));
  }
}

template <class Real>
bool KernelRun<Real>::count_if_clean(std::size_t i, const Signs& signs, bool radius_is_zero, const Answer& answer) {
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
void KernelRun<Real>::judge_by_signs(const Signs& signs, const Answer& answer, CloseLook<Real>& look) {
  const std::size_t i = look.index();
  const Query<Real>& q = look.query();
  LazyDistance<Real>& depth = look.distance();
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
      if (repeated->is_touching) depth.set_touching();
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
  const Judgement judgement = axiscert::judge(*kernel_.test, truth, chain, answer, kernel_.touching);
  if (truth.touching) depth.set_touching();
  count(tally_, position_ + i, truth, chain ? signs.ties : ComparisonBits{0}, answer, judgement, depth, standing_);
  count_wrong_input(look, judgement, truth.touching);
  if (repeated) *repeated = {repeated->pattern, truth.verdict, truth.touching, answer, judgement, true, 0};
}

template <class Real>
void KernelRun<Real>::judge_exactly(const Answer& answer, bool is_filtered, CloseLook<Real>& look) {
  const Truth& truth = look.truth();
  LazyDistance<Real>& depth = look.distance();
  std::optional<Reference> chain;
  const FormulaTruth* sides = nullptr;
  if (Claims<Real>* claims = look.claims()) {
    chain = claims->chain(kernel_);
    sides = claims->sides(kernel_.formulae);
  }
  const Judgement judgement = axiscert::judge(*kernel_.test, truth, chain, answer, kernel_.touching);
  if (truth.touching) depth.set_touching();
  if (truth.verdict != Verdict::invalid && !is_within(kernel_.limits, look.query())) {
    count_outside(tally_, truth, answer, judgement, depth);
    return;
  }
  if (kernel_.limits.any() && is_engine_like(look.query())) ++tally_.verdict.engine.queries;
  count(tally_, position_ + look.index(), truth, sides ? sides->ties : ComparisonBits{0}, answer, judgement, depth,
        standing_);
  count_wrong_input(look, judgement, truth.touching);
  if (answer.verdict != Verdict::unanswered && sides) check_sides(*sides, chain, is_filtered && by_signs_, look);
}

template <class Real>
void KernelRun<Real>::count_wrong_input(CloseLook<Real>& look, const Judgement& judgement, bool is_touching) {
  if (!has_classes_ || !judgement.verdict_flip) return;
  count_class(tally_.classes, position_ + look.index(), *judgement.verdict_flip, look.query(), is_touching,
              look.distance(), !exact_only_);
}

template <class Real>
void KernelRun<Real>::check_sides(const FormulaTruth& exact, const std::optional<Reference>& chain, bool is_checked,
                                  const CloseLook<Real>& look) {
  const std::size_t i = look.index();
  if (is_checked && kernel_.is_reference) {
    const auto batched = reference_.rounded(i);
    const Rounded& scalar = *chain->rounded;
    if (batched && (batched->reference != scalar.reference.bits || batched->range_free != scalar.range_free.bits)) {
      throw OracleDisagreement(
          fmt::format("{}: the SIMD reference has the comparisons {:016b} and with an unbounded exponent {:016b}, the "
                      "scalar one {:016b} and {:016b} (bit 0 is the first comparison)",
                      kernel_.id, batched->reference, batched->range_free, *scalar.reference.bits,
                      *scalar.range_free.bits),
          Numbers<Real>(look.query()));
    }
  }
  if (!exposes_sides()) return;
  const Sides<Real> computed = sides_at(reply_.answers, i);
  count_errors(tally_, position_ + i, exact, computed, tolerances_);
  if (!is_checked) return;
  for (std::size_t k = 0; k < comparison_count; ++k) {
    const ComparisonError error(computed.lhs[k], computed.rhs[k], exact.comparison(k));
    if (const std::string wrong = errors_.contradiction(i, k, error); !wrong.empty()) {
      throw OracleDisagreement(kernel_.id + ": " + wrong, Numbers<Real>(look.query()));
    }
  }
}

template <class Real>
void KernelRun<Real>::measure_margins(const Query<Real>& q, std::size_t i, Claims<Real>& claims) {
  const Answer said = answer(i);
  if (!said.bits || !is_within(kernel_.limits, q)) return;
  const FormulaTruth* sides = claims.sides(kernel_.formulae);
  if (sides == nullptr) return;
  count_margins<Real>(tally_.margins, *sides, sides->bits(kernel_.strictness), *said.bits);
}

template <class Real>
void KernelRun<Real>::sample(const Query<Real>& q, std::size_t i, LazyDistance<Real>& distance) {
  if (!is_answered(i) || !is_within(kernel_.limits, q)) return;
  if (const auto within = distance.within(radii_)) {
    sampled_.push_back(q);
    distances_.push_back(*within);
  }
}

// The critical radii of the unit's sample at once: a kernel in another process takes longer to ask than to answer.
template <class Real>
void KernelRun<Real>::finish() {
  errors_.settle();
  clean_.add_to(tally_);
  repeated_.add_to(tally_);
  CriticalRadiusTally& tally = tally_.critical_radius;
  const auto critical = critical_radii(implementation_, sampled_, radii_);
  for (std::size_t i = 0; i < critical.size(); ++i) {
    const CriticalRadiusError error = critical_radius_error(critical[i], distances_[i]);
    if (!error.answered) ++tally.unanswered;
    else if (error.not_decided) ++(*error.not_decided == Verdict::invalid ? tally.invalid : tally.undecided);
    else if (std::isfinite(*error.ulps))
      tally.errors_ulps.push_back(*critical[i].radius < distances_[i] ? -*error.ulps : *error.ulps);
    else ++tally.unbounded;
  }
}

template class KernelRun<float>;
template class KernelRun<double>;

}  // namespace axiscert

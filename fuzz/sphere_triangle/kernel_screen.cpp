#include "fuzz/sphere_triangle/kernel_screen.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "exact/judge/side_error.h"
#include "kernel/formulae_list.h"
#include "kernel/sphere_triangle/forms/scalar.h"

namespace axiscert {
void CleanCount::add_ties(ComparisonBits ties) {
  for_each_bit(ties, [&](std::size_t i) { ++ties_[i]; });
}

void CleanCount::add_to(Tally& tally) const {
  std::uint64_t separated = separated_, contact = contact_;
  for (std::size_t axes = 0; axes < by_axes_.size(); ++axes) {
    (axes != 0 ? separated : contact) += by_axes_[axes];
    if (std::has_single_bit(axes)) tally.axes[first_bit(axes)].sole_separator += by_axes_[axes];
  }
  tally.trials += separated + contact;
  tally.truth.separated += separated;
  tally.truth.contact += contact;
  tally.verdict.decided_separations += separated;
  tally.verdict.decided_contacts += contact;
  tally.verdict.decided_touching += touching_;
  tally.truth.touching += touching_;
  tally.with_signs += with_bits_;
  for (std::size_t i = 0; i < comparison_count; ++i) tally.comparisons[i].ties += ties_[i];
}

RepeatedJudgement* RepeatedJudgements::find(const JudgementPattern& pattern) {
  if (table_.empty()) table_.resize(size);
  std::uint64_t word = pattern.signs.strict;
  for (const ComparisonBits bits : {ComparisonBits{pattern.signs.ties}, pattern.range_free, pattern.reference})
    word = word << 16 | bits;
  // The golden ratio's multiples are spread evenly in the upper bits; what else a pattern has is nearly always the
  // same.
  const std::uint64_t first = (word * 0x9e3779b97f4a7c15u) >> 48;
  for (std::size_t i = 0; i < probes; ++i) {
    RepeatedJudgement& entry = table_[(first + i) % size];
    if (!entry.is_known || entry.pattern == pattern) return &entry;
  }
  return nullptr;
}

void RepeatedJudgements::add_to(Tally& tally) const {
  for (const RepeatedJudgement& of : table_) {
    if (of.repetitions == 0) continue;
    const Truth truth{of.truth, of.is_touching};
    count_numbers(tally, truth, of.pattern.signs.ties, of.answer, of.judgement, of.repetitions);
  }
}

namespace {

// axes_of(), for loops in which it counts.
const std::array<AxisBits, 0x10000> axes_table = [] {
  std::array<AxisBits, 0x10000> all{};
  for (unsigned bits = 0; bits <= 0xffff; ++bits) all[bits] = axes_of(static_cast<ComparisonBits>(bits));
  return all;
}();

}  // namespace

template <class Real>
KernelScreen<Real>::KernelScreen(KernelRun<Real>& run, const JudgingOptions& judging, const Filter<Real>& filter,
                                 std::uint64_t first_position)
    : run_(run),
      kernel_(run.kernel()),
      formulae_(formulae_of(kernel_)),
      tolerances_(judging.tolerances),
      tally_(run.tally()),
      radii_(radii_within<Real>(kernel_.limits)),
      has_classes_(has_input_classes(kernel_)),
      exact_only_(judging.exact_only),
      by_signs_(!judging.exact_only && !kernel_.limits.any() &&
                (formulae_ == Formulae::none || has_filtered_errors(formulae_))),
      reference_(kernel_),
      errors_(formulae_, judging.tolerances, filter, run.standing(), first_position, tally_) {}

template <class Real>
void KernelScreen<Real>::count_in_bulk(const DecidedBatch<Real>& batch, const std::vector<std::uint8_t>& engine_like) {
  if (!by_signs_) return;
  if (kernel_.is_reference) reference_.evaluate(batch.queries.columns());
  const Real* radii = batch.queries.columns().column[coordinate_count - 1];
  const auto count_if_clean = [&](std::size_t i) {
    const Signs signs = batch.signs[i].signs;
    const ComparisonBits exact = signs.bits(kernel_.strictness);
    const AxisBits axes = axes_table[exact];
    const Verdict right = verdict_of(axes_table[signs.bits(Strictness::nonstrict)]);
    const Answer answer = run_.answer(i);
    if (answer.verdict != right) return false;
    const bool touching = (signs.ties != 0 || radii[i] == 0) && is_touching(signs, radii[i] == 0);
    if (touching && kernel_.touching != TouchingPolicy::contact) return false;
    if (formulae_ == Formulae::none) {
      clean_.add_verdict(right, touching);
      return true;
    }
    if (verdict_of(axes) != right || (answer.bits && *answer.bits != exact)) return false;
    if (kernel_.is_reference && reference_.shared(i) != exact) return false;
    clean_.add(axes, signs.ties, touching, answer.bits.has_value());
    return true;
  };
  // The same in a few comparisons of flat arrays, where no sign is a tie: of nearly all queries.
  const bool is_flat = formulae_ != Formulae::none && !run_.has_replies(), is_reference = kernel_.is_reference;
  const Verdict* verdicts = run_.reply().verdicts.data();
  const ComparisonBits* bits = run_.reply().has_bits ? run_.reply().answers.bits.data() : nullptr;
  DecidedCounts in_engines;  // counted in registers, and added at the end
  counted_.assign(batch.size(), false);
  for (std::size_t i = 0; i < batch.size(); ++i) {
    if (batch.is_exact(i)) continue;
    const Signs signs = batch.signs[i].signs;
    const AxisBits axes = axes_table[signs.strict];
    const bool is_clear = is_flat && signs.ties == 0 && radii[i] != 0 && verdicts[i] == verdict_of(axes) &&
                          (!bits || bits[i] == signs.strict) && (!is_reference || reference_.shared(i) == signs.strict);
    if (is_clear) clean_.add(axes, 0, false, bits != nullptr);
    counted_[i] = is_clear || count_if_clean(i);
    // The verdict of what is counted here is right.
    if (counted_[i] && engine_like[i]) ++in_engines.decided_as(is_flat ? verdicts[i] : run_.answer(i).verdict);
  }
  EngineTally& engine = *tally_.verdict.engine;
  engine.queries += in_engines.decided();
  engine.decided_contacts += in_engines.decided_contacts;
  engine.decided_separations += in_engines.decided_separations;
}

template <class Real>
void KernelScreen<Real>::look_at_errors(const DecidedBatch<Real>& batch) {
  if (!by_signs_ || !run_.shows_sides()) return;
  const Reply<Real>& reply = run_.reply();
  if (std::find(reply.verdicts.begin(), reply.verdicts.end(), Verdict::unanswered) == reply.verdicts.end()) {
    errors_.look(batch, batch.screening, reply.answers);
    return;
  }
  std::vector<Screening> answered = batch.screening;
  for (std::size_t i = 0; i < answered.size(); ++i) {
    if (!run_.is_answered(i)) answered[i] = Screening::skipped;
  }
  errors_.look(batch, answered, reply.answers);
}

template <class Real>
void KernelScreen<Real>::judge_by_signs(std::size_t i, const Signs& signs, AskedSphereTriangle<Real>& look) {
  const Answer answer = run_.answer(i);
  const Query<Real>& q = look.query();
  LazyDistance<Real>& depth = look.distance();
  std::optional<RoundedBits> batched;
  if (formulae_ != Formulae::none && kernel_.is_reference) batched = reference_.rounded(i);
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
      count_engine(tally_, depth, repeated->judgement.right_of_decided);
      if (const auto flip = repeated->verdict_flip())
        count_depth(tally_, run_.position(i), *flip, depth, run_.standing());
      return;
    }
    if (repeated) repeated->pattern = pattern;
  }
  const Truth truth{verdict_of(signs), is_touching(signs, q.r == 0)};
  std::optional<Reference> chain;
  if (formulae_ != Formulae::none) {
    chain = Reference{outcome_of(signs.bits(kernel_.strictness)), std::nullopt, signs.ties};
    if (batched) chain->rounded = batched->outcomes();
    else if (kernel_.is_reference) chain->rounded = rounded(formulae_, kernel_.arithmetic, kernel_.strictness, q);
  }
  const Judgement judgement = axiscert::judge(*kernel_.predicate, truth, chain, answer, kernel_.touching);
  if (truth.touching) depth.set_touching();
  count(tally_, run_.position(i), truth, chain ? signs.ties : ComparisonBits{0}, answer, judgement, depth,
        run_.standing());
  count_wrong_input(i, judgement, truth.touching, look);
  if (repeated) *repeated = {repeated->pattern, truth.verdict, truth.touching, answer, judgement, true, 0};
}

template <class Real>
void KernelScreen<Real>::look_at_judged(std::size_t i, const typename KernelRun<Real>::JudgedAnswer& found,
                                        bool is_filtered, AskedSphereTriangle<Real>& look) {
  if (look.exact().verdict == Verdict::invalid) return;
  count_wrong_input(i, found.judgement, look.exact().touching, look);
  if (run_.answer(i).verdict == Verdict::unanswered) return;
  const ExactSides* sides = look.sides(formulae_);
  if (sides != nullptr) check_sides(i, *sides, found.chain, is_filtered && by_signs_, look.query());
}

template <class Real>
void KernelScreen<Real>::count_wrong_input(std::size_t i, const Judgement& judgement, bool is_touching,
                                           AskedSphereTriangle<Real>& look) {
  if (!has_classes_ || !judgement.verdict_flip) return;
  count_class(tally_.classes, run_.position(i), *judgement.verdict_flip, look.query(), is_touching, look.distance(),
              !exact_only_);
}

template <class Real>
void KernelScreen<Real>::check_sides(std::size_t i, const ExactSides& exact, const std::optional<Reference>& chain,
                                     bool is_checked, const Query<Real>& q) {
  if (is_checked && kernel_.is_reference) {
    const auto batched = reference_.rounded(i);
    const RoundedDecisions& scalar = *chain->rounded;
    if (batched && (batched->reference != scalar.reference.bits || batched->range_free != scalar.range_free.bits)) {
      throw OracleDisagreement(
          fmt::format("{}: the SIMD reference has the comparisons {:016b} and with an unbounded exponent {:016b}, the "
                      "scalar one {:016b} and {:016b} (bit 0 is the first comparison)",
                      kernel_.id, batched->reference, batched->range_free, *scalar.reference.bits,
                      *scalar.range_free.bits),
          Numbers<Real>(q), *kernel_.predicate);
    }
  }
  if (!run_.shows_sides()) return;
  const Sides<Real> computed = sides_at(run_.reply().answers, i);
  AxisBits failing = 0;
  for (std::size_t k = 0; k < comparison_count; ++k) {
    const SideError error(computed.lhs[k], computed.rhs[k], exact.comparison(k));
    if (count_side_error(tally_.comparisons[k], run_.position(i), error, tolerances_[k])) {
      failing |= one_bit<AxisBits>(comparisons[k].axis);
    }
  }
  for (std::size_t k = 0; k < axis_count; ++k) *tally_.axes[k].tolerance_failures += has_bit(failing, k);
  if (!is_checked) return;
  for (std::size_t k = 0; k < comparison_count; ++k) {
    const SideError error(computed.lhs[k], computed.rhs[k], exact.comparison(k));
    if (const std::string wrong = errors_.contradiction(i, k, error); !wrong.empty()) {
      throw OracleDisagreement(kernel_.id + ": " + wrong, Numbers<Real>(q), *kernel_.predicate);
    }
  }
}

template <class Real>
void KernelScreen<Real>::measure_margins(std::size_t i, AskedSphereTriangle<Real>& asked) {
  const Answer said = run_.answer(i);
  if (!said.bits || !is_within(kernel_.limits, asked.query())) return;
  const ExactSides* sides = asked.sides(formulae_);
  if (sides == nullptr) return;
  count_margins<Real>(tally_.comparisons, *sides, sides->holding(nonstrict_comparisons(kernel_.strictness)),
                      *said.bits);
}

template <class Real>
void KernelScreen<Real>::sample(const Query<Real>& q, std::size_t i, LazyDistance<Real>& distance) {
  if (!run_.is_answered(i) || !is_within(kernel_.limits, q)) return;
  if (const auto within = distance.within(radii_)) {
    sampled_.push_back(q);
    distances_.push_back(*within);
  }
}

// The critical radii of the unit's sample at once: a kernel in another process takes longer to ask than to answer.
template <class Real>
void KernelScreen<Real>::finish() {
  errors_.settle();
  clean_.add_to(tally_);
  repeated_.add_to(tally_);
  CriticalRadiusTally& tally = tally_.critical_radius;
  const auto critical = critical_radii(run_.implementation(), sampled_, radii_);
  for (std::size_t i = 0; i < critical.size(); ++i) {
    const CriticalRadiusError error = critical_radius_error(critical[i], distances_[i]);
    if (!error.answered) ++tally.unanswered;
    else if (error.not_decided) ++(*error.not_decided == Verdict::invalid ? tally.invalid : tally.undecided);
    else if (std::isfinite(*error.ulps))
      tally.errors_ulps.push_back(*critical[i].radius < distances_[i] ? -*error.ulps : *error.ulps);
    else ++tally.unbounded;
  }
}

template class KernelScreen<float>;
template class KernelScreen<double>;

}  // namespace axiscert

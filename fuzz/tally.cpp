#include "fuzz/tally.h"

#include <bit>

namespace axiscert {
namespace {

void add(LinkCounts& into, const LinkCounts& from) {
  for (std::size_t i = 0; i < link_count; ++i) into[i] += from[i];
}

void add(LinkCounts& into, LinkBits links) {
  for (std::size_t i = 0; i < link_count; ++i) into[i] += (links >> i) & 1u;
}

void merge_signs(SignTally& into, const SignTally& from) {
  into.false_separation += from.false_separation;
  into.missed_separation += from.missed_separation;
  into.masked += from.masked;
  into.decisive += from.decisive;
  into.tolerance_failures += from.tolerance_failures;
  add(into.links, from.links);
}

void count_flip(SignTally& tally, const Flip& flip) {
  ++(flip.kind == FlipKind::false_separation ? tally.false_separation : tally.missed_separation);
  ++(flip.decisive ? tally.decisive : tally.masked);
  add(tally.links, flip.links);
}

void count_verdict(VerdictTally& tally, std::uint64_t position, bool touching, const Flip& flip, double depth) {
  const bool false_separation = flip.kind == FlipKind::false_separation;
  ++(false_separation ? tally.false_separation : tally.false_contact);
  tally.touching_flips += touching;
  add(tally.links, flip.links);
  (false_separation ? tally.deepest_false_separation : tally.deepest_false_contact).offer({depth, position});
  for (std::size_t i = 0; i < link_count; ++i) {
    if ((flip.links >> i) & 1u) tally.deepest_by_link[i].offer({depth, position});
  }
}

}  // namespace

void Tally::merge(const Tally& other) {
  trials += other.trials;
  separated += other.separated;
  contact += other.contact;
  touching += other.touching;
  invalid += other.invalid;
  verdict.false_separation += other.verdict.false_separation;
  verdict.false_contact += other.verdict.false_contact;
  verdict.undecided += other.verdict.undecided;
  verdict.invalid += other.verdict.invalid;
  verdict.touching_flips += other.verdict.touching_flips;
  add(verdict.links, other.verdict.links);
  add(verdict.masked_links, other.verdict.masked_links);
  verdict.deepest_false_separation.merge(other.verdict.deepest_false_separation);
  verdict.deepest_false_contact.merge(other.verdict.deepest_false_contact);
  for (std::size_t i = 0; i < link_count; ++i) verdict.deepest_by_link[i].merge(other.verdict.deepest_by_link[i]);
  for (std::size_t i = 0; i < axis_count; ++i) {
    merge_signs(axes[i], other.axes[i]);
    axes[i].sole_separator += other.axes[i].sole_separator;
  }
  for (std::size_t i = 0; i < comparison_count; ++i) {
    ComparisonTally& into = comparisons[i];
    const ComparisonTally& from = other.comparisons[i];
    merge_signs(into, from);
    into.ties += from.ties;
    into.range_events += from.range_events;
    into.error_without_scale += from.error_without_scale;
    into.largest_error.merge(from.largest_error);
    into.false_witness.merge(from.false_witness);
    into.missed_witness.merge(from.missed_witness);
  }
  critical_radius.errors_ulps.insert(critical_radius.errors_ulps.end(), other.critical_radius.errors_ulps.begin(),
                                     other.critical_radius.errors_ulps.end());
  critical_radius.unbounded += other.critical_radius.unbounded;
}

void count(Tally& tally, std::uint64_t position, const Truth& truth, const FormulaTruth* sides, const Answer& answer,
           const Judgement& judgement, std::optional<double> depth) {
  ++tally.trials;
  if (truth.verdict == Verdict::invalid) {
    ++tally.invalid;
    return;
  }
  ++(truth.verdict == Verdict::separated ? tally.separated : tally.contact);
  tally.touching += truth.touching;
  tally.verdict.undecided += answer.verdict == Verdict::undecided;
  tally.verdict.invalid += answer.verdict == Verdict::invalid;
  if (!judgement.verdict_flip) add(tally.verdict.masked_links, judgement.verdict_links);

  if (sides && sides->ties != 0) {
    for (std::size_t i = 0; i < comparison_count; ++i) tally.comparisons[i].ties += (sides->ties >> i) & 1u;
  }
  const AxisBits exact_axes = axes_of(judgement.exact.value_or(0));
  if (std::has_single_bit(exact_axes))
    ++tally.axes[static_cast<std::size_t>(std::countr_zero(exact_axes))].sole_separator;

  for (const Flip& flip : judgement.flips()) {
    switch (flip.level) {
      case Level::verdict:
        count_verdict(tally.verdict, position, truth.touching, flip, depth.value_or(0));
        break;
      case Level::axis:
        count_flip(tally.axes[flip.index], flip);
        break;
      case Level::comparison: {
        ComparisonTally& comparison = tally.comparisons[flip.index];
        count_flip(comparison, flip);
        (flip.kind == FlipKind::false_separation ? comparison.false_witness : comparison.missed_witness)
            .offer({flip.decisive, position});
        break;
      }
    }
  }
}

template <class Real>
void count_errors(Tally& tally, std::uint64_t position, const FormulaTruth& exact, const Sides<Real>& computed,
                  const Tolerances& tolerances) {
  AxisBits failing_axes = 0;
  for (std::size_t i = 0; i < comparison_count; ++i) {
    ComparisonTally& comparison = tally.comparisons[i];
    const ComparisonError error(computed.lhs[i], computed.rhs[i], exact.comparison(i));
    switch (error.kind()) {
      case ComparisonError::Kind::range_event:
        ++comparison.range_events;
        break;
      case ComparisonError::Kind::without_scale:
        ++comparison.error_without_scale;
        break;
      case ComparisonError::Kind::finite:
        // The bound only selects; what is compared and stored is the exact error.
        if (error.upper() > 0 && error.upper() >= comparison.largest_error.best().value()) {
          comparison.largest_error.offer({error.rounded_up(), position});
        }
        if (tolerances[i] && error.exceeds(*tolerances[i])) {
          ++comparison.tolerance_failures;
          failing_axes |= static_cast<AxisBits>(1u << static_cast<unsigned>(comparisons[i].axis));
        }
        break;
    }
  }
  for (std::size_t i = 0; i < axis_count; ++i) tally.axes[i].tolerance_failures += (failing_axes >> i) & 1u;
}
template void count_errors<float>(Tally&, std::uint64_t, const FormulaTruth&, const Sides<float>&, const Tolerances&);
template void count_errors<double>(Tally&, std::uint64_t, const FormulaTruth&, const Sides<double>&, const Tolerances&);

}  // namespace axiscert

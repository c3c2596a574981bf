#include "fuzz/campaign/counts/tally.h"

#include <bit>

#include "exact/trait/oracles.h"
#include "exact/trait/side_error.h"

namespace axiscert {
namespace {

void add(LinkCounts& into, const LinkCounts& from) {
  for (const Link link : enumerators<Link>) into[link] += from[link];
}

void add(LinkCounts& into, LinkSet links, std::uint64_t times) {
  for (const Link link : enumerators<Link>) into[link] += links.contains(link) * times;
}

void merge_signs(SignTally& into, const SignTally& from) {
  into.false_separation += from.false_separation;
  into.missed_separation += from.missed_separation;
  into.masked += from.masked;
  into.decisive += from.decisive;
  into.tolerance_failures += from.tolerance_failures;
  add(into.links, from.links);
}

void count_flip(SignTally& tally, const Flip& flip, std::uint64_t times) {
  (flip.kind == FlipKind::false_separation ? tally.false_separation : tally.missed_separation) += times;
  (flip.decisive ? tally.decisive : tally.masked) += times;
  add(tally.links, flip.links, times);
}

void keep_first(std::optional<std::uint64_t>& first, std::optional<std::uint64_t> position) {
  if (position && (!first || *position < *first)) first = position;
}

void merge_finding(FindingTally& into, const FindingTally& from) {
  if (from.count == 0) return;
  if (into.count == 0 || from.first < into.first) {
    into.first = from.first;
    into.detail = from.detail;
  }
  into.count += from.count;
}

void merge_outside(OutsideTally& into, const OutsideTally& from) {
  into.trials += from.trials;
  into.false_separation += from.false_separation;
  into.false_contact += from.false_contact;
  into.unanswered += from.unanswered;
  into.contact += from.contact;
  into.touching += from.touching;
  into.deepest = std::max(into.deepest, from.deepest);
}

void merge_verdict(VerdictTally& into, const VerdictTally& from) {
  into.false_separation += from.false_separation;
  into.false_contact += from.false_contact;
  into.undecided += from.undecided;
  into.invalid += from.invalid;
  into.unanswered += from.unanswered;
  into.undecided_contact += from.undecided_contact;
  into.undecided_touching += from.undecided_touching;
  into.touching_flips += from.touching_flips;
  add(into.links, from.links);
  add(into.masked_links, from.masked_links);
  add(into.touching_links, from.touching_links);
  into.deepest_false_separation.merge(from.deepest_false_separation);
  into.deepest_false_contact.merge(from.deepest_false_contact);
  for (const Link link : enumerators<Link>) {
    into.deepest_by_link[link].merge(from.deepest_by_link[link]);
    keep_first(into.first_by_link[link], from.first_by_link[link]);
  }
  merge_outside(into.outside_limits, from.outside_limits);
  into.depths.merge(from.depths);
  into.engine.queries += from.engine.queries;
  into.engine.wrong.merge(from.engine.wrong);
}

void count_truth(Tally& tally, const Truth& truth, std::uint64_t times = 1) {
  tally.trials += times;
  if (truth.verdict == Verdict::invalid) {
    tally.invalid += times;
    return;
  }
  (truth.verdict == Verdict::separated ? tally.separated : tally.contact) += times;
  if (truth.touching) tally.touching += times;
}

// Calls visit(leaders) with each of a tally's in which a wrong verdict's depth has a place.
template <class Tally, class Visit>
void for_each_depth_leaders(Tally& tally, const Flip& flip, Visit&& visit) {
  visit(flip.kind == FlipKind::false_separation ? tally.deepest_false_separation : tally.deepest_false_contact);
  for (const Link link : flip.links) visit(tally.deepest_by_link[link]);
}

bool could_keep(const VerdictTally& tally, const Flip& flip, const Candidate<double>& at_most) {
  bool could = false;
  for_each_depth_leaders(tally, flip, [&](const Leaders<double>& leaders) { could |= leaders.could_keep(at_most); });
  return could;
}

void count_verdict(VerdictTally& tally, bool touching, const Flip& flip, std::uint64_t times) {
  (flip.kind == FlipKind::false_separation ? tally.false_separation : tally.false_contact) += times;
  add(tally.links, flip.links, times);
  if (!touching) return;
  tally.touching_flips += times;
  add(tally.touching_links, flip.links, times);
}

void keep_first_verdict(VerdictTally& tally, std::uint64_t position, bool touching, const Flip& flip) {
  for (const Link link : flip.links) {
    // No convention explains a difference from the reference.
    const bool is_explained = touching && link != Link::implementation;
    if (!is_explained) keep_first(tally.first_by_link[link], position);
  }
}

}  // namespace

void CriticalRadiusTally::merge(const CriticalRadiusTally& other) {
  errors_ulps.insert(errors_ulps.end(), other.errors_ulps.begin(), other.errors_ulps.end());
  unbounded += other.unbounded;
  unanswered += other.unanswered;
  undecided += other.undecided;
  invalid += other.invalid;
}

void Tally::merge(const Tally& other) {
  trials += other.trials;
  separated += other.separated;
  contact += other.contact;
  touching += other.touching;
  invalid += other.invalid;
  merge_verdict(verdict, other.verdict);
  for (std::size_t i = 0; i < axes.size(); ++i) {
    merge_signs(axes[i], other.axes[i]);
    axes[i].sole_separator += other.axes[i].sole_separator;
  }
  for (std::size_t i = 0; i < comparisons.size(); ++i) {
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
  critical_radius.merge(other.critical_radius);
  for (const FindingKind kind : enumerators<FindingKind>) merge_finding(findings[kind], other.findings[kind]);
  margins.merge(other.margins);
  classes.merge(other.classes);
  motion.merge(other.motion);
}

void count_depth(Tally& tally, std::uint64_t position, const Flip& flip, DepthOf& depth, const Standing& standing) {
  count_depth(tally.verdict.depths, tally.verdict.engine, flip.kind, depth);
  const Candidate<double> at_most{depth.at_most(), position};
  if (!could_keep(tally.verdict, flip, at_most) || !standing.could_keep_depth(flip, at_most)) return;
  const Candidate<double> candidate{depth.exactly(), position};
  for_each_depth_leaders(tally.verdict, flip, [&](Leaders<double>& leaders) { leaders.offer(candidate); });
}

void count_numbers(Tally& tally, const Truth& truth, ComparisonBits ties, const Answer& answer,
                   const Judgement& judgement, std::uint64_t times) {
  count_truth(tally, truth, times);
  if (truth.verdict == Verdict::invalid) return;
  if (answer.verdict == Verdict::undecided) {
    tally.verdict.undecided += times;
    tally.verdict.undecided_contact += (truth.verdict == Verdict::contact) * times;
    tally.verdict.undecided_touching += truth.touching * times;
  }
  if (answer.verdict == Verdict::invalid) tally.verdict.invalid += times;
  if (answer.verdict == Verdict::unanswered) tally.verdict.unanswered += times;
  if (!judgement.verdict_flip) add(tally.verdict.masked_links, judgement.verdict_links, times);

  for_each_bit(ties, [&](std::size_t i) { tally.comparisons[i].ties += times; });
  if (std::has_single_bit(judgement.exact_axes)) tally.axes[first_bit(judgement.exact_axes)].sole_separator += times;

  judgement.for_each_flip([&](const Flip& flip) {
    switch (flip.level) {
      case Level::verdict:
        count_verdict(tally.verdict, truth.touching, flip, times);
        break;
      case Level::axis:
        count_flip(tally.axes[flip.index], flip, times);
        break;
      case Level::comparison:
        count_flip(tally.comparisons[flip.index], flip, times);
        break;
    }
  });
}

void count(Tally& tally, std::uint64_t position, const Truth& truth, ComparisonBits ties, const Answer& answer,
           const Judgement& judgement, DepthOf& depth, const Standing& standing) {
  count_numbers(tally, truth, ties, answer, judgement, 1);
  if (truth.verdict == Verdict::invalid) return;
  judgement.for_each_flip([&](const Flip& flip) {
    switch (flip.level) {
      case Level::verdict:
        keep_first_verdict(tally.verdict, position, truth.touching, flip);
        count_depth(tally, position, flip, depth, standing);
        break;
      case Level::axis:
        break;
      case Level::comparison: {
        ComparisonTally& comparison = tally.comparisons[flip.index];
        (flip.kind == FlipKind::false_separation ? comparison.false_witness : comparison.missed_witness)
            .offer({flip.decisive, position});
        break;
      }
    }
  });
}

void count_outside(Tally& tally, const Truth& truth, const Answer& answer, const Judgement& judgement, DepthOf& depth) {
  count_truth(tally, truth);
  OutsideTally& outside = tally.verdict.outside_limits;
  ++outside.trials;
  outside.contact += truth.verdict == Verdict::contact;
  outside.touching += truth.touching;
  outside.unanswered += answer.verdict == Verdict::unanswered;
  if (!judgement.verdict_flip) return;
  ++(*judgement.verdict_flip == FlipKind::false_separation ? outside.false_separation : outside.false_contact);
  if (depth.at_most() > outside.deepest) outside.deepest = std::max(outside.deepest, depth.exactly());
}

bool Standing::could_keep_depth(const Flip& flip, const Candidate<double>& at_most) const {
  return could_keep(verdict, flip, at_most);
}

Standing standing_of(const Tally& tally) {
  Standing standing;
  for (const ComparisonTally& comparison : tally.comparisons)
    standing.largest_error.push_back(comparison.largest_error);
  standing.verdict.deepest_false_separation = tally.verdict.deepest_false_separation;
  standing.verdict.deepest_false_contact = tally.verdict.deepest_false_contact;
  standing.verdict.deepest_by_link = tally.verdict.deepest_by_link;
  return standing;
}

void count_finding(Tally& tally, FindingKind kind, std::uint64_t position, const std::string& detail) {
  merge_finding(tally.findings[kind], {1, position, detail});
}

bool count_side_error(ComparisonTally& comparison, std::uint64_t position, const SideError& error,
                      const std::optional<Rational>& tolerated) {
  switch (error.kind()) {
    case SideError::Kind::range_event:
      ++comparison.range_events;
      break;
    case SideError::Kind::without_scale:
      ++comparison.error_without_scale;
      break;
    case SideError::Kind::finite:
      // The bound only selects; what is compared and stored is the exact error.
      if (error.upper() > 0 && error.upper() >= least_of_interest(comparison)) {
        comparison.largest_error.offer({error.rounded_up(), position});
      }
      if (tolerated && error.exceeds(*tolerated)) {
        ++comparison.tolerance_failures;
        return true;
      }
      break;
  }
  return false;
}

template <class Real>
void count_errors(Tally& tally, std::uint64_t position, const TestDescription& test, const ExactSides& exact,
                  const Answers<Real>& computed, std::size_t index, const Tolerances& tolerances) {
  ClauseBits failing = 0;
  for (std::size_t i = 0; i < test.comparisons.size(); ++i) {
    const Real lhs = computed.lhs[i][index], rhs = computed.rhs[i][index];
    const ExactComparison sides = exact.comparison(i);
    if (!tolerances[i] && side_error_at_most(lhs, rhs, sides) < least_of_interest(tally.comparisons[i])) continue;
    const SideError error(lhs, rhs, sides);
    if (count_side_error(tally.comparisons[i], position, error, tolerances[i])) {
      failing |= one_bit<ClauseBits>(test.comparisons[i].clause);
    }
  }
  for_each_bit(failing, [&](std::size_t i) { ++tally.axes[i].tolerance_failures; });
}
template void count_errors(Tally&, std::uint64_t, const TestDescription&, const ExactSides&, const Answers<float>&,
                           std::size_t, const Tolerances&);
template void count_errors(Tally&, std::uint64_t, const TestDescription&, const ExactSides&, const Answers<double>&,
                           std::size_t, const Tolerances&);

}  // namespace axiscert

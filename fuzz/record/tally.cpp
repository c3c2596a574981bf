#include "fuzz/record/tally.h"

#include <bit>
#include <cmath>

#include "exact/judge/oracles.h"
#include "exact/judge/side_error.h"
#include "fuzz/text/json_form.h"
#include "fuzz/text/merge.h"

namespace axiscert {
namespace {

void add(LinkCounts& into, LinkSet links, std::uint64_t times) {
  for (const Link link : enumerators<Link>) into[link] += links.contains(link) * times;
}

void add(FormulaLinks& into, LinkSet links, std::uint64_t times) {
  into.rounding += links.contains(Link::rounding) * times;
  into.range += links.contains(Link::range) * times;
  into.implementation += links.contains(Link::implementation) * times;
  into.unattributed += links.contains(Link::unattributed) * times;
}

void count_flip(SignTally& tally, const Flip& flip, std::uint64_t times) {
  (flip.kind == FlipKind::false_separation ? tally.false_separation : tally.missed_separation) += times;
  (flip.decisive ? tally.decisive : tally.masked) += times;
  add(tally.links, flip.links, times);
}

void count_truth(Tally& tally, const Truth& truth, std::uint64_t times = 1) {
  tally.trials += times;
  if (truth.verdict == Verdict::invalid) {
    tally.truth.invalid += times;
    return;
  }
  (truth.verdict == Verdict::separated ? tally.truth.separated : tally.truth.contact) += times;
  if (truth.touching) tally.truth.touching += times;
}

// Calls visit(leaders) with each of a tally's in which a wrong verdict's depth has a place.
template <class Tally, class Visit>
void for_each_depth_leaders(Tally& tally, const Flip& flip, Visit&& visit) {
  visit(flip.kind == FlipKind::false_separation ? tally.deepest_false_separation : tally.deepest_false_contact);
  for (const Link link : flip.links) visit(tally.deepest_by_link[link]);
}

template <class Tally>
auto& length_leaders(Tally& tally, const Flip& flip) {
  return flip.kind == FlipKind::false_separation ? tally.farthest_false_separation : tally.farthest_false_contact;
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
    if (!is_explained) tally.first_by_link[link].offer(position);
  }
}

}  // namespace

void FindingTally::merge(const FindingTally& other) {
  if (other.count == 0) return;
  if (count == 0 || other.first < first) {
    first = other.first;
    detail = other.detail;
  }
  count += other.count;
}

void Tally::merge(const Tally& other) { merge_fields(*this, other); }

Tally empty_tally(const Predicate& predicate) {
  Tally tally;
  for (const PredicateClause& clause : predicate.clauses) tally.axes.put(clause.name);
  for (const PredicateComparison& comparison : predicate.comparisons) tally.comparisons.put(comparison.name);
  return tally;
}

void count_engine(Tally& tally, DepthOf& depth, const std::optional<Verdict>& right_of_decided) {
  if (!std::isfinite(depth.engine_threshold())) return;
  ++tally.verdict.engine->queries;
  if (right_of_decided) ++tally.verdict.engine->decided_as(*right_of_decided);
}

void count_depth(Tally& tally, std::uint64_t position, const Flip& flip, DepthOf& depth,
                 const StandingLeaders& standing) {
  count_depth(*tally.verdict.depths, *tally.verdict.engine, flip.kind, depth);
  const Candidate<double> length_at_most{depth.length_at_most(), position};
  Leaders<double>& lengths = length_leaders(tally.verdict, flip);
  if (lengths.could_keep(length_at_most) && standing.could_keep_length(flip, length_at_most))
    lengths.offer({depth.length(), position});
  const Candidate<double> at_most{depth.at_most(), position};
  if (!could_keep(tally.verdict, flip, at_most) || !standing.could_keep_depth(flip, at_most)) return;
  const Candidate<double> candidate{depth.exactly(), position};
  for_each_depth_leaders(tally.verdict, flip, [&](Leaders<double>& leaders) { leaders.offer(candidate); });
}

void count_numbers(Tally& tally, const Truth& truth, ComparisonBits ties, const Answer& answer,
                   const Judgement& judgement, std::uint64_t times) {
  count_truth(tally, truth, times);
  if (truth.verdict == Verdict::invalid) return;
  if (judgement.right_of_decided) {
    tally.verdict.decided_as(*judgement.right_of_decided) += times;
    tally.verdict.decided_touching += truth.touching * times;
  }
  if (answer.verdict == Verdict::undecided) {
    tally.verdict.undecided += times;
    tally.verdict.undecided_contact += (truth.verdict == Verdict::contact) * times;
    tally.verdict.undecided_touching += truth.touching * times;
  }
  if (answer.verdict == Verdict::invalid) tally.verdict.invalid += times;
  if (answer.verdict == Verdict::unanswered) tally.verdict.unanswered += times;
  if (!judgement.verdict_flip) add(tally.verdict.masked_links, judgement.verdict_links, times);

  const bool is_decided = answer.verdict == Verdict::separated || answer.verdict == Verdict::contact;
  tally.with_signs += (is_decided && answer.bits && judgement.exact) * times;
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
           const Judgement& judgement, DepthOf& depth, const StandingLeaders& standing) {
  count_numbers(tally, truth, ties, answer, judgement, 1);
  if (truth.verdict == Verdict::invalid) return;
  count_engine(tally, depth, judgement.right_of_decided);
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
  OutsideTally& outside = *tally.verdict.outside_limits;
  ++outside.trials;
  outside.contact += truth.verdict == Verdict::contact;
  outside.touching += truth.touching;
  if (judgement.right_of_decided) ++outside.decided_as(*judgement.right_of_decided);
  outside.unanswered += answer.verdict == Verdict::unanswered;
  if (!judgement.verdict_flip) return;
  ++(*judgement.verdict_flip == FlipKind::false_separation ? outside.false_separation : outside.false_contact);
  if (depth.at_most() > outside.deepest) outside.deepest = std::max(outside.deepest, depth.exactly());
}

bool StandingLeaders::could_keep_depth(const Flip& flip, const Candidate<double>& at_most) const {
  return could_keep(verdict, flip, at_most);
}

bool StandingLeaders::could_keep_length(const Flip& flip, const Candidate<double>& at_most) const {
  return length_leaders(verdict, flip).could_keep(at_most);
}

StandingLeaders standing_of(const Tally& tally) {
  StandingLeaders standing;
  for (const auto& [name, comparison] : tally.comparisons) standing.largest_error.push_back(comparison.largest_error);
  standing.verdict.deepest_false_separation = tally.verdict.deepest_false_separation;
  standing.verdict.deepest_false_contact = tally.verdict.deepest_false_contact;
  standing.verdict.farthest_false_separation = tally.verdict.farthest_false_separation;
  standing.verdict.farthest_false_contact = tally.verdict.farthest_false_contact;
  standing.verdict.deepest_by_link = tally.verdict.deepest_by_link;
  return standing;
}

void count_finding(Tally& tally, FindingKind kind, std::uint64_t position, const std::string& detail) {
  tally.findings[kind].merge({1, position, detail});
}

bool count_side_error(ComparisonTally& comparison, std::uint64_t position, const SideError& error,
                      const std::optional<Rational>& tolerated) {
  switch (error.kind()) {
    case SideError::Kind::range_event:
      ++*comparison.range_events;
      break;
    case SideError::Kind::without_scale:
      ++*comparison.error_without_scale;
      break;
    case SideError::Kind::finite:
      // The bound only selects; what is compared and stored is the exact error.
      if (error.upper() > 0 && error.upper() >= least_of_interest(comparison)) {
        comparison.largest_error.offer({error.rounded_up(), position});
      }
      if (tolerated && error.exceeds(*tolerated)) {
        ++*comparison.tolerance_failures;
        return true;
      }
      break;
  }
  return false;
}

template <class Real>
void count_errors(Tally& tally, std::uint64_t position, const Predicate& predicate, const ExactSides& exact,
                  const Answers<Real>& computed, std::size_t index, const Tolerances& tolerances) {
  ClauseBits failing = 0;
  for (std::size_t i = 0; i < predicate.comparisons.size(); ++i) {
    const Real lhs = computed.lhs[i][index], rhs = computed.rhs[i][index];
    const ExactComparison sides = exact.comparison(i);
    if (!tolerances[i] && side_error_at_most(lhs, rhs, sides) < least_of_interest(tally.comparisons[i])) continue;
    const SideError error(lhs, rhs, sides);
    if (count_side_error(tally.comparisons[i], position, error, tolerances[i])) {
      failing |= one_bit<ClauseBits>(predicate.comparisons[i].clause);
    }
  }
  for_each_bit(failing, [&](std::size_t i) { ++*tally.axes[i].tolerance_failures; });
}
template void count_errors(Tally&, std::uint64_t, const Predicate&, const ExactSides&, const Answers<float>&,
                           std::size_t, const Tolerances&);
template void count_errors(Tally&, std::uint64_t, const Predicate&, const ExactSides&, const Answers<double>&,
                           std::size_t, const Tolerances&);

Json JsonForm<FirstQuery>::write(const FirstQuery& first) {
  return first.position ? Json(*first.position + 1) : Json(nullptr);
}
void JsonForm<FirstQuery>::read(const JsonPlace& place, FirstQuery& into) {
  into = {};
  if (place.value().is_null()) return;
  std::uint64_t number = 0;
  read_json(place, number);
  if (number == 0) place.refuse("is no query: the first is 1");
  into.position = number - 1;
}
Json JsonForm<FirstQuery>::schema() { return {{"type", {"integer", "null"}}, {"minimum", 1}}; }

}  // namespace axiscert

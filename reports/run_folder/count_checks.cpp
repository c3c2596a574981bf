#include "reports/run_folder/count_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <numbers>
#include <string_view>
#include <tuple>

namespace axiscert {
namespace {
using Fault = std::optional<std::string>;
}  // namespace

std::optional<std::string> fault_of_classes(const KernelRecord& kernel, const FamilyRecord& family) {
  if (!family.classes) return std::nullopt;
  if (kernel.reference == true) return "classes of a kernel with a reference, whose links say why it is wrong";
  const VerdictTally& verdict = family.verdict;
  std::uint64_t missed = 0, phantom = 0, ties = 0;
  for (const auto& [which, of] : *family.classes) {
    missed += of.false_separation;
    phantom += of.false_contact;
  }
  for (const auto& [kind, sum, whole] : {std::tuple("false_separation", missed, verdict.false_separation),
                                         {"false_contact", phantom, verdict.false_contact}}) {
    if (sum != whole) return fmt::format("the classes have {} {} verdicts, but the family {}", sum, kind, whole);
  }
  for (const auto& [which, of] : *family.classes) {
    const std::uint64_t wrong = of.false_separation + of.false_contact;
    if (wrong == 0) return fmt::format("class {} has no wrong verdict", name(which));
    if (of.deepest.best() > verdict.deepest())
      return fmt::format("the deepest of class {} is deeper than the deepest of the family", name(which));
    if (which == InputClass::tie) ties = wrong;
  }
  if (ties != verdict.touching_flips) return "class tie and touching_flips do not agree";
  return std::nullopt;
}

namespace {

// What is left of the whole without these parts; empty where they are more. A sum of forged counts may wrap.
template <class Parts = std::initializer_list<std::uint64_t>>
std::optional<std::uint64_t> left_of(std::uint64_t whole, const Parts& parts) {
  for (const std::uint64_t part : parts) {
    if (part > whole) return std::nullopt;
    whole -= part;
  }
  return whole;
}

// The contacts and separations that a verdict can be right on, of queries with these truths, by the promise of touch.
struct ByPromise {
  std::uint64_t contacts, separations;
};
ByPromise by_promise(TouchingPolicy policy, std::uint64_t contact, std::uint64_t touching, std::uint64_t separated) {
  return {contact - (policy == TouchingPolicy::contact ? 0 : touching),
          separated + (policy == TouchingPolicy::separated ? touching : 0)};
}

}  // namespace

std::optional<std::string> fault_of_verdicts(TouchingPolicy policy, const FamilyCounts& counts) {
  const TruthCounts& truth = counts.truth;
  const VerdictTally& verdict = counts.verdict;
  const OutsideTally outside = verdict.outside_limits.value_or(OutsideTally());
  if (left_of(counts.trials, {truth.separated, truth.contact, truth.invalid}) != 0)
    return "the truths do not add up to the trials";
  if (truth.touching > truth.contact) return "more touching queries than contacts";

  // The truth outside the limits, and what is left within.
  if (outside.contact > std::min(outside.trials, truth.contact) || outside.trials - outside.contact > truth.separated ||
      outside.touching > std::min(outside.contact, truth.touching) ||
      truth.touching - outside.touching > truth.contact - outside.contact)
    return "more contacts, touching or separated queries outside the limits than there are";
  const std::uint64_t separated_outside = outside.trials - outside.contact,
                      touching = truth.touching - outside.touching,
                      valid = truth.contact + truth.separated - outside.trials;
  const auto [contacts_outside, separations_outside] =
      by_promise(policy, outside.contact, outside.touching, separated_outside);
  const auto [contacts, separations] =
      by_promise(policy, truth.contact - outside.contact, touching, truth.separated - separated_outside);
  if (outside.decided_contacts > contacts_outside || outside.decided_separations > separations_outside ||
      !left_of(outside.trials, {outside.decided_contacts, outside.decided_separations, outside.unanswered}) ||
      outside.false_separation > outside.decided_contacts || outside.false_contact > outside.decided_separations)
    return "more decided, wrong or missing answers outside the limits than queries there";

  // Within, each valid query has one answer.
  if (verdict.undecided_contact > verdict.undecided ||
      verdict.undecided_touching > std::min(verdict.undecided_contact, touching))
    return "undecided_contact and undecided_touching do not fit undecided and the truth";
  const auto [declined_contacts, declined_separations] = by_promise(
      policy, verdict.undecided_contact, verdict.undecided_touching, verdict.undecided - verdict.undecided_contact);
  if (!left_of(contacts, {verdict.decided_contacts, declined_contacts}) ||
      !left_of(separations, {verdict.decided_separations, declined_separations}))
    return "more decided and undecided answers than contacts, or than separations";
  if (verdict.false_separation > verdict.decided_contacts || verdict.false_contact > verdict.decided_separations)
    return "more false_separation or false_contact verdicts than decided queries";
  // What touches is right or wrong where a kernel promises something of it, and else in no count of decided queries.
  const std::uint64_t answered_touching = touching - verdict.undecided_touching,
                      judged_touching = policy == TouchingPolicy::either ? 0 : answered_touching,
                      without_verdict = verdict.invalid + verdict.unanswered,
                      answers = verdict.decided() + verdict.undecided + without_verdict;
  if (!left_of(valid, {verdict.decided_contacts, verdict.decided_separations, verdict.undecided, verdict.invalid,
                       verdict.unanswered}) ||
      answers + (answered_touching - judged_touching) < valid)
    return "more or fewer decided, undecided, invalid and unanswered verdicts than valid queries";
  const bool is_contact = policy == TouchingPolicy::contact;
  if (verdict.decided_touching > judged_touching ||
      verdict.decided_touching > (is_contact ? verdict.decided_contacts : verdict.decided_separations) ||
      judged_touching - verdict.decided_touching > without_verdict)
    return "decided_touching does not fit the touching queries and their answers";
  if (verdict.touching_flips > verdict.decided_touching ||
      verdict.touching_flips > (is_contact ? verdict.false_separation : verdict.false_contact))
    return "more touching_flips than wrong verdicts, or than decided queries that touch";

  const ClearTally clear = verdict.clear.value_or(ClearTally());
  if (clear.queries > valid ||
      !left_of(clear.queries, {clear.decided_contacts, clear.decided_separations, clear.undecided}) ||
      clear.false_separation > clear.decided_contacts || clear.false_contact > clear.decided_separations)
    return "more answers to clear queries than there are, or more of these than valid queries";
  if (clear.decided_contacts > verdict.decided_contacts || clear.decided_separations > verdict.decided_separations ||
      clear.undecided > verdict.undecided || clear.unanswered() > without_verdict ||
      clear.false_separation > verdict.false_separation || clear.false_contact > verdict.false_contact)
    return "more answers of one kind to clear queries than to all";
  return std::nullopt;
}

std::optional<std::string> fault_of_depths(const VerdictTally& verdict, std::uint64_t valid) {
  if (verdict.depths) {
    for (const auto& [kind, decades, whole] :
         {std::tuple("false_separation", verdict.depths->false_separation, verdict.false_separation),
          {"false_contact", verdict.depths->false_contact, verdict.false_contact}}) {
      if (decades.sum() != whole) return fmt::format("depths do not add up to {}", kind);
    }
  }
  if (!verdict.engine) return std::nullopt;
  const EngineTally& engine = *verdict.engine;
  for (const auto& [kind, part, whole] :
       {std::tuple("false_separation", engine.false_separation(),
                   std::min(verdict.false_separation, engine.decided_contacts)),
        {"false_contact", engine.false_contact(), std::min(verdict.false_contact, engine.decided_separations)},
        {"decided_contacts", engine.decided_contacts, verdict.decided_contacts},
        {"decided_separations", engine.decided_separations, verdict.decided_separations}}) {
    if (part > whole)
      return fmt::format("more {} on engine-like queries than on all, or than there were decided", kind);
  }
  if (engine.decided() > engine.queries || engine.queries > valid)
    return "more engine-like queries than valid ones, or more decided ones";
  return std::nullopt;
}

namespace {

// What was judged of a number of answers, and what lacks it; of a normal its length is judged wherever it is given.
std::uint64_t judged_of(const auto& part) {
  if constexpr (requires { part.lengths; }) return part.lengths;
  else if constexpr (requires { part.judged(); }) return part.judged();
  else return part.judged;
}
std::uint64_t missing_of(const auto& part) { return part.none; }
std::uint64_t missing_of(const TimeTally& time) { return time.none + std::min(time.invalid, ~time.none); }

Fault fault_of_number(const ContactTally& all, std::string_view name, const auto& part) {
  const std::uint64_t judged = judged_of(part), missing = missing_of(part);
  const GivenTally& given = part.given;
  if (given.separations > all.separations || given.contacts > all.answers - all.separations)
    return fmt::format("contacts/{}/given: more contacts or separations than answers that say so", name);
  if ((given.contacts != 0) != (given.which_contacts.mark != 0) ||
      (given.separations != 0) != (given.which_separations.mark != 0))
    return fmt::format("contacts/{}/given: a mark of which answers without a count, or the reverse", name);
  if (judged > given.contacts + given.separations) return fmt::format("contacts/{}: more judged than given", name);
  if (!left_of(all.answers, {judged, missing}))
    return fmt::format("contacts/{}: more judged or none than answers", name);
  return std::nullopt;
}

Fault fault_of_pushed(const PushTally& pushed, const NormalTally& normal) {
  if (pushed.judged > normal.lengths || pushed.none > normal.none)
    return "contacts/pushed: more judged or none than normals that are given, or missing";
  if (pushed.nowhere > pushed.judged || pushed.flips > pushed.with_a_side())
    return "contacts/pushed: more nowhere than judged, or more flips than normals with a side";
  const double left = pushed.largest_left.best().value();
  if (left > 2 || (pushed.nowhere != 0 && left < 1) || (pushed.flips != 0 && left <= 1.0 / 16))
    return "contacts/pushed/largest_left: is above 2, or less than what flips and nowhere leave";
  return std::nullopt;
}

Fault fault_of_consistency(const ConsistencyTally& found, const ContactTally& all) {
  const GivenTally& given = all.separation->given;
  if (found.contacts != given.contacts || found.separations != given.separations)
    return "contacts/consistency: other contacts or separations than separation/given";
  if (found.judged > all.answers || !left_of(found.judged, {found.contacts, found.separations}) ||
      !left_of(found.judged, {found.positive, found.negative, found.missing}) || found.positive > found.contacts ||
      found.negative > found.separations)
    return "contacts/consistency: more answers that contradict themselves than answers with a number";
  return std::nullopt;
}

}  // namespace

std::optional<std::string> fault_of_contacts(TouchingPolicy policy, const FamilyCounts& counts) {
  if (!counts.contacts) return std::nullopt;
  const ContactTally& all = *counts.contacts;
  const VerdictTally& verdict = counts.verdict;
  if (all.separations > all.answers) return "contacts: more separations than answers";
  const std::uint64_t right_contacts = verdict.decided_contacts - verdict.false_separation,
                      right_separations = verdict.decided_separations - verdict.false_contact,
                      outside_touching = verdict.outside_limits.value_or(OutsideTally()).touching;
  // Where a kernel promises nothing of what touches, its answers there are in no count of verdicts.
  const std::uint64_t either =
      policy == TouchingPolicy::either ? counts.truth.touching - outside_touching - verdict.undecided_touching : 0;
  if (!all.decided) {
    if (all.answers - all.separations > right_contacts + verdict.false_contact + either ||
        all.separations > right_separations + verdict.false_separation + either)
      return "contacts: more answers or separations than verdicts that say so";
  } else if (all.separations != 0 || all.answers > right_contacts || all.answers > *all.decided ||
             *all.decided - all.answers > verdict.false_separation) {
    return "contacts: answers and decided do not fit the contacts that are right, and those that are missed";
  }
  if (all.missed && all.missed->through > all.decided.value_or(all.answers) - all.answers)
    return "contacts/missed: more through than missed";

  Fault fault;
  for_each_number(all, [&](MeasureKind kind, const auto& part) {
    if (part && !fault) fault = fault_of_number(all, name(kind), *part);
  });
  if (fault) return fault;
  if (all.time && left_of(all.answers, {all.time->none, all.time->invalid, all.time->judged()}) != 0)
    return "contacts/time: none, invalid, early, best and late do not add up to the answers";
  if (all.time && all.time->late_tunnels.through > all.time->late) return "contacts/time: more through than late";
  if (all.consistency && all.separation) {
    if ((fault = fault_of_consistency(*all.consistency, all))) return fault;
  }
  if (const auto& feature = all.feature) {
    if (feature->wrong > feature->judged || feature->unnamed > feature->wrong)
      return "contacts/feature: more wrong than judged, or more unnamed than wrong";
    if (feature->wrong == feature->unnamed && feature->largest_error.best() != 0)
      return "contacts/feature: a largest_error, and none is wrong that names a part";
  }
  if (const auto& normal = all.normal) {
    if (normal->judged > normal->lengths) return "contacts/normal: more judged than lengths";
    if (normal->largest_angle.best() > std::numbers::pi) return "contacts/normal: a largest_angle above pi";
    if (all.pushed && (fault = fault_of_pushed(*all.pushed, *normal))) return fault;
  }
  if (all.points && all.point_a && all.point_b) {
    if (all.point_a->judged != all.point_b->judged || all.points->judged > all.point_a->judged)
      return "contacts/points: more judged than points of each body, or these differ";
  }
  return std::nullopt;
}

std::optional<std::string> fault_of_sizes(const ContactTally& contacts) {
  const auto last_of = [](const auto& sizes) {
    std::size_t last = 0;
    for (std::size_t k = 0; k < sizes.size(); ++k) last = sizes[k] != 0 ? k : last;
    return last;
  };
  if (const auto& separation = contacts.separation) {
    const double error = separation->largest_error.best();
    const bool is_exact = separation->largest_ulps.best().is_zero();
    if (left_of(separation->judged, separation->by_decade) != 0 ||
        last_of(separation->by_decade) != (is_exact ? 0 : std::max(decade_of(error), std::size_t{1})))
      return "contacts/separation: by_decade does not fit judged and largest_error";
  }
  if (!contacts.time) return std::nullopt;
  for (const auto& [kind, errors, count] : {std::tuple("late", &contacts.time->late_errors, contacts.time->late),
                                            {"early", &contacts.time->early_errors, contacts.time->early}}) {
    if (left_of(count, errors->by_power) != 0 || last_of(errors->by_power) != ulp_power(errors->largest_ulps.best()))
      return fmt::format("contacts/time/{}_errors: by_power does not fit {} and largest_ulps", kind, kind);
  }
  return std::nullopt;
}

std::optional<std::string> fault_of_parts(const ContactTally& contacts, const Predicate& predicate,
                                          std::size_t measure_count) {
  Fault fault;
  const ContactTally given = given_contacts({}, predicate, measure_count);
  for_each_field<ContactTally>([&](const auto& of) {
    if constexpr (requires { (given.*of.member).has_value(); }) {
      const bool is_given = (given.*of.member).has_value();
      if (!fault && (contacts.*of.member).has_value() != is_given)
        fault = fmt::format("contacts/{}: is {}, though the kernel gives {} of that kind", of.name,
                            is_given ? "null" : "not null", is_given ? "a number" : "none");
    }
  });
  return fault;
}

std::optional<std::string> fault_of_image_numbers(const ImageNumbersRecord& numbers, std::uint64_t images) {
  using std::tuple;
  if (numbers.images > images || numbers.compared > numbers.images || numbers.lost > numbers.compared)
    return "numbers: more images with numbers than images, or more lost";
  if (numbers.features.value_or(0) > numbers.compared_features) return "numbers: more features than compared_features";
  if (numbers.largest_angle.value_or(0) > std::numbers::pi) return "numbers: a largest_angle above pi";
  for (const auto& [what, count, is_told] :
       {tuple("separations", numbers.separations, numbers.largest_separation.has_value()),
        {"angles", numbers.angles, numbers.largest_angle.has_value()},
        {"points", numbers.points, numbers.largest_point.has_value()},
        {"compared_features", numbers.compared_features, numbers.features.has_value()}}) {
    if (count > numbers.compared) return fmt::format("numbers: more {} than compared", what);
    if (is_told != (count != 0)) return fmt::format("numbers: {} without what came of it, or the reverse", what);
  }
  return std::nullopt;
}

std::optional<std::string> fault_of_asymmetry(const AsymmetryRecord& found) {
  using std::tuple;
  if (found.verdicts > found.images || found.images_with_comparisons > found.images ||
      found.comparisons.value_or(0) > found.images_with_comparisons)
    return "asymmetry: more verdicts or comparisons than images";
  if (found.first_verdict.has_value() != (found.verdicts != 0) ||
      found.first_comparison.has_value() != (found.comparisons.value_or(0) != 0))
    return "asymmetry: first_verdict or first_comparison without a count, or the reverse";
  if (!found.numbers) return std::nullopt;
  const ImageNumbersRecord& numbers = *found.numbers;
  // Images whose verdict is their base's.
  if (Fault fault = fault_of_image_numbers(numbers, found.images - found.verdicts)) return "asymmetry/" + *fault;
  for (const auto& [pair, is_there, is_due] :
       {tuple("worst_separation", numbers.worst_separation.has_value(), numbers.largest_separation.value_or(0) != 0),
        {"worst_angle", numbers.worst_angle.has_value(), numbers.largest_angle.value_or(0) != 0},
        {"worst_point", numbers.worst_point.has_value(), numbers.largest_point.value_or(0) != 0},
        {"first_feature", numbers.first_feature.has_value(), numbers.features.value_or(0) != 0},
        {"first_lost", numbers.first_lost.has_value(), numbers.lost != 0}}) {
    if (is_there != is_due) return fmt::format("asymmetry/numbers: {} without what it shows, or the reverse", pair);
  }
  return std::nullopt;
}

}  // namespace axiscert

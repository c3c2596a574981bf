#include "reports/run_folder/record_checks.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>
#include <tuple>
#include <vector>

#include "fuzz/text/json_form.h"
#include "reports/run_folder/run_folder.h"

namespace axiscert {
namespace {

using Fault = std::optional<std::string>;
using Names = std::vector<std::string_view>;

bool has(const Names& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

template <class One>
Names names_of(const std::vector<One>& all) {
  Names names;
  for (const One& one : all) names.push_back(one.name);
  return names;
}

Names group_names(const PredicateEntry& entry) { return names_of(groups_of(entry)); }

bool is_of(const GroupNumbers& numbers, const ColumnGroup& group) { return numbers.numbers.size() == group.size; }
bool is_of(const std::optional<GroupNumbers>& numbers, const ColumnGroup& group) {
  return !numbers || is_of(*numbers, group);
}

template <class Numbers>
const PredicateEntry* entry_of_numbers(const Predicate& predicate, const NamedValues<Numbers>& numbers) {
  const auto fits = [&](const ColumnGroup& group) {
    const Numbers* found = numbers.find(group.name);
    return found != nullptr && is_of(*found, group);
  };
  // One entry's groups may be among another's: that with most is meant.
  const PredicateEntry* found = nullptr;
  std::size_t most = 0;
  for (const PredicateEntry& entry : predicate.entries) {
    const std::vector<ColumnGroup> groups = groups_of(entry);
    if (groups.size() <= most || !std::all_of(groups.begin(), groups.end(), fits)) continue;
    found = &entry;
    most = groups.size();
  }
  return found;
}

class NameCheck {
 public:
  explicit NameCheck(const Record& record)
      : record_(record),
        predicate_(predicate_of(record.plan)),
        clauses_(names_of(predicate_.clauses)),
        comparisons_(names_of(predicate_.comparisons)) {}

  Fault check() const {
    if (Fault fault = unknown("tolerance", "comparison", record_.plan.tolerance, comparisons_)) return fault;
    for (const KernelRecord& kernel : record_.kernels) {
      for (const auto& [family, result] : kernel.families) {
        const std::string where = fmt::format("kernel {} in {}, family {}", json_of(kernel.id).dump(),
                                              name(kernel.precision), json_of(family).dump());
        if (Fault fault = all_and_no_other(where, "axis", result.axes, clauses_)) return fault;
        if (Fault fault = all_and_no_other(where, "comparison", result.comparisons, comparisons_)) return fault;
      }
    }
    for (const FindingRecord& finding : record_.findings) {
      const std::string where =
          fmt::format("finding {} of kernel {}", json_of(finding.kind).dump(), json_of(finding.kernel).dump());
      if (Fault fault = check_numbers(where, finding)) return fault;
    }
    for (const WitnessRecord& witness : record_.witnesses) {
      if (Fault fault = check_witness(witness)) return fault;
    }
    return std::nullopt;
  }

 private:
  Fault check_witness(const WitnessRecord& witness) const {
    const std::string where = fmt::format("witness {}", json_of(witness.id).dump());
    if (Fault fault = check_numbers(where, witness)) return fault;
    const auto check_bits = [&](const std::optional<BitText>& bits, const char* member) -> Fault {
      if (!bits || bits->size() == comparisons_.size()) return std::nullopt;
      return fmt::format("{}: {} is {}, but the predicate {} has {} comparisons", where, member, json_of(*bits).dump(),
                         predicate_.id, comparisons_.size());
    };
    if (Fault fault = check_bits(witness.exact_comparisons, "exact_comparisons")) return fault;
    if (Fault fault = check_bits(witness.computed_comparisons, "computed_comparisons")) return fault;
    return witness.sides ? unknown(where + ", sides", "comparison", *witness.sides, comparisons_) : std::nullopt;
  }

  template <class Value>
  Fault unknown(const std::string& where, const char* kind, const NamedValues<Value>& given, const Names& names) const {
    for (const auto& [name, ignored] : given) {
      if (has(names, name)) continue;
      return fmt::format("{}: the predicate {} has no {} {}; it has: {}", where, predicate_.id, kind,
                         json_of(name).dump(), fmt::join(names, ", "));
    }
    return std::nullopt;
  }

  template <class Value>
  Fault all_and_no_other(const std::string& where, const char* kind, const std::optional<NamedValues<Value>>& given,
                         const Names& names) const {
    if (!given) return std::nullopt;
    if (Fault fault = unknown(where, kind, *given, names)) return fault;
    for (const std::string_view name : names) {
      if (!given->contains(name))
        return fmt::format("{}: without {} {} of the predicate {}", where, kind, name, predicate_.id);
    }
    return std::nullopt;
  }

  // The numbers of a query: those of one entry of the predicate, in its groups.
  Fault check_numbers(const std::string& where, const auto& query) const {
    const PredicateEntry* entry = entry_of(predicate_, query);
    if (entry == nullptr) {
      return fmt::format("{}: without the numbers of a query of {}: {}", where, predicate_.id,
                         fmt::join(group_names(predicate_.entries.front()), ", "));
    }
    const Names groups = group_names(*entry);
    for (const auto& [name, ignored] : query.numbers) {
      if (has(groups, name)) continue;
      return fmt::format("{}: {} is not a member, nor a name of numbers of the predicate {}, which are: {}", where,
                         json_of(name).dump(), predicate_.id, fmt::join(groups, ", "));
    }
    return std::nullopt;
  }

  const Record& record_;
  const Predicate& predicate_;
  Names clauses_, comparisons_;
};

}  // namespace

std::optional<std::string> fault_of_names(const Record& record) { return NameCheck(record).check(); }

const PredicateEntry* entry_of(const Predicate& predicate, const WitnessRecord& query) {
  return entry_of_numbers(predicate, query.numbers);
}
const PredicateEntry* entry_of(const Predicate& predicate, const FindingRecord& query) {
  return entry_of_numbers(predicate, query.numbers);
}

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

// Whether so many parts are at most the whole. A sum of forged counts may wrap: each is taken from what is left.
bool fit(std::uint64_t whole, std::initializer_list<std::uint64_t> parts) {
  return std::ranges::all_of(parts, [&](std::uint64_t part) {
    const bool fits = part <= whole;
    whole -= fits ? part : 0;
    return fits;
  });
}

// Of queries with these truths, the contacts and separations that a verdict can be right on, by the promise of touch.
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
  if (!fit(counts.trials, {truth.separated, truth.contact, truth.invalid}) ||
      truth.separated + truth.contact + truth.invalid != counts.trials)
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
      !fit(outside.trials, {outside.decided_contacts, outside.decided_separations, outside.unanswered}) ||
      outside.false_separation > outside.decided_contacts || outside.false_contact > outside.decided_separations)
    return "more decided, wrong or missing answers outside the limits than queries there";

  // Within, each valid query has one answer.
  if (verdict.undecided_contact > verdict.undecided ||
      verdict.undecided_touching > std::min(verdict.undecided_contact, touching))
    return "undecided_contact and undecided_touching do not fit undecided and the truth";
  const auto [declined_contacts, declined_separations] = by_promise(
      policy, verdict.undecided_contact, verdict.undecided_touching, verdict.undecided - verdict.undecided_contact);
  if (!fit(contacts, {verdict.decided_contacts, declined_contacts}) ||
      !fit(separations, {verdict.decided_separations, declined_separations}))
    return "more decided and undecided answers than contacts, or than separations";
  if (verdict.false_separation > verdict.decided_contacts || verdict.false_contact > verdict.decided_separations)
    return "more false_separation or false_contact verdicts than decided queries";
  // What touches is right or wrong where a kernel promises something of it, and else in no count of decided queries.
  const std::uint64_t answered_touching = touching - verdict.undecided_touching,
                      judged_touching = policy == TouchingPolicy::either ? 0 : answered_touching,
                      without_verdict = verdict.invalid + verdict.unanswered,
                      answers = verdict.decided() + verdict.undecided + without_verdict;
  if (!fit(valid, {verdict.decided_contacts, verdict.decided_separations, verdict.undecided, verdict.invalid,
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
      !fit(clear.queries, {clear.decided_contacts, clear.decided_separations, clear.undecided}) ||
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

}  // namespace axiscert

#include "reports/certificate/breaks.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

#include "fuzz/files/corpus.h"
#include "fuzz/queries/capabilities.h"
#include "fuzz/queries/family.h"
#include "fuzz/text/json_form.h"
#include "reports/certificate/statement.h"
#include "reports/run_folder/identity.h"
#include "reports/run_folder/run_folder.h"
#include "reports/wording/causes.h"
#include "reports/wording/everyday.h"
#include "reports/wording/reproduce.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

const Situation* situation_of(const Predicate& predicate, std::string_view name) {
  for (const Family* family : families_of(predicate)) {
    if (family->name == name) return family->situation;
  }
  return name == corpus_name ? &of_corpus : &capabilities_of(predicate).situations->own;
}

}  // namespace

std::vector<WrongVerdicts> wrong_situations(const Record& record, const std::string& kernel) {
  std::vector<WrongVerdicts> found;
  const Predicate& predicate = predicate_of(record.plan);
  const Situations* situations = capabilities_of(predicate).situations;
  if (situations == nullptr) return found;
  std::vector<const Situation*> in_order(situations->of_families.begin(), situations->of_families.end());
  in_order.insert(in_order.end(), {&of_corpus, &situations->own});
  for (const Situation* situation : in_order) {
    for (const KernelRecord* entry : precision_entries(record, kernel)) {
      WrongVerdicts wrong{situation, entry->precision};
      std::vector<std::pair<double, std::string>> families;  // by their deepest
      for (const auto& [family, result] : entry->families) {
        const VerdictTally& verdict = result.verdict;
        if (situation_of(predicate, family) != situation) continue;
        if (verdict.false_separation + verdict.false_contact == 0) continue;
        const double missed = verdict.deepest_false_separation.best(), phantom = verdict.deepest_false_contact.best();
        wrong.missed += verdict.false_separation;
        wrong.phantom += verdict.false_contact;
        wrong.deepest_missed = std::max(wrong.deepest_missed, missed);
        wrong.deepest_phantom = std::max(wrong.deepest_phantom, phantom);
        families.emplace_back(std::max(missed, phantom), family);
      }
      if (families.empty()) continue;
      std::ranges::stable_sort(families, [](const auto& x, const auto& y) { return x.first > y.first; });
      for (const auto& [depth, family] : families) wrong.families.push_back(family);
      found.push_back(std::move(wrong));
    }
  }
  return found;
}

const WrongVerdicts* first_situation(const std::vector<WrongVerdicts>& situations, bool& missed) {
  for (const bool is_missed : {true, false}) {
    missed = is_missed;
    for (const WrongVerdicts& entry : situations) {
      if (entry.deepest(is_missed) >= visible_depth) return &entry;
    }
  }
  for (const bool is_missed : {true, false}) {
    missed = is_missed;
    const WrongVerdicts* deepest = nullptr;
    for (const WrongVerdicts& entry : situations) {
      if (entry.count(is_missed) != 0 && (!deepest || entry.deepest(is_missed) > deepest->deepest(is_missed)))
        deepest = &entry;
    }
    if (deepest) return deepest;
  }
  return nullptr;
}

namespace {

// A cause of wrong verdicts of one kind.
struct Cause {
  std::string name, meaning;
  std::string_view advice, section;
  std::uint64_t count;
  double deepest;
};
Cause cause_of(std::string_view name, const CauseWords& words, std::uint64_t count, double deepest) {
  return {std::string(name), std::string(words.meaning), words.advice, words.section, count, deepest};
}

// A fault other than a wrong answer comes before all causes of these.
constexpr CauseWords of_finding = {"", "The kernel does not answer as a kernel has to: mend that before anything else.",
                                   "docs/error_model.md#findings"};

BreakStatement break_by(std::optional<Precision> precision, const std::string& what, const Cause& cause) {
  return {precision,    what,         cause.name, cause.meaning, cause.count, amount(cause.deepest, 3),
          cause.advice, cause.section};
}

// The deepest cause of a kind of wrong verdict in a kernel's entry: `missed` or phantom contacts.
std::optional<Cause> deepest_cause(const Record& record, const KernelRecord& kernel, bool missed) {
  std::optional<Cause> deepest;
  const auto offer = [&](Cause cause) {
    if (cause.count != 0 && (!deepest || cause.deepest > deepest->deepest)) deepest = std::move(cause);
  };
  // By the class of its input, where the links do not say why.
  for (const auto& [family, result] : kernel.families) {
    if (!result.classes) continue;
    for (const auto& [which, found] : *result.classes) {
      offer(cause_of(name(which), class_words[which], missed ? found.false_separation : found.false_contact,
                     found.deepest.best()));
    }
  }
  if (deepest) return deepest;
  // Else by the links of its witnesses.
  const std::optional<FamilyRecord> total = all_families(kernel);
  if (!total) return std::nullopt;
  const VerdictTally& verdict = total->verdict;
  const std::uint64_t count = missed ? verdict.false_separation : verdict.false_contact;
  if (count == 0) return std::nullopt;
  const FlipKind kind = missed ? FlipKind::false_separation : FlipKind::false_contact;
  for (const WitnessRecord& witness : record.witnesses) {
    if (witness.kernel != kernel.id || witness.precision != kernel.precision || !witness.depth) continue;
    for (const FlipRecord& flip : witness.flips) {
      if (flip.level != Level::verdict || flip.kind != kind) continue;
      for (const Link link : enumerators<Link>) {
        if (std::find(flip.links.begin(), flip.links.end(), link) != flip.links.end())
          offer(cause_of(name(link), link_words[link], count, *witness.depth));
      }
    }
  }
  if (deepest) return deepest;
  const Link unknown = Link::unattributed;
  return cause_of(name(unknown), link_words[unknown], count,
                  (missed ? verdict.deepest_false_separation : verdict.deepest_false_contact).best());
}

// A class of queries within which the kernel is wrong and elsewhere right says more than any count.
constexpr CauseWords of_traits = {"", "Look at the branch that such queries take: `axiscert check` the witness.",
                                  "docs/error_model.md#the-cause"};

std::optional<BreakStatement> break_of_traits(const Record& record, const std::string& kernel) {
  for (const KernelRecord& entry : record.kernels) {
    if (entry.id != kernel || !entry.cause || !entry.cause->is_known) continue;
    const std::optional<FamilyRecord> total = all_families(entry);
    if (!total) continue;
    const VerdictTally& verdict = total->verdict;
    const bool is_missed = entry.cause->direction != CauseDirection::phantom;
    return break_by(entry.precision, is_missed ? "missed contact" : "phantom contact",
                    {std::string(cause_of_traits), entry.cause->sentence(), of_traits.advice, of_traits.section,
                     is_missed ? verdict.false_separation : verdict.false_contact,
                     (is_missed ? verdict.deepest_false_separation : verdict.deepest_false_contact).best()});
  }
  return std::nullopt;
}

// The query alone, by the groups of its predicate's columns in whichever entry it is.
Json query_of(const WitnessRecord& witness, const Predicate& predicate) {
  Json query = Json::object();
  if (const std::string_view name = written_name(predicate); !name.empty()) query["predicate"] = name;
  for (const PredicateEntry& entry : predicate.entries) {
    for (const ColumnGroup& group : groups_of(entry)) {
      if (const GroupNumbers* numbers = witness.numbers.find(group.name))
        query[std::string(group.name)] = json_of(*numbers);
    }
  }
  return query;
}

// "missed contacts in families x, y, up to 0.4 of the scene deep"
std::string failures_text(const WrongVerdicts& wrong, bool missed) {
  constexpr std::size_t most = 3;
  std::vector<std::string> families = wrong.families;
  const std::size_t more = families.size() - std::min(most, families.size());
  families.resize(families.size() - more);
  return fmt::format("{} in {} {}{}, up to {} of the scene deep", missed ? "missed contacts" : "phantom contacts",
                     families.size() + more == 1 ? "the family" : "the families", fmt::join(families, ", "),
                     more == 0 ? "" : fmt::format(" and {} more", more), amount(wrong.deepest(missed), 3));
}

BreakStatement break_of_situation(const WrongVerdicts& wrong, bool missed) {
  const Situation& situation = *wrong.situation;
  return {wrong.precision,     missed ? "missed contact" : "phantom contact",
          situation.name,      fmt::format("{}: {}", situation.meaning, failures_text(wrong, missed)),
          wrong.count(missed), amount(wrong.deepest(missed), 3),
          situation.advice,    situation.section};
}

}  // namespace

std::optional<BreakStatement> what_breaks_first(const Record& record, const std::string& kernel) {
  for (const FindingRecord& finding : record.findings) {
    if (finding.kernel == kernel)
      return break_by(std::nullopt, "finding",
                      {"finding", finding_text(finding), of_finding.advice, of_finding.section, finding.count, 0});
  }
  if (const auto by_traits = break_of_traits(record, kernel)) return by_traits;
  for (const bool missed : {true, false}) {
    std::optional<Cause> deepest;
    std::optional<Precision> precision;
    for (const KernelRecord* entry : precision_entries(record, kernel)) {
      const std::optional<Cause> cause = deepest_cause(record, *entry, missed);
      if (!cause || (deepest && cause->deepest <= deepest->deepest)) continue;
      deepest = cause;
      precision = entry->precision;
    }
    if (!deepest) continue;
    // Where only the verdict is seen, the situation says more than that nothing is known.
    if (deepest->name == name(Link::unattributed)) break;
    return break_by(precision, missed ? "missed contact" : "phantom contact", *deepest);
  }
  bool missed = true;
  const std::vector<WrongVerdicts> situations = wrong_situations(record, kernel);
  const WrongVerdicts* first = first_situation(situations, missed);
  if (first == nullptr) return std::nullopt;
  return break_of_situation(*first, missed);
}

std::vector<SituationStatement> where_it_is_wrong(const Record& record, const std::string& kernel) {
  std::vector<SituationStatement> situations;
  for (const WrongVerdicts& wrong : wrong_situations(record, kernel)) {
    situations.push_back({wrong.precision, wrong.situation->name, wrong.situation->meaning,
                          std::vector<SaidText>(wrong.families.begin(), wrong.families.end()), wrong.missed,
                          amount(wrong.deepest_missed, 3), wrong.phantom, amount(wrong.deepest_phantom, 3),
                          wrong.situation->advice, wrong.situation->section});
  }
  return situations;
}

std::vector<std::string_view> advised_sections() {
  std::vector<std::string_view> sections = {of_finding.section, of_traits.section};
  for (const CauseWords& words : class_words) sections.push_back(words.section);
  for (const CauseWords& words : link_words) sections.push_back(words.section);
  return sections;
}

std::vector<CertificateWitness> worst_of_certificate(const Record& record, const std::string& kernel) {
  constexpr std::size_t most = 3;
  Record own = record;
  std::erase_if(own.witnesses, [&](const WitnessRecord& witness) { return witness.kernel != kernel; });
  std::vector<CertificateWitness> worst;
  std::set<std::string> families;
  std::vector<const WitnessRecord*> ordered = worst_witnesses(own, own.witnesses.size());
  if (const WitnessRecord* first = worst_scene(own)) ordered.insert(ordered.begin(), first);
  for (const bool another_family : {true, false}) {
    for (const WitnessRecord* witness : ordered) {
      if (worst.size() == most) return worst;
      const bool is_there = std::ranges::any_of(worst, [&](const auto& w) { return w.address == witness->address; });
      if (is_there || (another_family && !families.insert(witness->family).second)) continue;
      const Json query = query_of(*witness, predicate_of(record.plan));
      const std::string_view truth = witness->touching ? "touching" : name(witness->truth);
      const std::string share =
          witness->depth ? fmt::format("{} of the scene", amount(*witness->depth, 3)) : std::string();
      const std::string length = length_words(witness->family, witness->length.value_or(0), record.plan);
      const std::string size = length.empty() ? share : length, rest = length.empty() ? "" : ", " + share;
      const std::string depth = size.empty() ? ""
                                : witness->computed == Verdict::separated
                                    ? fmt::format(", {} deep{}", size, rest)
                                    : fmt::format(", across a gap of {}{}", size, rest);
      worst.push_back({fmt::format("{} {}, family {}", kernel, name(witness->precision), witness->family),
                       fmt::format("The truth is {}, the kernel says {}{}. Address {}.", truth, name(witness->computed),
                                   depth, witness->address),
                       std::string(witness->address),
                       replay_command(*witness, record.plan),
                       {without_fractions(query)}});
    }
  }
  return worst;
}

}  // namespace axiscert

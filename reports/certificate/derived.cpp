#include "reports/certificate/derived.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "fuzz/instruments/effort.h"
#include "fuzz/instruments/safe_margin.h"
#include "fuzz/text/json_form.h"
#include "fuzz/queries/source.h"
#include "fuzz/text/number_text.h"
#include "kernel/base/error.h"
#include "kernel/base/version.h"
#include "kernel/names.h"
#include "reports/certificate/margin.h"
#include "reports/certificate/breaks.h"
#include "reports/certificate/levels.h"
#include "reports/certificate/canonical.h"
#include "reports/certificate/statement.h"
#include "reports/wording/evidence.h"
#include "reports/run_folder/identity.h"
#include "reports/run_folder/run_folder.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

constexpr const char* effort_of_replies = "replies";

// The kernel with what it promises and shows, as its entries of the record have it.
void put_kernel(KernelStatement& kernel, const Record& record) {
  const std::vector<const KernelRecord*> entries = precision_entries(record, kernel.id);
  const KernelRecord& entry = *entries.front();
  kernel.precisions.clear();
  for (const KernelRecord* each : entries) kernel.precisions.push_back(each->precision);
  kernel.exposes = entry.exposes;
  kernel.touching = entry.touching;
  kernel.may_decline = entry.may_decline;
  kernel.limits.reset();
  if (has_limits(entry)) kernel.limits = limits_text(entry);
  kernel.summary = entry.summary;
}

AskedStatement asked_of(const CertificatePredicate& predicate, const Record& record) {
  Evidence all;
  std::uint64_t queries = 0;
  for (const KernelRecord* entry : precision_entries(record, predicate.kernel.id)) {
    all.add(evidence_of(*entry));
    for (const auto& [family, result] : entry->families) queries += result.trials;
  }
  const std::vector<Name>& families = record.plan.families;
  return {predicate.asked.effort,
          record.plan.seed,
          predicate.materials.tallies.size(),
          queries,
          all.contacts,
          all.separations,
          all.decided(),
          {queries - all.population, all.outside, all.touching, all.declined(), all.declined_contacts, all.invalid,
           all.unanswered},
          std::vector<SaidText>(families.begin(), families.end())};
}

// Every kernel of the run, on the same queries.
std::vector<ComparisonStatement> comparison_of(const Record& record) {
  std::vector<ComparisonStatement> rows;
  for (const KernelRecord& entry : record.kernels) {
    const auto total = all_families(entry);
    if (!total) continue;
    const VerdictTally& verdict = total->verdict;
    const auto ulps = [](const std::optional<double>& error) -> std::optional<TextNumber> {
      if (!error) return std::nullopt;
      return amount(*error, 3);
    };
    ComparisonStatement& row = rows.emplace_back();
    row.kernel = std::string(entry.id);
    row.precision = entry.precision;
    const Evidence evidence = evidence_of(entry);
    row.looked_at = evidence.decided();
    row.undecided = verdict.undecided;
    row.invalid = verdict.invalid;
    row.unanswered = verdict.unanswered;
    row.median_ulps = ulps(entry.critical_radius.median_ulps);
    row.largest_ulps = ulps(entry.critical_radius.largest_ulps);
    if (evidence.decided_for(FlipKind::false_separation) != 0) {
      row.missed = verdict.false_separation;
      row.deepest_missed = amount(verdict.deepest_false_separation.best(), 3);
    }
    if (evidence.decided_for(FlipKind::false_contact) != 0) {
      row.phantom = verdict.false_contact;
      row.deepest_phantom = amount(verdict.deepest_false_contact.best(), 3);
    }
  }
  return rows;
}

// Sentences that say what the certificate leaves open.
std::vector<SaidText> limits_of(const CertificatePredicate& predicate) {
  const KernelStatement& kernel = predicate.kernel;
  std::vector<SaidText> limits;
  const auto say = [&](std::string sentence) { limits.emplace_back(std::move(sentence)); };
  say("What is met was observed on queries that these families make, but for what `proved` says there: no number of "
      "queries proves it for others, and the bounds are of rates in these families, not in a game.");
  if (kernel.exposes.size() == 1)
    say("The kernel shows its verdict alone: why it is wrong was inferred from the input, and not seen.");
  const HarnessStatement& harness = predicate.harness;
  for (const auto& [precision, score] : harness.score) {
    if (score.judged == 0) {
      say(
          fmt::format("Of {} faults planted in a right kernel that shows as much, none was asked a valid query in {}: "
                      "how many such a run notices is not known.",
                      score.mutants, precision));
      continue;
    }
    say(
        fmt::format("Of {} faults planted in a right kernel that shows as much, {} were not noticed in {}: a fault as "
                    "small as those may be in this kernel too.",
                    score.mutants, score.survived, precision));
  }
  if (harness.reason) say(fmt::format("How many faults such a run notices was not asked: {}.", *harness.reason));
  if (predicate.search.reason) say(fmt::format("No search was made: {}.", *predicate.search.reason));
  else say("A search gives lower bounds of the worst: it says nothing about what it did not find.");
  if (!predicate.safe_margin.reason)
    say("The safe margin mends what was seen here; a contact that nothing here showed may need more.");
  say("The search, the growths of the safe margin and the sizes and shapes that its parts name, the diagnosis, the "
      "planted faults and the witnesses are stated by "
      "whoever made this: no count here shows them. So are the counts of images, the numbers of triangles, the medians "
      "of "
      "critical radii, the findings of loading and what the kernel says of itself, which a recheck asks again. "
      "Everything "
      "else follows from the counts.");
  if (kernel.limits)
    say(fmt::format("The kernel promises to be right only there: {}; it was held to nothing else.", *kernel.limits));
  if (kernel.may_decline) say("The kernel may decline: what it does not decide has to be asked of another predicate.");
  if (kernel.kind == KernelKind::replies)
    say("The subject is replies: what gave them, and whether it gives them again, is not known.");
  else if (kernel.kind == KernelKind::built_in) {
    say("The subject is the kernel as axiscert's sources have it, built without contraction: an engine's copy of it, "
        "or "
        "another compiler's, is another kernel.");
  } else {
    say("The subject is these files as they were called here: the libraries that they load, and the machine, are not "
        "part of it.");
  }
  return limits;
}

// Equal values in whatever order their members are.
template <class T>
bool is_same(const T& x, const T& y) {
  return canonical_json(json_of(x)) == canonical_json(json_of(y));
}

std::string level_text(const LevelStatement& level) {
  return fmt::format("{} in {}", level.level, level.precision ? name(*level.precision) : "-");
}

// "not met: tangent: missed contacts: 3".
std::string state_words(const LevelStatement& level) {
  const std::string_view state = name(level.state);
  if (level.state == LevelState::not_met && !level.failures.empty())
    return fmt::format("{}: {}", state, level.failures.front());
  return level.reason ? fmt::format("{}: {}", state, *level.reason) : std::string(state);
}

// `has_our_words`: it was made by this axiscert, so that sentences are compared too.
void require_levels(const std::vector<LevelStatement>& stated, const std::vector<LevelStatement>& derived,
                    bool has_our_words, const std::string& name) {
  if (is_same(stated, derived)) return;
  for (const LevelStatement& level : stated) {
    const auto is_it = [&](const LevelStatement& other) { return other.is_same_question(level); };
    if (std::ranges::none_of(derived, is_it))
      throw NotValid(fmt::format("{}: it states {} {}, and its counts say nothing of it", name, level_text(level),
                                 axiscert::name(level.state)));
  }
  for (const LevelStatement& level : derived) {
    const auto is_it = [&](const LevelStatement& other) { return other.is_same_question(level); };
    const auto found = std::ranges::find_if(stated, is_it);
    // Another axiscert may have had no such level; one that is refused is not left out.
    if (found == stated.end() && !has_our_words && level.state != LevelState::not_met) continue;
    if (found == stated.end())
      throw NotValid(
          fmt::format("{}: it leaves out the level {}, which is {}", name, level_text(level), state_words(level)));
    if (found->state != level.state) {
      throw NotValid(fmt::format("{}: it states {} {}, and its counts say: {}", name, level_text(level),
                                 axiscert::name(found->state), state_words(level)));
    }
    if (has_our_words && !is_same(*found, level)) {
      throw NotValid(fmt::format("{}: what it states of {} is not what its counts say: {}", name, level_text(level),
                                 canonical_json(json_of(level))));
    }
  }
  if (has_our_words || stated.size() > derived.size())
    throw NotValid(fmt::format("{}: its levels are not in their order, each once", name));
}

void require_comparison(const std::vector<ComparisonStatement>& stated, const std::vector<ComparisonStatement>& derived,
                        const std::string& name) {
  if (is_same(stated, derived)) return;
  for (std::size_t i = 0; i < std::min(stated.size(), derived.size()); ++i) {
    const Json row = json_of(stated[i]), counted = json_of(derived[i]);
    for (const auto& [member, value] : counted.items()) {
      if (row[member] == value) continue;
      throw NotValid(fmt::format("{}: its comparison states {} {} of {} in {}, and its counts say {}", name, member,
                                 shown(row[member].dump()), derived[i].kernel, axiscert::name(derived[i].precision),
                                 value.dump()));
    }
  }
  throw NotValid(
      fmt::format("{}: its comparison has {} rows, and its counts make {}", name, stated.size(), derived.size()));
}

bool is_class(const std::string& cause) {
  return std::ranges::find(input_class_names, cause) != input_class_names.end();
}

std::uint64_t broken_links(const VerdictTally& verdict, const std::string& link) {
  for (const Link one : enumerators<Link>) {
    if (link == name(one)) return verdict.links[one];
  }
  return 0;
}

// A link as the cause is known of a witness alone: then it is one of those that the counts have.
bool breaks_by_link(const std::optional<BreakStatement>& stated, const std::optional<BreakStatement>& derived,
                    const Record& record, const std::string& kernel) {
  if (derived && (derived->cause == "finding" || derived->cause == cause_of_traits || is_class(derived->cause)))
    return false;
  bool is_any_missed = false, is_any_phantom = false, is_there = false;
  const bool is_missed = stated && stated->what == "missed contact";
  for (const KernelRecord* entry : precision_entries(record, kernel)) {
    const auto total = all_families(*entry);
    if (!total) continue;
    const VerdictTally& verdict = total->verdict;
    is_any_missed = is_any_missed || verdict.false_separation != 0;
    is_any_phantom = is_any_phantom || verdict.false_contact != 0;
    if (!stated || stated->precision != entry->precision) continue;
    const std::uint64_t count = is_missed ? verdict.false_separation : verdict.false_contact;
    is_there = stated->count == count && count != 0 && broken_links(verdict, stated->cause) != 0;
  }
  if (!stated) return !is_any_missed && !is_any_phantom && !derived;
  return is_there && is_any_missed == is_missed && (is_missed || stated->what == "phantom contact");
}

void require_breaks(const std::optional<BreakStatement>& stated, const std::optional<BreakStatement>& derived,
                    const Record& record, const std::string& kernel, const std::string& name) {
  if (stated && is_same(stated, derived)) return;
  if (breaks_by_link(stated, derived, record, kernel)) return;
  throw NotValid(fmt::format("{}: what it states to break first is not what its counts say{}", name,
                             derived ? ": " + shown(canonical_json(json_of(derived))) : ""));
}

void require_asked(const Json& stated, const Json& derived, const std::string& name) {
  for (const auto& [member, value] : derived.items()) {
    if (is_same(stated[member], value)) continue;
    throw NotValid(fmt::format("{}: it states `{}` {}, and its plan and counts say {}", name, member,
                               shown(canonical_json(stated[member])), shown(canonical_json(value))));
  }
}

void require_margins(const CertificatePredicate& predicate, const Record& record, const std::string& name) {
  const auto& [reason, margins] = predicate.safe_margin;
  if (reason.has_value() != margins.empty())
    throw NotValid(fmt::format("{}: it has no safe margin, and no reason, or both", name));
  if (reason) {
    const KernelStatement& kernel = predicate.kernel;
    const Predicate& question = find_predicate(kernel.question);
    const bool is_first_entry = kernel.entry == question.entries.front().name;
    const bool could_be_asked = kernel.kind != KernelKind::replies && is_first_entry && has_sphere_radius(question, 0);
    if (could_be_asked && !reason->starts_with(margin_answered_otherwise)) {
      throw NotValid(fmt::format("{}: it has no safe margin, which every kernel of {} has, and says why: {}", name,
                                 question.id, shown(Json(*reason).dump())));
    }
    return;
  }
  const std::vector<const KernelRecord*> entries = precision_entries(record, predicate.kernel.id);
  if (margins.size() != entries.size())
    throw NotValid(fmt::format("{}: it has safe margins of {} of {} precisions", name, margins.size(), entries.size()));
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const MarginStatement& margin = margins[i];
    std::string fault;
    if (margin.precision != entries[i]->precision) fault = "its precisions are in another order";
    else fault = margin_fault(margin, *entries[i]);
    if (!fault.empty())
      throw NotValid(fmt::format("{}: its safe margin in {}: {}", name, axiscert::name(margin.precision), fault));
  }
}

}  // namespace

bool is_made_by_this(const CertificatePredicate& predicate) {
  return predicate.materials.axiscert.sources == source_digests().sources;
}

CertificatePredicate derived_predicate(CertificatePredicate predicate, const Record& record) {
  const std::string& id = predicate.kernel.id;
  put_kernel(predicate.kernel, record);
  predicate.asked = asked_of(predicate, record);
  predicate.levels = levels_of(record, id, predicate.search.precisions, predicate.diagnosis.precisions);
  predicate.comparison = comparison_of(record);
  predicate.situations = where_it_is_wrong(record, id);
  predicate.breaks_first = what_breaks_first(record, id);
  predicate.limits = limits_of(predicate);
  return predicate;
}

Record require_derived(const CertificatePredicate& predicate, const std::string& name) {
  Record record = reduced_record(predicate, name);
  require_effort(predicate, name);
  const CertificatePredicate derived = derived_predicate(predicate, record);
  const bool has_our_words = is_made_by_this(predicate);
  if (const SaidText& version = predicate.materials.axiscert.version; has_our_words && version != axiscert_version) {
    throw NotValid(fmt::format("{}: it states version {} of axiscert, and its sources are those of {}", name,
                               shown(Json(version).dump()), axiscert_version));
  }
  require_asked(json_of(predicate.kernel), json_of(derived.kernel), name + ": of its kernel");
  require_asked(json_of(predicate.asked), json_of(derived.asked), name);
  if (has_our_words) require_usual_stretches(predicate, name);
  require_levels(predicate.levels, derived.levels, has_our_words, name);
  require_margins(predicate, record, name);
  require_comparison(predicate.comparison, derived.comparison, name);
  if (!has_our_words) return record;
  const auto require_same = [&](const char* member, const auto& stated, const auto& counted) {
    if (is_same(stated, counted)) return;
    throw NotValid(fmt::format("{}: its {} are not those that follow from its counts: {}", name, member,
                               shown(canonical_json(json_of(counted)))));
  };
  require_same("situations", predicate.situations, derived.situations);
  require_same("limits", predicate.limits, derived.limits);
  require_breaks(predicate.breaks_first, derived.breaks_first, record, predicate.kernel.id, name);
  return record;
}

bool has_answers(const Record& record, const std::string& kernel) {
  return std::ranges::all_of(precision_entries(record, kernel),
                             [](const KernelRecord* entry) { return evidence_of(*entry).decided() != 0; });
}

void require_effort(const CertificatePredicate& predicate, const std::string& name) {
  const std::string& effort = predicate.asked.effort;
  const KernelKind kind = predicate.kernel.kind;
  if ((effort == effort_of_replies) != (kind == KernelKind::replies))
    throw NotValid(fmt::format("{}: effort {} of a kernel that is {}", name, effort, axiscert::name(kind)));
  if (kind == KernelKind::replies) return;
  const Json& plan = predicate.materials.plan.plan.json;
  const Predicate& question = find_predicate(plan["predicate"].get<std::string>());
  for (const auto& [family, by_precision] : plan["trials"].items()) {
    if (is_query_list(family)) continue;  // as they are
    const std::uint64_t asks = trials_of(parse_effort(effort), question, family, kind != KernelKind::built_in);
    for (const auto& [precision, trials] : by_precision.items()) {
      if (trials == asks) continue;
      throw NotValid(fmt::format("{}: effort {} asks {} queries of `{}` in {}, and its plan has {}", name, effort,
                                 thousands(asks), family, precision, thousands(trials.get<std::uint64_t>())));
    }
  }
}

}  // namespace axiscert

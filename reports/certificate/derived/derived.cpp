#include "reports/certificate/derived/derived.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "fuzz/certify/effort.h"
#include "fuzz/certify/safe_margin.h"
#include "fuzz/text/number_text.h"
#include "kernel/base/error.h"
#include "kernel/base/version.h"
#include "kernel/names.h"
#include "reports/certificate/derived/margin_check.h"
#include "reports/certificate/derived/reduced.h"
#include "reports/certificate/findings/breaks.h"
#include "reports/certificate/findings/levels.h"
#include "reports/certificate/statement/canonical.h"
#include "reports/certificate/statement/statement.h"
#include "reports/evidence/evidence.h"
#include "reports/run_folder/run_folder.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

constexpr const char* effort_of_replies = "replies";

std::vector<const KernelRecord*> entries_of(const Record& record, const std::string& kernel) {
  std::vector<const KernelRecord*> entries;
  for (const KernelRecord& entry : record.kernels) {
    if (entry.id == kernel) entries.push_back(&entry);
  }
  return entries;
}

// The kernel with what it promises and shows, as its entries of the record have it.
Json kernel_members(const Json& kernel, const Record& record) {
  Json members = kernel, precisions = Json::array();
  const std::vector<const KernelRecord*> entries = entries_of(record, kernel["id"]);
  for (const KernelRecord* entry : entries) precisions.push_back(name(entry->precision));
  const KernelRecord& entry = *entries.front();
  members["exposes"] = json_of(entry.exposes);
  members["touching"] = name(entry.touching);
  members["may_decline"] = entry.may_decline;
  members["limits"] = has_limits(entry) ? Json(limits_text(entry)) : Json(nullptr);
  members["precisions"] = precisions;
  members["summary"] = entry.summary;
  return members;
}

Json asked_members(const Json& predicate, const Record& record) {
  Evidence all;
  std::uint64_t queries = 0;
  for (const KernelRecord* entry : entries_of(record, predicate["kernel"]["id"])) {
    all.add(evidence_of(*entry));
    for (const auto& [family, result] : entry->families) queries += result.trials;
  }
  return {{"effort", predicate["asked"]["effort"]},
          {"seed", record.plan.seed.value},
          {"stretches", predicate["materials"]["tallies"].size()},
          {"families", json_of(record.plan.families)},
          {"queries", queries},
          {"looked_at", all.decided()},
          {"left_out",
           {{"no_query", queries - all.population},
            {"outside_limits", all.outside},
            {"touching", all.touching},
            {"declined", all.declined()},
            {"invalid", all.invalid},
            {"unanswered", all.unanswered}}}};
}

// Every kernel of the run, on the same queries.
Json comparison_of(const Record& record) {
  Json rows = Json::array();
  for (const KernelRecord& entry : record.kernels) {
    const auto total = all_families(entry);
    if (!total) continue;
    const VerdictTally& verdict = total->verdict;
    const auto ulps = [](const std::optional<double>& error) {
      return error ? Json(amount(*error, 3)) : Json(nullptr);
    };
    rows.push_back({{"kernel", json_of(entry.id)},
                    {"precision", name(entry.precision)},
                    {"looked_at", evidence_of(entry).decided()},
                    {"missed", verdict.false_separation},
                    {"deepest_missed", amount(verdict.deepest_false_separation.best(), 3)},
                    {"phantom", verdict.false_contact},
                    {"deepest_phantom", amount(verdict.deepest_false_contact.best(), 3)},
                    {"undecided", verdict.undecided},
                    {"invalid", verdict.invalid},
                    {"unanswered", verdict.unanswered},
                    {"median_ulps", ulps(entry.critical_radius.median_ulps)},
                    {"largest_ulps", ulps(entry.critical_radius.largest_ulps)}});
  }
  return rows;
}

// Sentences that say what the certificate leaves open.
Json limits_of(const Json& predicate, const Json& kernel) {
  Json limits = Json::array();
  const auto say = [&](std::string sentence) { limits.push_back(std::move(sentence)); };
  say("What is met was observed on queries that these families make, but for what `proved` says there: no number of "
      "queries proves it for others, and the bounds are of rates in these families, not in a game.");
  if (kernel["exposes"].size() == 1)
    say("The kernel shows its verdict alone: why it is wrong was inferred from the input, and not seen.");
  const Json& harness = predicate["harness"];
  for (const auto& [precision, score] : harness["score"].items()) {
    say(
        fmt::format("Of {} faults planted in a right kernel that shows as much, {} were not noticed in {}: a fault as "
                    "small as those may be in this kernel too.",
                    score["mutants"].get<std::uint64_t>(), score["survived"].get<std::uint64_t>(), precision));
  }
  if (!harness["reason"].is_null())
    say(fmt::format("How many faults such a run notices was not asked: {}.", harness["reason"].get<std::string>()));
  if (!predicate["search"]["reason"].is_null())
    say(fmt::format("No search was made: {}.", predicate["search"]["reason"].get<std::string>()));
  else say("A search gives lower bounds of the worst: it says nothing about what it did not find.");
  if (predicate["safe_margin"]["reason"].is_null())
    say("The safe margin mends what was seen here; a contact that nothing here showed may need more.");
  say("The search, the growths of the safe margin and the sizes and shapes that its parts name, the diagnosis, the "
      "planted faults and the witnesses are stated by "
      "whoever made this: no count here shows them. So are the counts of images, the numbers of triangles, the medians "
      "of "
      "critical radii, the findings of loading and what the kernel says of itself, which a recheck asks again. "
      "Everything "
      "else follows from the counts.");
  if (!kernel["limits"].is_null()) {
    say(fmt::format("The kernel promises to be right only there: {}; it was held to nothing else.",
                    kernel["limits"].get<std::string>()));
  }
  if (kernel["may_decline"] == true)
    say("The kernel may decline: what it does not decide has to be asked of another test.");
  const std::string kind = kernel["kind"];
  if (kind == "replies") say("The subject is replies: what gave them, and whether it gives them again, is not known.");
  else if (kind == "built-in") {
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
bool is_same(const Json& x, const Json& y) { return canonical_json(x) == canonical_json(y); }

std::string level_text(const Json& level) {
  return fmt::format("{} in {}", level["level"].get<std::string>(), plain_text(level["precision"]));
}

// "not met: tangent: missed contacts: 3".
std::string state_words(const Json& level) {
  const std::string state = level["state"];
  if (state == "not met" && !level["failures"].empty())
    return fmt::format("{}: {}", state, level["failures"][0].get<std::string>());
  return level["reason"].is_null() ? state : fmt::format("{}: {}", state, level["reason"].get<std::string>());
}

// `has_our_words`: it was made by this axiscert, so that sentences are compared too.
void require_levels(const Json& stated, const Json& derived, bool has_our_words, const std::string& name) {
  if (is_same(stated, derived)) return;
  for (const Json& level : stated) {
    const auto is_it = [&](const Json& other) {
      return other["level"] == level["level"] && other["precision"] == level["precision"];
    };
    if (std::ranges::none_of(derived, is_it))
      throw NotValid(fmt::format("{}: it states {} {}, and its counts say nothing of it", name, level_text(level),
                                 level["state"].get<std::string>()));
  }
  for (const Json& level : derived) {
    const auto is_it = [&](const Json& other) {
      return other["level"] == level["level"] && other["precision"] == level["precision"];
    };
    const auto found = std::ranges::find_if(stated, is_it);
    // Another axiscert may have had no such level; one that is refused is not left out.
    if (found == stated.end() && !has_our_words && level["state"] != "not met") continue;
    if (found == stated.end())
      throw NotValid(
          fmt::format("{}: it leaves out the level {}, which is {}", name, level_text(level), state_words(level)));
    if ((*found)["state"] != level["state"]) {
      throw NotValid(fmt::format("{}: it states {} {}, and its counts say: {}", name, level_text(level),
                                 (*found)["state"].get<std::string>(), state_words(level)));
    }
    if (has_our_words && !is_same(*found, level)) {
      throw NotValid(fmt::format("{}: what it states of {} is not what its counts say: {}", name, level_text(level),
                                 canonical_json(level)));
    }
  }
  if (has_our_words || stated.size() > derived.size())
    throw NotValid(fmt::format("{}: its levels are not in their order, each once", name));
}

void require_comparison(const Json& stated, const Json& derived, const std::string& name) {
  if (is_same(stated, derived)) return;
  for (std::size_t i = 0; i < std::min(stated.size(), derived.size()); ++i) {
    for (const auto& [member, value] : derived[i].items()) {
      if (stated[i][member] == value) continue;
      throw NotValid(fmt::format("{}: its comparison states {} {} of {} in {}, and its counts say {}", name, member,
                                 shown(stated[i][member].dump()), derived[i]["kernel"].get<std::string>(),
                                 derived[i]["precision"].get<std::string>(), value.dump()));
    }
  }
  throw NotValid(
      fmt::format("{}: its comparison has {} rows, and its counts make {}", name, stated.size(), derived.size()));
}

bool is_class(const Json& cause) {
  return std::ranges::find(input_class_names, cause.get_ref<const std::string&>()) != input_class_names.end();
}

std::uint64_t broken_links(const VerdictTally& verdict, const Json& link) {
  for (const Link one : enumerators<Link>) {
    if (link == name(one)) return verdict.links[one];
  }
  return 0;
}

// A link as the cause is known of a witness alone: then it is one of those that the counts have.
bool breaks_by_link(const Json& stated, const Json& derived, const Record& record, const std::string& kernel) {
  if (!derived.is_null() && (derived["cause"] == "finding" || is_class(derived["cause"]))) return false;
  bool is_any_missed = false, is_any_phantom = false, is_there = false;
  const bool is_missed = !stated.is_null() && stated["what"] == "missed contact";
  for (const KernelRecord* entry : entries_of(record, kernel)) {
    const auto total = all_families(*entry);
    if (!total) continue;
    const VerdictTally& verdict = total->verdict;
    is_any_missed = is_any_missed || verdict.false_separation != 0;
    is_any_phantom = is_any_phantom || verdict.false_contact != 0;
    if (stated.is_null() || stated["precision"] != name(entry->precision)) continue;
    const std::uint64_t count = is_missed ? verdict.false_separation : verdict.false_contact;
    is_there = stated["count"] == count && count != 0 && broken_links(verdict, stated["cause"]) != 0;
  }
  if (stated.is_null()) return !is_any_missed && !is_any_phantom && derived.is_null();
  return is_there && is_any_missed == is_missed && (is_missed || stated["what"] == "phantom contact");
}

void require_breaks(const Json& stated, const Json& derived, const Record& record, const std::string& kernel,
                    const std::string& name) {
  if (!stated.is_null() && is_same(stated, derived)) return;
  if (breaks_by_link(stated, derived, record, kernel)) return;
  throw NotValid(fmt::format("{}: what it states to break first is not what its counts say{}", name,
                             derived.is_null() ? "" : ": " + shown(canonical_json(derived))));
}

void require_asked(const Json& stated, const Json& derived, const std::string& name) {
  for (const auto& [member, value] : derived.items()) {
    if (is_same(stated[member], value)) continue;
    throw NotValid(fmt::format("{}: it states `{}` {}, and its plan and counts say {}", name, member,
                               shown(canonical_json(stated[member])), shown(canonical_json(value))));
  }
}

void require_margins(const Json& predicate, const Record& record, const std::string& name) {
  const Json& margins = predicate["safe_margin"];
  if (margins["reason"].is_null() == margins["precisions"].empty())
    throw NotValid(fmt::format("{}: it has no safe margin, and no reason, or both", name));
  if (!margins["reason"].is_null()) {
    const Json& kernel = predicate["kernel"];
    const TestDescription& test = find_test(kernel["test"].get<std::string>());
    const bool is_first_entry = kernel["entry"] == test.entries.front().name;
    const bool could_be_asked = kernel["kind"] != effort_of_replies && is_first_entry && has_sphere_radius(test, 0);
    if (could_be_asked && !margins["reason"].get_ref<const std::string&>().starts_with(margin_answered_otherwise)) {
      throw NotValid(fmt::format("{}: it has no safe margin, which every kernel of {} has, and says why: {}", name,
                                 test.id, shown(margins["reason"].dump())));
    }
    return;
  }
  const std::vector<const KernelRecord*> entries = entries_of(record, predicate["kernel"]["id"]);
  if (margins["precisions"].size() != entries.size())
    throw NotValid(fmt::format("{}: it has safe margins of {} of {} precisions", name, margins["precisions"].size(),
                               entries.size()));
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const Json& margin = margins["precisions"][i];
    std::string fault;
    if (margin["precision"] != axiscert::name(entries[i]->precision)) fault = "its precisions are in another order";
    else fault = margin_fault(margin, *entries[i]);
    if (!fault.empty())
      throw NotValid(fmt::format("{}: its safe margin in {}: {}", name, margin["precision"].get<std::string>(), fault));
  }
}

}  // namespace

bool is_made_by_this(const Json& predicate) {
  return predicate["materials"]["axiscert"]["sources"] == source_digests().sources;
}

Json derived_members(const Json& predicate, const Record& record) {
  const std::string id = predicate["kernel"]["id"];
  Json members = {{"kernel", kernel_members(predicate["kernel"], record)}, {"asked", asked_members(predicate, record)}};
  members["levels"] = levels_json(record, id, predicate["search"]["precisions"]);
  members["comparison"] = comparison_of(record);
  members["situations"] = where_it_is_wrong(record, id);
  members["breaks_first"] = what_breaks_first(record, id);
  members["limits"] = limits_of(predicate, members["kernel"]);
  return members;
}

Record require_derived(const Json& predicate, const std::string& name) {
  Record record = reduced_record(predicate, name);
  require_effort(predicate, name);
  const Json derived = derived_members(predicate, record);
  const bool has_our_words = is_made_by_this(predicate);
  if (const Json& version = predicate["materials"]["axiscert"]["version"];
      has_our_words && version != axiscert_version) {
    throw NotValid(fmt::format("{}: it states version {} of axiscert, and its sources are those of {}", name,
                               shown(version.dump()), axiscert_version));
  }
  require_asked(predicate["kernel"], derived["kernel"], name + ": of its kernel");
  require_asked(predicate["asked"], derived["asked"], name);
  if (has_our_words) require_usual_stretches(predicate, name);
  require_levels(predicate["levels"], derived["levels"], has_our_words, name);
  require_margins(predicate, record, name);
  require_comparison(predicate["comparison"], derived["comparison"], name);
  if (!has_our_words) return record;
  for (const char* member : {"situations", "limits"}) {
    if (!is_same(predicate[member], derived[member])) {
      throw NotValid(fmt::format("{}: its {} are not those that follow from its counts: {}", name, member,
                                 shown(canonical_json(derived[member]))));
    }
  }
  require_breaks(predicate["breaks_first"], derived["breaks_first"], record, predicate["kernel"]["id"], name);
  return record;
}

bool has_answers(const Record& record, const std::string& kernel) {
  return std::ranges::all_of(entries_of(record, kernel),
                             [](const KernelRecord* entry) { return evidence_of(*entry).decided() != 0; });
}

void require_effort(const Json& predicate, const std::string& name) {
  const std::string effort = predicate["asked"]["effort"], kind = predicate["kernel"]["kind"];
  if ((effort == effort_of_replies) != (kind == "replies"))
    throw NotValid(fmt::format("{}: effort {} of a kernel that is {}", name, effort, kind));
  if (kind == "replies") return;
  const Json& plan = predicate["materials"]["plan"]["plan"];
  const TestDescription& test = find_test(plan["test"].get<std::string>());
  for (const auto& [family, by_precision] : plan["trials"].items()) {
    if (family == "corpus" || family.starts_with("queries/")) continue;  // as they are
    const std::uint64_t asks = trials_of(parse_effort(effort), test, family, kind != "built-in");
    for (const auto& [precision, trials] : by_precision.items()) {
      if (trials == asks) continue;
      throw NotValid(fmt::format("{}: effort {} asks {} queries of `{}` in {}, and its plan has {}", name, effort,
                                 thousands(asks), family, precision, thousands(trials.get<std::uint64_t>())));
    }
  }
}

}  // namespace axiscert

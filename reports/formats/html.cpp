// report.html: one file that needs nothing else. The page's own text is under page/; this file fills in the data.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "fuzz/text/json_form.h"
#include "fuzz/text/number_text.h"
#include "kernel/names.h"
#include "reports/formats/format.h"
#include "reports/formats/witness_order.h"
#include "reports/gates/requirement.h"
#include "reports/page/encoding.h"
#include "reports/page/page_template.h"
#include "reports/run_folder/attachments.h"
#include "reports/run_folder/record_checks.h"
#include "reports/run_folder/run_folder.h"
#include "reports/wording/causes.h"
#include "reports/wording/depths.h"
#include "reports/wording/everyday.h"
#include "reports/wording/evidence.h"
#include "reports/wording/reproduce.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

// Limit on the file's size, so that it opens from disk at once and can go by mail. The page stays below it by showing
// fewer witnesses and by linking the images of maps that do not fit.
constexpr std::size_t page_bytes = 2'900'000;
constexpr std::size_t image_bytes = 1'000'000;
constexpr std::size_t page_witnesses = 2000;

// What a struct says of each of its fields.
template <class T>
Json sentences() {
  Json notes = Json::object();
  const Json schema = json_schema_of<T>();
  for (const auto& [member, rule] : schema["properties"].items()) notes[member] = rule.value("description", "");
  return notes;
}

// The page's column notes.
Json notes() {
  return {{"family", sentences<FamilyRecord>()},
          {"truth", sentences<TruthCounts>()},
          {"verdict", sentences<VerdictTally>()},
          {"formula_links", sentences<FormulaLinks>()},
          {"axis", sentences<AxisTally>()},
          {"comparison", sentences<ComparisonTally>()},
          {"critical_radius", sentences<CriticalRadiusRecord>()},
          {"outside_limits", sentences<OutsideTally>()},
          {"finding", sentences<FindingRecord>()},
          {"asymmetry", sentences<AsymmetryRecord>()}};
}

// The shortest decimal text of a number of the precision.
std::string decimal(const std::string& text, Precision precision) {
  return precision == Precision::binary32 ? fmt::format("{}", parse_number<float>(text))
                                          : fmt::format("{}", parse_number<double>(text));
}

Json decimals_of(const GroupNumbers& group, Precision precision) {
  if (group.numbers.size() == 1) return decimal(group.numbers.front(), precision);
  Json all = Json::array();
  for (const std::string& number : group.numbers) all.push_back(decimal(number, precision));
  return all;
}

Json witness_card(const WitnessRecord& witness, const PlanRecord& plan) {
  Json card = json_of(witness);
  Json& decimals = card["decimal"] = Json::object();
  for (const auto& [group, numbers] : witness.numbers) decimals[group] = decimals_of(numbers, witness.precision);
  const Predicate& predicate = predicate_of(plan);
  const PredicateEntry& entry = *entry_of(predicate, witness);
  if (const std::string_view written = written_name(predicate); !written.empty()) card["predicate"] = written;
  if (&entry != &predicate.entries.front()) card["entry"] = entry.name;
  card["command"] = replay_command(witness, plan);
  card["length_text"] = length_words(witness.family, witness.length.value_or(0), plan);
  return card;
}

Json kernel_data(const KernelRecord& kernel, const PlanRecord& plan) {
  Json data = json_of(kernel);
  const auto put_limits = [&](Json& shown, const FamilyRecord& family) {
    const auto limit = [](double per_million) { return per_million < 0 ? Json(nullptr) : Json(per_million); };
    shown["zero_limit_per_million"] = limit(zero_limit_per_million(kernel, family));
    for (const FlipKind kind : {FlipKind::false_separation, FlipKind::false_contact})
      shown["zero_limits"][std::string(name(kind))] = limit(zero_limit_per_million(kernel, family, kind));
  };
  for (const auto& [family, result] : kernel.families) {
    Json& shown = data["families"][family];
    put_limits(shown, result);
    const VerdictTally& verdict = result.verdict;
    shown["lengths"] = {{"false_separation", length_words(family, verdict.farthest_false_separation.best(), plan)},
                        {"false_contact", length_words(family, verdict.farthest_false_contact.best(), plan)}};
  }
  data["sentences"] = first_sentences(kernel, plan);
  data["touching_text"] = touching_text(kernel);
  data["limits_text"] = limits_text(kernel);
  data["classes"] = classes_data(kernel);
  const std::string cause = cause_sentence(kernel);
  data["cause_text"] = cause.empty() ? Json(nullptr) : Json(cause);
  data["cause_witness_text"] = cause_witness_line(kernel, plan);
  data["all"] = nullptr;
  const std::optional<FamilyRecord> total = all_families(kernel);
  if (!total) return data;
  Json& all = data["all"] = json_of(*total);
  all["verdict"].erase("first_by_link");  // places in a family cannot be added up
  put_limits(all, *total);
  const Evidence evidence = evidence_of(kernel);
  data["evidence_text"] = evidence_text(evidence, evidence.decided());
  data["decided"] = evidence.decided();
  data["engine_text"] = engine_text(*total);
  data["bias_text"] = bias_text(kernel, *total);
  if (const std::optional<DepthTally>& depths = total->verdict.depths) {
    data["depths"] = {{"columns", depth_columns()},
                      {"false_separation", depth_counts(depths->false_separation)},
                      {"false_contact", depth_counts(depths->false_contact)}};
  }
  return data;
}

Json findings_data(const Record& record) {
  Json data = Json::array();
  for (const FindingGroup& group : finding_groups(record)) {
    Json& shown = data.emplace_back(json_of(*group.first));
    for (const auto& [columns, numbers] : group.first->numbers) shown.erase(columns);
    shown["others"] = group.others_text();
    shown["command"] = replay_command(*group.first, record.plan);
  }
  return data;
}

Json requirement_data(const Record& record) {
  const Requirements required = requirements_of(record.plan);
  if (required.levels.empty()) return nullptr;
  const std::vector<LevelOutcome> outcomes = outcomes_of(record);
  Json data = {{"levels", Json::array()},
               {"passes", pass(outcomes)},
               {"outcomes", json_of(outcomes)},
               {"failures", Json::array()}};
  for (const AskedLevel& asked : required.levels)
    data["levels"].push_back({{"level", asked.text}, {"sentence", sentence_of(asked)}});
  for (const Failure& f : failures_of(outcomes)) {
    data["failures"].push_back({{"kernel", f.kernel},
                                {"precision", f.precision},
                                {"family", f.family},
                                {"count", f.count},
                                {"what", f.what},
                                {"witness", f.witness}});
  }
  return data;
}

// What the page begins with.
Json first_data(const Record& record) {
  const FirstLevels levels = first_levels(record);
  Json data = {{"lead", levels.lead}, {"levels", Json::array()}, {"worst", nullptr}};
  for (const LevelOutcome& outcome : levels.outcomes) {
    data["levels"].push_back({{"level", outcome.claim()},
                              {"kernel", outcome.kernel},
                              {"precision", outcome.precision},
                              {"state", name(outcome.state)},
                              {"allowed", outcome.is_allowed},
                              {"looked_at", outcome.looked_text()},
                              {"reason", reason_text(outcome)},
                              {"witness", outcome.failures.empty() ? "" : outcome.failures.front().witness}});
  }
  if (const WitnessRecord* worst = worst_scene(record))
    data["worst"] = {{"id", worst->id},
                     {"kernel", worst->kernel},
                     {"precision", name(worst->precision)},
                     {"family", worst->family},
                     {"group", name(family_group(worst->family))},
                     {"words", scene_words(*worst, record.plan)}};
  return data;
}

// The families of the plan by what a wrong answer on them says.
Json groups_data(const PlanRecord& plan) {
  Json data = Json::array();
  for (const FamilyGroup group : enumerators<FamilyGroup>) {
    std::vector<std::string> families;
    for (const std::string& family : plan.families) {
      if (family_group(family) == group) families.push_back(family);
    }
    if (!families.empty()) data.push_back({{"heading", family_group_headings[group]}, {"families", families}});
  }
  return data;
}

Json cards(const Record& record, std::size_t limit, const std::set<std::string>& named) {
  Json data = {{"total", record.witnesses.size()}, {"cards", Json::array()}};
  for (const WitnessRecord* witness : shown_witnesses(record, limit, named))
    data["cards"].push_back(witness_card(*witness, record.plan));
  return data;
}

// The steps that decided the queries, without the member that the page does not show.
Json steps(const RunInfo& info) {
  Json rows = json_of(info.steps);
  for (Json& row : rows) row.erase("signs");
  return rows;
}

Json page_data(const Run& run) {
  const Record& record = run.record;
  Json data = {{"complete", record.complete},
               {"interrupted", record.complete ? "" : interrupted_text(record)},
               {"plan", json_of(record.plan)},
               {"first", first_data(record)},
               {"groups", groups_data(record.plan)},
               {"requirement", requirement_data(record)},
               {"links", Json::object()},
               {"notes", notes()},
               {"kernels", Json::array()}};
  data["plan"].erase("seed");  // 64 bits, while a number in a page holds 53; the facts have it as text
  for (std::size_t i = 0; i < link_count; ++i) data["links"][std::string(link_names[i])] = link_words[i].meaning;
  for (const KernelRecord& kernel : record.kernels) data["kernels"].push_back(kernel_data(kernel, record.plan));
  data["findings"] = findings_data(record);
  data["not_judged"] = not_judged(record);
  data["unjudged"] = unjudged(record);
  data["command"] = run_command(record.plan);
  data["facts"] = plan_facts(run);
  data["throughput"] = run.info ? json_of(run.info->throughput) : Json::array();
  data["not_checked"] = not_checked(record);
  data["steps"] = run.info ? steps(*run.info) : Json::array();
  data["target"] = run.info ? json_of(run.info->target) : Json();
  data["attached"] = attachments(run.folder, image_bytes);
  data["files"] = raw_files(run.folder);
  data["contact_note"] = contact_note(is_of_motions(predicate_of(record.plan)));
  for (const GateLevel* level : gate_levels()) {
    if (level->advice != nullptr) data["advised_level"] = {{"level", level->name()}, {"advice", level->advice}};
  }
  Json& clauses = data["comparisons"] = Json::object();  // the axis, or other clause, of each
  const Predicate& predicate = predicate_of(record.plan);
  for (const PredicateComparison& comparison : predicate.comparisons)
    clauses[std::string(comparison.name)] = predicate.clauses[comparison.clause].name;
  return data;
}

// In an order in which each may use those before it.
std::string scripts() {
  using namespace embedded;
  const std::string scenes = scene_scripts();
  const std::string_view all[] = {chart_min_js, chart_js,     table_js,   first_js,    answer_js,  next_js, classes_js,
                                  heat_js,      bounds_js,    origins_js, maps_js,     margins_js, scenes,  snippets_js,
                                  contacts_js,  witnesses_js, results_js, appendix_js, report_js};
  return fmt::format("{}", fmt::join(all, "\n"));
}

std::string render_html(const Run& run) {
  const auto with = [css = std::string(embedded::report_css), data = packed(page_data(run).dump()),
                     js = scripts()](std::string witnesses) {
    const std::pair<std::string_view, std::string> places[] = {
        {"/*CSS*/", css}, {"/*DATA*/", data}, {"/*WITNESSES*/", std::move(witnesses)}, {"/*JS*/", js}};
    return filled(embedded::report_html, places);
  };
  std::set<std::string> named;  // where a level is not met, and what the page begins with
  for (const Failure& failure : failures_of(first_levels(run.record).outcomes)) named.insert(failure.witness);
  if (const WitnessRecord* worst = worst_scene(run.record)) named.insert(worst->id);
  const std::size_t taken = with("").size(), room = page_bytes - std::min(page_bytes, taken);
  for (std::size_t limit = page_witnesses;;) {
    std::string witnesses = packed(cards(run.record, limit, named).dump());
    if (witnesses.size() <= room || limit == 0) return with(std::move(witnesses));
    // As many as would fit if all had the same size, and at least one fewer.
    limit = std::min(limit - 1, limit * room / witnesses.size());
  }
}

}  // namespace

extern const Format html_format = {"report.html", nullptr, render_html};

}  // namespace axiscert

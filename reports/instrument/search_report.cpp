// `axiscert search`: the worst that a search found in a kernel, next to what is proved.
#include "reports/instrument/search_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "fuzz/search/method.h"
#include "fuzz/search/proved.h"
#include "reports/instrument/figures.h"
#include "reports/instrument/looked_at.h"
#include "kernel/base/version.h"

namespace axiscert {
namespace {

class SearchReport {
 public:
  SearchReport(const SearchPlan& plan, const SearchResult& result)
      : plan_(plan), result_(result), all_(search_looked_at(result)) {}

  InstrumentReport report(const std::string& command) const {
    InstrumentReport report;
    report.name = "search";
    report.title = title();
    report.command = command;
    report.notes = search_method_of(test()).notes();
    if (plan_.first_queries != 0) {
      report.notes.push_back(
          fmt::format("It began from a run of {} queries of each of {} families, and reports nothing less severe than "
                      "that run found.",
                      thousands(plan_.first_queries), plan_.first_sources.size()));
    }
    if (const std::string faults = faults_text(all_, may_decline()); !faults.empty()) {
      report.notes.insert(report.notes.begin(), faults);
    }
    if (InstrumentTable table = comparison_table(); !table.rows.empty()) report.tables.push_back(std::move(table));
    if (InstrumentTable table = verdict_table(); !table.rows.empty()) report.tables.push_back(std::move(table));
    report.tables.push_back(looked_at_table());
    report.data = data();
    return report;
  }

 private:
  const TestDescription& test() const { return *plan_.kernel->test; }
  bool may_decline() const { return plan_.kernel->may_decline; }

  // Its first words say how much was looked at: of nothing, there is no worst.
  std::string title() const {
    const std::string what =
        fmt::format("{}, {} evaluations, seed {}{}", name(plan_.precision), thousands(result_.evaluations), plan_.seed,
                    result_.complete ? "" : ", interrupted");
    if (all_.decided == 0) {
      return fmt::format("Nothing was looked at: {} decided none of {} queries ({}), {}", plan_.kernel->id,
                         thousands(all_.asked()), not_decided_text(all_, may_decline()), what);
    }
    const std::string others = not_decided_text(all_, may_decline());
    if (others.empty()) return fmt::format("The worst of {} found, {}", plan_.kernel->id, what);
    return fmt::format("The worst of {} found among {} of {} queries that it decided ({}), {}", plan_.kernel->id,
                       thousands(all_.decided), thousands(all_.asked()), others, what);
  }

  const LookedAt& looked_at(const Aim& aim) const {
    for (std::size_t i = 0; i < result_.aims.size(); ++i) {
      if (result_.aims[i] == aim) return result_.looked_at[i];
    }
    throw std::logic_error("search: no such aim");
  }
  // The words for an aim without a find.
  std::string nothing_found(const Aim& aim) const {
    const std::uint64_t decided = looked_at(aim).decided;
    return decided == 0 ? "not looked at" : fmt::format("none among {} decided", thousands(decided));
  }

  const Find* find(const Aim& aim) const {
    for (const Find& find : result_.finds) {
      if (find.aim == aim) return &find;
    }
    return nullptr;
  }
  // The comparisons that were searched, in their order.
  std::vector<std::size_t> comparisons_asked() const {
    std::vector<std::size_t> all;
    for (const Aim& aim : result_.aims) {
      if (aim.goal == Goal::error) all.push_back(aim.which);
    }
    return all;
  }
  std::vector<Goal> verdict_goals() const {
    std::vector<Goal> all;
    for (const Aim& aim : result_.aims) {
      if (!is_about_a_comparison(aim.goal)) all.push_back(aim.goal);
    }
    return all;
  }

  std::string error_cell(const Aim& aim) const {
    const Find* found = find(aim);
    return found ? shown(found->value) : nothing_found(aim);
  }
  std::string range_cell(const Aim& aim) const {
    const Find* found = find(aim);
    return found ? fmt::format("{}", found->range_exponent) : nothing_found(aim);
  }

  // The queries that were evaluated, by goal.
  InstrumentTable looked_at_table() const {
    InstrumentTable table{
        "Answers to the queries that were evaluated",
        {"goal", "asked", "decided", "declined", "invalid", "unanswered", "outside limits", "no query"},
        {}};
    const auto add = [&](std::string what, const LookedAt& all) {
      table.rows.push_back({std::move(what), thousands(all.asked()), thousands(all.decided), thousands(all.undecided),
                            thousands(all.invalid), thousands(all.unanswered), thousands(all.outside_limits),
                            thousands(all.no_query)});
    };
    for (const Goal goal : enumerators<Goal>) {
      LookedAt of_goal;
      for (std::size_t i = 0; i < result_.aims.size(); ++i) {
        if (result_.aims[i].goal == goal) of_goal.merge(result_.looked_at[i]);
      }
      if (of_goal.asked() != 0) add(std::string(goal_names[goal]), of_goal);
    }
    if (result_.begun.asked() != 0) add("the run before", result_.begun);
    return table;
  }

  InstrumentTable comparison_table() const {
    InstrumentTable table{"Errors of the computed sides, and the scales at which range fails",
                          {"comparison", "attained, u", "proved, u", "relative, u", "overflow, 2^m", "underflow, 2^m"},
                          {}};
    for (const std::size_t which : comparisons_asked()) {
      const auto proved = proved_error(*plan_.kernel, plan_.precision, which);
      table.rows.push_back({std::string(test().comparisons[which].name), error_cell({Goal::error, which}),
                            proved ? shown(*proved) : "open", error_cell({Goal::relative_error, which}),
                            range_cell({Goal::overflow, which}), range_cell({Goal::underflow, which})});
    }
    return table;
  }

  static const char* unit(Goal goal) { return goal == Goal::critical_radius ? "ulps" : "depth"; }

  InstrumentTable verdict_table() const {
    InstrumentTable table{"Verdicts", {"what", "worst", "unit", "broken links"}, {}};
    for (const Goal goal : verdict_goals()) {
      const Find* found = find({goal});
      table.rows.push_back({name(Aim{goal}, test()), error_cell({goal}), unit(goal),
                            found ? fmt::format("{}", fmt::join(names(found->links), " ")) : ""});
    }
    return table;
  }

  static Json witness_json(const Find& find) { return Json::parse(query_line(find.witness)); }
  static Json error_json(const Find* find) { return find ? number_json(find->value) : Json(nullptr); }
  static Json range_json(const Find* find) {
    if (!find) return nullptr;
    return {{"exponent", find->range_exponent}, {"witness", witness_json(*find)}};
  }

  Json data() const {
    Json comparisons_json = Json::array(), verdict = Json::object(), families = Json::array();
    for (const std::size_t which : comparisons_asked()) {
      const Find *error = find({Goal::error, which}), *relative = find({Goal::relative_error, which});
      const auto proved = proved_error(*plan_.kernel, plan_.precision, which);
      comparisons_json.push_back({{"name", test().comparisons[which].name},
                                  {"attained_u", error_json(error)},
                                  {"proved_u", proved ? number_json(*proved) : Json(nullptr)},
                                  {"witness", error ? witness_json(*error) : Json(nullptr)},
                                  {"relative_u", error_json(relative)},
                                  {"relative_witness", relative ? witness_json(*relative) : Json(nullptr)},
                                  {"overflow", range_json(find({Goal::overflow, which}))},
                                  {"underflow", range_json(find({Goal::underflow, which}))}});
    }
    for (const Goal goal : verdict_goals()) {
      const Find* found = find({goal});
      Json& entry = verdict[name(Aim{goal}, test())] = nullptr;
      if (!found) continue;
      entry = {{unit(goal), number_json(found->value)}};
      if (goal != Goal::critical_radius) entry["links"] = names(found->links);
      entry["witness"] = witness_json(*found);
    }
    for (const SourcePtr& source : plan_.sources) families.push_back(source->name());
    Json first_families = Json::array(), by_goal = Json::object();
    for (std::size_t i = 0; i < result_.aims.size(); ++i) {
      by_goal[name(result_.aims[i], test())] = looked_at_json(result_.looked_at[i]);
    }
    for (const SourcePtr& source : plan_.first_sources) first_families.push_back(source->name());
    return {{"schema", search_schema},
            {"axiscert", axiscert_version},
            {"revision", axiscert_revision},
            {"complete", result_.complete},
            {"kernel", plan_.kernel->id},
            {"precision", name(plan_.precision)},
            {"seed", plan_.seed},
            {"families", families},
            {"evaluations", result_.evaluations},
            {"may_decline", may_decline()},
            {"looked_at", looked_at_json(all_)},
            {"looked_at_by_goal", by_goal},
            {"comparisons", comparisons_json},
            {"verdict", verdict},
            {"begun_from",
             {{"queries", plan_.first_queries},
              {"families", first_families},
              {"looked_at", looked_at_json(result_.begun)}}}};
  }

  const SearchPlan& plan_;
  const SearchResult& result_;
  const LookedAt all_;
};

}  // namespace

LookedAt search_looked_at(const SearchResult& result) {
  LookedAt all = result.evaluated();
  all.merge(result.begun);
  return all;
}

InstrumentReport search_report(const SearchPlan& plan, const SearchResult& result, const std::string& command) {
  return SearchReport(plan, result).report(command);
}

std::string search_witnesses(const SearchResult& result) {
  std::string text;
  for (const Find& find : result.finds) text += query_line(find.witness) + "\n";
  return text;
}

}  // namespace axiscert

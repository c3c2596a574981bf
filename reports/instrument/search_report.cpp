// `axiscert search`: the worst that a search found in a kernel, next to what is proved.
#include "reports/instrument/search_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "fuzz/search/proved.h"
#include "reports/instrument/figures.h"
#include "kernel/base/version.h"

namespace axiscert {
namespace {

class SearchReport {
 public:
  SearchReport(const SearchPlan& plan, const SearchResult& result) : plan_(plan), result_(result) {}

  InstrumentReport report(const std::string& command) const {
    InstrumentReport report;
    report.name = "search";
    report.title =
        fmt::format("The worst of {} found, {}, {} evaluations, seed {}{}", plan_.kernel->id, name(plan_.precision),
                    thousands(result_.evaluations), plan_.seed, result_.complete ? "" : ", interrupted");
    report.command = command;
    if (plan_.kernel->test == &first_test()) report.notes = notes_of_first_test();
    else report.notes = notes_by_oracles();
    if (plan_.first_queries != 0) {
      report.notes.push_back(
          fmt::format("It began from a run of {} queries of each of {} families, and reports nothing less severe than "
                      "that run found.",
                      thousands(plan_.first_queries), plan_.first_sources.size()));
    }
    if (InstrumentTable table = comparison_table(); !table.rows.empty()) report.tables.push_back(std::move(table));
    if (InstrumentTable table = verdict_table(); !table.rows.empty()) report.tables.push_back(std::move(table));
    report.data = data();
    return report;
  }

 private:
  static std::vector<std::string> notes_by_oracles() {
    return {
        "A depth is in units of the scene. Queries are of numbers up to 2^8; a length is set to where the kernel's own "
        "verdict changes. Every witness was confirmed by all oracles of the test. These are lower bounds of the worst: "
        "a search proves nothing about what it does not find."};
  }
  static std::vector<std::string> notes_of_first_test() {
    return {
        "Attained: |(l^ - r^) - (l - r)| in u, the greatest found where every coordinate of A - P, B - P, C - P is in "
        "[-1, 1] and r in [0, 1], the rounding of the translation included. Proved: a bound that a checker accepted; "
        "open "
        "where there is none. Relative: the same over |l| + |r|, of any query; looked for up to 2^40 u, and without a "
        "bound "
        "where both sides vanish.",
        "Overflow and underflow: the exponent m of the first 2^m at which a comparison leaves the range, of queries of "
        "size 1/2 to 1 that are far from every change of sign and whose radius, edges and distances to the vertices "
        "are "
        "at least 1/8 of the greatest.",
        "A depth is in units of the scene, the error of the critical radius in ulps of the exact distance. Every "
        "witness was "
        "confirmed by exact arithmetic. All of these are lower bounds of the worst: a search proves nothing about what "
        "it "
        "does not find."};
  }

  const Find* find(const Aim& aim) const {
    for (const Find& find : result_.finds) {
      if (find.aim == aim) return &find;
    }
    return nullptr;
  }
  // The comparisons that were searched, in their order.
  std::vector<Comparison> comparisons_asked() const {
    std::vector<Comparison> all;
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

  std::string error_cell(const Find* find) const { return find ? shown(find->value) : "none"; }
  std::string range_cell(const Find* find) const { return find ? fmt::format("{}", find->range_exponent) : "none"; }

  InstrumentTable comparison_table() const {
    InstrumentTable table{"Errors of the computed sides, and the scales at which range fails",
                          {"comparison", "attained, u", "proved, u", "relative, u", "overflow, 2^m", "underflow, 2^m"},
                          {}};
    for (const Comparison which : comparisons_asked()) {
      const auto proved = proved_error(*plan_.kernel, plan_.precision, which);
      table.rows.push_back({std::string(info(which).name), error_cell(find({Goal::error, which})),
                            proved ? shown(*proved) : "open", error_cell(find({Goal::relative_error, which})),
                            range_cell(find({Goal::overflow, which})), range_cell(find({Goal::underflow, which}))});
    }
    return table;
  }

  static const char* unit(Goal goal) { return goal == Goal::critical_radius ? "ulps" : "depth"; }

  InstrumentTable verdict_table() const {
    InstrumentTable table{"Verdicts", {"what", "worst", "unit", "broken links"}, {}};
    for (const Goal goal : verdict_goals()) {
      const Find* found = find({goal});
      table.rows.push_back({name(Aim{goal}), error_cell(found), unit(goal),
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
    for (const Comparison which : comparisons_asked()) {
      const Find *error = find({Goal::error, which}), *relative = find({Goal::relative_error, which});
      const auto proved = proved_error(*plan_.kernel, plan_.precision, which);
      comparisons_json.push_back({{"name", info(which).name},
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
      Json& entry = verdict[name(Aim{goal})] = nullptr;
      if (!found) continue;
      entry = {{unit(goal), number_json(found->value)}};
      if (goal != Goal::critical_radius) entry["links"] = names(found->links);
      entry["witness"] = witness_json(*found);
    }
    for (const SourcePtr& source : plan_.sources) families.push_back(source->name());
    Json first_families = Json::array();
    for (const SourcePtr& source : plan_.first_sources) first_families.push_back(source->name());
    return {{"schema", search_schema},
            {"axiscert", axiscert_version},
            {"complete", result_.complete},
            {"kernel", plan_.kernel->id},
            {"precision", name(plan_.precision)},
            {"seed", plan_.seed},
            {"families", families},
            {"evaluations", result_.evaluations},
            {"comparisons", comparisons_json},
            {"verdict", verdict},
            {"begun_from", {{"queries", plan_.first_queries}, {"families", first_families}}}};
  }

  const SearchPlan& plan_;
  const SearchResult& result_;
};

}  // namespace

InstrumentReport search_report(const SearchPlan& plan, const SearchResult& result, const std::string& command) {
  return SearchReport(plan, result).report(command);
}

std::string search_witnesses(const SearchResult& result) {
  std::string text;
  for (const Find& find : result.finds) text += query_line(find.witness) + "\n";
  return text;
}

}  // namespace axiscert

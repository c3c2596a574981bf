// `axiscert search`: the worst that a search found in a kernel, next to what is proved.
#include "reports/instrument/search_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

#include "fuzz/text/json_form.h"
#include "fuzz/search/method.h"
#include "fuzz/search/confirm.h"
#include "reports/instrument/figures.h"

namespace axiscert {
namespace {

LookedAt search_looked_at(const SearchResult& result) {
  LookedAt all = result.evaluated();
  merge_fields(all, result.begun);
  return all;
}

// Whether all that was looked for is beside the verdict, and no answer had it.
bool met_no_part(const SearchResult& result) {
  return std::ranges::all_of(result.aims, [](const Aim& aim) { return is_about_a_part(aim.goal); }) &&
         std::ranges::all_of(result.judged, [](std::uint64_t judged) { return judged == 0; });
}

class SearchReport {
 public:
  SearchReport(const SearchPlan& plan, const SearchResult& result)
      : plan_(plan), result_(result), all_(search_looked_at(result)) {}

  InstrumentReport report(const std::string& command) const {
    InstrumentReport report;
    report.name = "search";
    report.title = title();
    report.command = command;
    report.notes = search_method_of(predicate()).notes();
    if (plan_.first_queries != 0) {
      report.notes.push_back(
          fmt::format("It began from a run of {} queries of each of {} families, and reports nothing less severe than "
                      "that run found.",
                      thousands(plan_.first_queries), plan_.first_sources.size()));
    }
    if (const std::string faults = faults_text(all_, may_decline()); !faults.empty()) {
      report.notes.insert(report.notes.begin(), faults);
    }
    report.add(comparison_table());
    report.add(verdict_table());
    report.add(number_table());
    report.tables.push_back(looked_at_table());
    report.data = data();
    return report;
  }

 private:
  const Predicate& predicate() const { return *plan_.kernel->predicate; }
  bool may_decline() const { return plan_.kernel->may_decline; }

  // Its first words say how much was looked at: of nothing, there is no worst.
  std::string title() const {
    const std::string what =
        fmt::format("{}, {} evaluations, seed {}{}", name(plan_.precision), thousands(result_.evaluations), plan_.seed,
                    result_.complete ? "" : ", interrupted");
    if (saw_nothing(result_)) {
      const std::string why =
          all_.decided == 0
              ? fmt::format("decided none of {} queries ({})", thousands(all_.asked()),
                            not_decided_text(all_, may_decline()))
              : fmt::format("gives none of what was searched beside any of {} answers", thousands(all_.decided));
      return fmt::format("Nothing was looked at: {} {}, {}", plan_.kernel->id, why, what);
    }
    const std::string others = not_decided_text(all_, may_decline());
    if (others.empty()) return fmt::format("The worst of {} found, {}", plan_.kernel->id, what);
    return fmt::format("The worst of {} found among {} of {} queries that it decided ({}), {}", plan_.kernel->id,
                       thousands(all_.decided), thousands(all_.asked()), others, what);
  }

  std::size_t index_of(const Aim& aim) const {
    const auto found = std::ranges::find(result_.aims, aim);
    if (found == result_.aims.end()) throw std::logic_error("search: no such aim");
    return static_cast<std::size_t>(found - result_.aims.begin());
  }
  // The words for an aim without a find.
  std::string nothing_found(const Aim& aim) const {
    const std::uint64_t seen = result_.seen(index_of(aim));
    if (seen == 0) return "not looked at";
    return fmt::format("none among {} {}", thousands(seen), is_about_a_part(aim.goal) ? "judged" : "decided");
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
      if (is_about_a_verdict(aim.goal)) all.push_back(aim.goal);
    }
    return all;
  }
  std::vector<Aim> numbers_asked() const {
    std::vector<Aim> all;
    std::ranges::copy_if(result_.aims, std::back_inserter(all),
                         [](const Aim& aim) { return aim.goal == Goal::number; });
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
        if (result_.aims[i].goal == goal) merge_fields(of_goal, result_.looked_at[i]);
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
      table.rows.push_back({std::string(predicate().comparisons[which].name), error_cell({Goal::error, which}),
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
      table.rows.push_back({name(Aim{goal}, predicate()), error_cell({goal}), unit(goal),
                            found ? fmt::format("{}", fmt::join(names(found->links), " ")) : ""});
    }
    return table;
  }

  InstrumentTable number_table() const {
    InstrumentTable table{"Numbers beside the verdict", {"what", "judged", "worst", "unit"}, {}};
    for (const Aim& aim : numbers_asked()) {
      table.rows.push_back({std::string(word(fault_of(aim))), thousands(result_.judged[index_of(aim)]), error_cell(aim),
                            find(aim) ? std::string(unit_of(fault_of(aim))) : ""});
    }
    return table;
  }

  template <class Of, class Made>
  static auto made_of(const Of* find, Made made) -> std::optional<decltype(made(*find))> {
    return find ? std::optional(made(*find)) : std::nullopt;
  }
  static QueryLine witness_of(const Find& find) { return query_line(find.witness); }
  static Decimal6 value_of(const Find& find) { return find.value; }
  static RangeFindData range_of(const Find& find) { return {find.range_exponent, witness_of(find)}; }
  static WrongVerdictFindData wrong_verdict_of(const Find& find) {
    WrongVerdictFindData wrong{find.value, {}, witness_of(find)};
    for (const Link link : find.links) wrong.links.push_back(link);
    return wrong;
  }
  static RadiusFindData radius_of(const Find& find) { return {find.value, witness_of(find)}; }

  ComparisonFindData comparison_data(std::size_t which) const {
    const Find *error = find({Goal::error, which}), *relative = find({Goal::relative_error, which});
    return {std::string(predicate().comparisons[which].name),
            made_of(error, value_of),
            proved_error(*plan_.kernel, plan_.precision, which),
            made_of(error, witness_of),
            made_of(relative, value_of),
            made_of(relative, witness_of),
            made_of(find({Goal::overflow, which}), range_of),
            made_of(find({Goal::underflow, which}), range_of)};
  }

  VerdictFindsData verdict_data() const {
    VerdictFindsData finds;
    for (const Goal goal : verdict_goals()) {
      const Find* found = find({goal});
      if (goal == Goal::missed_contact) finds.missed_contact.emplace(made_of(found, wrong_verdict_of));
      if (goal == Goal::phantom_contact) finds.phantom_contact.emplace(made_of(found, wrong_verdict_of));
      if (goal == Goal::critical_radius) finds.critical_radius.emplace(made_of(found, radius_of));
    }
    return finds;
  }

  static std::vector<Name> names_of(const std::vector<SourcePtr>& sources) {
    std::vector<Name> all;
    for (const SourcePtr& source : sources) all.push_back(source->name());
    return all;
  }

  Json data() const {
    SearchData data;
    data.complete = result_.complete;
    data.kernel = plan_.kernel->id;
    data.precision = plan_.precision;
    data.seed = {plan_.seed};
    data.families = names_of(plan_.sources);
    data.evaluations = result_.evaluations;
    data.may_decline = may_decline();
    data.looked_at = all_;
    for (std::size_t i = 0; i < result_.aims.size(); ++i)
      data.looked_at_by_goal.put(name(result_.aims[i], predicate())) = result_.looked_at[i];
    for (const std::size_t which : comparisons_asked()) data.comparisons.push_back(comparison_data(which));
    data.verdict = verdict_data();
    for (const Aim& aim : numbers_asked())
      data.numbers.push_back({word(fault_of(aim)), result_.judged[index_of(aim)], made_of(find(aim), value_of),
                              made_of(find(aim), witness_of)});
    data.begun_from = {plan_.first_queries, names_of(plan_.first_sources), result_.begun};
    return json_of(data);
  }

  const SearchPlan& plan_;
  const SearchResult& result_;
  const LookedAt all_;
};

}  // namespace

bool saw_nothing(const SearchResult& result) {
  return result.finds.empty() && (search_looked_at(result).decided == 0 || met_no_part(result));
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

// `axiscert predicates`: the predicates, the numbers that each takes and the answers that it gives.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/commands.h"
#include "fuzz/queries/family.h"
#include "kernel/kernel.h"
#include "kernel/predicate.h"
#include "reports/instrument/lists.h"

namespace axiscert {
namespace {

std::vector<Name> kernels_of(const Predicate& predicate) {
  std::vector<Name> ids;
  for (const Kernel& kernel : kernels()) {
    if (kernel.predicate == &predicate) ids.push_back(kernel.id);
  }
  return ids;
}

std::vector<Name> family_names(const Predicate& predicate) {
  std::vector<Name> names;
  for (const Family* family : families_of(predicate)) names.emplace_back(family->name);
  return names;
}

// The columns group by group: "ax ay az (coordinate)".
std::vector<std::string> group_texts(const PredicateEntry& entry) {
  std::vector<std::string> texts;
  for (const ColumnGroup& group : groups_of(entry)) {
    std::vector<std::string_view> names;
    for (std::size_t k = 0; k < group.size; ++k) names.push_back(entry.columns[group.first + k].name);
    texts.push_back(fmt::format("{} ({})", fmt::join(names, " "), name(entry.columns[group.first].role)));
  }
  return texts;
}

std::vector<std::string_view> comparisons_of(const Predicate& predicate, const PredicateClause& clause) {
  std::vector<std::string_view> names;
  for (std::size_t i = 0; i < predicate.comparisons.size(); ++i) {
    if (has_bit(clause.comparisons, i)) names.push_back(predicate.comparisons[i].name);
  }
  return names;
}

void print_predicate(const Predicate& predicate) {
  fmt::print("{}: {}; {}\n", predicate.id, predicate.asks, predicate.rule.text);
  for (const PredicateEntry& entry : predicate.entries) {
    fmt::print("  entry {}: {} columns: {}; {}\n", entry.name, entry.columns.size(),
               fmt::join(group_texts(entry), ", "), entry.validity);
  }
  fmt::print("  {} comparisons in {} clauses, each of which holds where all of its comparisons do:\n",
             predicate.comparisons.size(), predicate.clauses.size());
  for (const PredicateClause& clause : predicate.clauses) {
    fmt::print("    {}: {}\n", clause.name, fmt::join(comparisons_of(predicate, clause), " "));
  }
  if (predicate.measures.empty()) fmt::print("  measures: none\n");
  for (const PredicateMeasure& measure : predicate.measures) {
    fmt::print("  measure {}: {}; {}\n", measure.name, measure.unit, measure.error);
  }
  fmt::print("  touching: {}\n", predicate.touching);
  for (const WrongAnswer& wrong : predicate.wrong_answers) {
    fmt::print("  {}: {} said, {} right\n", wrong.name, name(wrong.said), name(wrong.right));
  }
  fmt::print("  {} kernels, {} families\n", kernels_of(predicate).size(), families_of(predicate).size());
}

ListedEntry listed_entry(const PredicateEntry& entry) {
  ListedEntry listed{entry.name, entry.validity, {}};
  for (const PredicateColumn& column : entry.columns)
    listed.columns.push_back({column.name, column.role, std::string(column.group)});
  return listed;
}

ListedPredicate listed_predicate(const Predicate& predicate) {
  ListedPredicate listed{.id = predicate.id,
                         .asks = predicate.asks,
                         .rule = predicate.rule.text,
                         .touching = predicate.touching,
                         .entries = {},
                         .comparisons = {},
                         .clauses = {},
                         .measures = {},
                         .kernels = kernels_of(predicate),
                         .families = family_names(predicate),
                         .wrong_answers = {}};
  for (const PredicateEntry& entry : predicate.entries) listed.entries.push_back(listed_entry(entry));
  for (const PredicateComparison& comparison : predicate.comparisons)
    listed.comparisons.push_back({comparison.name, predicate.clauses[comparison.clause].name});
  for (const PredicateClause& clause : predicate.clauses) {
    const auto comparisons = comparisons_of(predicate, clause);
    listed.clauses.push_back({clause.name, {comparisons.begin(), comparisons.end()}});
  }
  for (const PredicateMeasure& measure : predicate.measures)
    listed.measures.push_back({measure.name, measure.unit, measure.error});
  for (const WrongAnswer& wrong : predicate.wrong_answers)
    listed.wrong_answers.push_back({wrong.name, wrong.said, wrong.right});
  return listed;
}

int list_predicates(const std::string& format) {
  if (format == "text") {
    for (const Predicate* predicate : predicates()) print_predicate(*predicate);
    return exit_done;
  }
  PredicatesData data;
  for (const Predicate* predicate : predicates()) data.predicates.push_back(listed_predicate(*predicate));
  fmt::print("{}", data_text(json_of(data), format));
  return exit_done;
}

}  // namespace

void add_predicates(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand("predicates", "List the predicates: columns, comparisons, clauses, measures");
  auto format = std::make_shared<std::string>("text");
  add_format(*command, *format, data_formats);
  command->callback([&action, format] { action = [format] { return list_predicates(*format); }; });
}

}  // namespace axiscert

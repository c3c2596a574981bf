// `axiscert tests`: the tests, the numbers that each takes and the answers that it gives.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/commands.h"
#include "fuzz/queries/family.h"
#include "kernel/kernel.h"
#include "kernel/test.h"
#include "reports/instrument/lists.h"

namespace axiscert {
namespace {

std::vector<Name> kernels_of(const TestDescription& test) {
  std::vector<Name> ids;
  for (const Kernel& kernel : kernels()) {
    if (kernel.test == &test) ids.push_back(kernel.id);
  }
  return ids;
}

std::vector<Name> family_names(const TestDescription& test) {
  std::vector<Name> names;
  for (const Family* family : families_of(test)) names.emplace_back(family->name);
  return names;
}

// The columns group by group: "ax ay az (coordinate)".
std::vector<std::string> group_texts(const TestEntry& entry) {
  std::vector<std::string> texts;
  for (const ColumnGroup& group : groups_of(entry)) {
    std::vector<std::string_view> names;
    for (std::size_t k = 0; k < group.size; ++k) names.push_back(entry.columns[group.first + k].name);
    texts.push_back(fmt::format("{} ({})", fmt::join(names, " "), name(entry.columns[group.first].role)));
  }
  return texts;
}

std::vector<std::string_view> comparisons_of(const TestDescription& test, const TestClause& clause) {
  std::vector<std::string_view> names;
  for (std::size_t i = 0; i < test.comparisons.size(); ++i) {
    if (has_bit(clause.comparisons, i)) names.push_back(test.comparisons[i].name);
  }
  return names;
}

void print_test(const TestDescription& test) {
  fmt::print("{}: {}; {}\n", test.id, test.asks, test.rule.text);
  for (const TestEntry& entry : test.entries) {
    fmt::print("  entry {}: {} columns: {}; {}\n", entry.name, entry.columns.size(),
               fmt::join(group_texts(entry), ", "), entry.validity);
  }
  fmt::print("  {} comparisons in {} clauses, each of which holds where all of its comparisons do:\n",
             test.comparisons.size(), test.clauses.size());
  for (const TestClause& clause : test.clauses) {
    fmt::print("    {}: {}\n", clause.name, fmt::join(comparisons_of(test, clause), " "));
  }
  if (test.measures.empty()) fmt::print("  measures: none\n");
  for (const TestMeasure& measure : test.measures) {
    fmt::print("  measure {}: {}; {}\n", measure.name, measure.unit, measure.error);
  }
  fmt::print("  touching: {}\n", test.touching);
  for (const WrongAnswer& wrong : test.wrong_answers) {
    fmt::print("  {}: {} said, {} right\n", wrong.name, name(wrong.said), name(wrong.right));
  }
  fmt::print("  {} kernels, {} families\n", kernels_of(test).size(), families_of(test).size());
}

ListedEntry listed_entry(const TestEntry& entry) {
  ListedEntry listed{entry.name, entry.validity, {}};
  for (const TestColumn& column : entry.columns)
    listed.columns.push_back({column.name, column.role, std::string(column.group)});
  return listed;
}

ListedTest listed_test(const TestDescription& test) {
  ListedTest listed{.id = test.id,
                    .asks = test.asks,
                    .rule = test.rule.text,
                    .touching = test.touching,
                    .entries = {},
                    .comparisons = {},
                    .clauses = {},
                    .measures = {},
                    .kernels = kernels_of(test),
                    .families = family_names(test),
                    .wrong_answers = {}};
  for (const TestEntry& entry : test.entries) listed.entries.push_back(listed_entry(entry));
  for (const TestComparison& comparison : test.comparisons)
    listed.comparisons.push_back({comparison.name, test.clauses[comparison.clause].name});
  for (const TestClause& clause : test.clauses) {
    const auto comparisons = comparisons_of(test, clause);
    listed.clauses.push_back({clause.name, {comparisons.begin(), comparisons.end()}});
  }
  for (const TestMeasure& measure : test.measures)
    listed.measures.push_back({measure.name, measure.unit, measure.error});
  for (const WrongAnswer& wrong : test.wrong_answers)
    listed.wrong_answers.push_back({wrong.name, wrong.said, wrong.right});
  return listed;
}

int list_tests(const std::string& format) {
  if (format == "text") {
    for (const TestDescription* test : tests()) print_test(*test);
    return exit_done;
  }
  TestsData data;
  for (const TestDescription* test : tests()) data.tests.push_back(listed_test(*test));
  fmt::print("{}", data_text(json_of(data), format));
  return exit_done;
}

}  // namespace

void add_tests(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand("tests", "List the tests: columns, comparisons, clauses, measures");
  auto format = std::make_shared<std::string>("text");
  add_format(*command, *format, data_formats);
  command->callback([&action, format] { action = [format] { return list_tests(*format); }; });
}

}  // namespace axiscert

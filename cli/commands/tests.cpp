// `axiscert tests`: the tests, the numbers that each takes and the answers that it gives.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/commands.h"
#include "fuzz/text/json.h"
#include "fuzz/queries/family.h"
#include "kernel/kernel.h"
#include "kernel/test.h"
#include "reports/instrument/data.h"

namespace axiscert {
namespace {

std::vector<std::string_view> kernels_of(const TestDescription& test) {
  std::vector<std::string_view> ids;
  for (const Kernel& kernel : kernels()) {
    if (kernel.test == &test) ids.push_back(kernel.id);
  }
  return ids;
}

std::vector<std::string_view> family_names(const TestDescription& test) {
  std::vector<std::string_view> names;
  for (const Family* family : families_of(test)) names.push_back(family->name);
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

Json entry_json(const TestEntry& entry) {
  Json columns = Json::array();
  for (const TestColumn& column : entry.columns) {
    columns.push_back({{"name", column.name}, {"role", name(column.role)}, {"group", column.group}});
  }
  return {{"name", entry.name}, {"validity", entry.validity}, {"columns", columns}};
}

Json test_json(const TestDescription& test) {
  Json entries = Json::array(), comparisons = Json::array(), clauses = Json::array(), measures = Json::array(),
       wrong_answers = Json::array();
  for (const TestEntry& entry : test.entries) entries.push_back(entry_json(entry));
  for (const TestComparison& comparison : test.comparisons) {
    comparisons.push_back({{"name", comparison.name}, {"clause", test.clauses[comparison.clause].name}});
  }
  for (const TestClause& clause : test.clauses) {
    clauses.push_back({{"name", clause.name}, {"comparisons", comparisons_of(test, clause)}});
  }
  for (const TestMeasure& measure : test.measures) {
    measures.push_back({{"name", measure.name}, {"unit", measure.unit}, {"error", measure.error}});
  }
  for (const WrongAnswer& wrong : test.wrong_answers) {
    wrong_answers.push_back({{"name", wrong.name}, {"said", name(wrong.said)}, {"right", name(wrong.right)}});
  }
  return {{"id", test.id},
          {"asks", test.asks},
          {"rule", test.rule.text},
          {"touching", test.touching},
          {"entries", entries},
          {"comparisons", comparisons},
          {"clauses", clauses},
          {"measures", measures},
          {"kernels", kernels_of(test)},
          {"families", family_names(test)},
          {"wrong_answers", wrong_answers}};
}

int list_tests(const std::string& format) {
  if (format == "text") {
    for (const TestDescription* test : tests()) print_test(*test);
    return exit_done;
  }
  Json all = Json::array();
  for (const TestDescription* test : tests()) all.push_back(test_json(*test));
  fmt::print("{}", data_text(headed("axiscert-tests/1", {{"tests", all}}), format));
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

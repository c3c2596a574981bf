#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/options/test_options.h"
#include "fuzz/queries/family.h"
#include "reports/instrument/lists.h"

namespace axiscert {
namespace {

int print_families(const std::string& format, const TestDescription& test) {
  FamiliesData data;
  for (const Family* family : families_of(test)) {
    if (format == "text") {
      fmt::print("{:<12} {}{}{}\n", family->name, family->purpose,
                 family->exact_arithmetic ? " [exact_arithmetic]" : "",
                 family->cost > 1 ? fmt::format(" [cost {}]", family->cost) : "");
    }
    data.families.push_back({family->name, family->test().id, std::string(family->purpose),
                             static_cast<std::uint64_t>(family->version), family->exact_arithmetic,
                             static_cast<std::uint64_t>(family->cost)});
  }
  if (format != "text") fmt::print("{}", data_text(json_of(data), format));
  return exit_done;
}

}  // namespace

void add_families(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand("families", "List the families of queries and the purpose of each");
  auto format = std::make_shared<std::string>("text");
  add_format(*command, *format, data_formats);
  auto test = std::make_shared<std::string>();
  add_test_option(*command, *test, fmt::format("test whose families are listed (default: {})", default_test().id));
  command->callback(
      [&action, format, test] { action = [format, test] { return print_families(*format, test_given(*test)); }; });
}

}  // namespace axiscert

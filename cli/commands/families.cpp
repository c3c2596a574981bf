#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/options/test_options.h"
#include "fuzz/queries/family.h"
#include "fuzz/confirm/record.h"
#include "reports/instrument/data.h"

namespace axiscert {
namespace {

int list_families(const std::string& format, const TestDescription& test) {
  Json all = Json::array();
  for (const Family* family : families_of(test)) {
    if (format == "text") {
      fmt::print("{:<12} {}{}{}\n", family->name, family->purpose,
                 family->exact_arithmetic ? " [exact_arithmetic]" : "",
                 family->cost > 1 ? fmt::format(" [cost {}]", family->cost) : "");
    }
    all.push_back({{"name", family->name},
                   {"test", family->test().id},
                   {"purpose", family->purpose},
                   {"version", family->version},
                   {"exact_arithmetic", family->exact_arithmetic},
                   {"cost", family->cost}});
  }
  if (format != "text") fmt::print("{}", data_text(headed("axiscert-families/1", {{"families", all}}), format));
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
      [&action, format, test] { action = [format, test] { return list_families(*format, test_given(*test)); }; });
}

}  // namespace axiscert

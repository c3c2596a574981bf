#include <fmt/format.h>

#include "cli/commands.h"
#include "fuzz/queries/family.h"
#include "fuzz/confirm/record.h"

namespace axiscert {
namespace {

int list_families(const std::string& format) {
  Json all = Json::array();
  for (const Family* family : families()) {
    if (format == "text") {
      fmt::print("{:<12} {}{}\n", family->name, family->purpose, family->exact_arithmetic ? " [exact_arithmetic]" : "");
    }
    all.push_back({{"name", family->name},
                   {"purpose", family->purpose},
                   {"version", family->version},
                   {"exact_arithmetic", family->exact_arithmetic}});
  }
  if (format == "json") fmt::print("{}\n", all.dump(2));
  return exit_done;
}

}  // namespace

void add_families(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand("families", "List the families of queries and the purpose of each");
  auto format = std::make_shared<std::string>("text");
  add_format(*command, *format, "json");
  command->callback([&action, format] { action = [format] { return list_families(*format); }; });
}

}  // namespace axiscert

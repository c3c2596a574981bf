#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/commands.h"
#include "kernel/kernel.h"
#include "reports/record.h"

namespace axiscert {
namespace {

int list_kernels(const std::string& format) {
  const auto targets = available_targets();
  Json all = Json::array();
  for (const Kernel& kernel : kernels()) {
    if (format == "text") {
      fmt::print("{:<12} {}; {}; {}; exposes verdict, comparisons, sides\n", kernel.id, kernel.summary,
                 fmt::join(precision_names, " "), fmt::join(targets, " "));
    }
    all.push_back({{"id", kernel.id},
                   {"summary", kernel.summary},
                   {"precisions", precision_names},
                   {"targets", targets},
                   {"exposes", {"verdict", "comparisons", "sides"}}});
  }
  if (format == "json") fmt::print("{}\n", all.dump(2));
  return exit_done;
}

}  // namespace

void add_kernels(CLI::App& app, Action& action) {
  auto* command =
      app.add_subcommand("kernels", "List the kernels, their precisions, instruction sets and what they expose");
  auto format = std::make_shared<std::string>("text");
  add_format(*command, *format, "json");
  command->callback([&action, format] { action = [format] { return list_kernels(*format); }; });
}

}  // namespace axiscert

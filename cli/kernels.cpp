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
      fmt::print("{:<20} {}; {}; {}; exposes {}\n", kernel.id, kernel.summary, fmt::join(precision_names, " "),
                 kernel.has_simd ? fmt::format("{}", fmt::join(targets, " ")) : scalar_target,
                 fmt::join(exposures_json(kernel).get<std::vector<std::string>>(), ", "));
    }
    all.push_back({{"id", kernel.id},
                   {"summary", kernel.summary},
                   {"formulae", name(kernel.formulae)},
                   {"precisions", precision_names},
                   {"targets", kernel.has_simd ? Json(targets) : Json{scalar_target}},
                   {"exposes", exposures_json(kernel)},
                   {"takes_arithmetic", kernel.takes_arithmetic}});
  }
  if (format == "text") {
    fmt::print(
        "\nKERNEL+ARITHMETIC, for each kernel from published to ladder-9, is its scalar form in another arithmetic:\n");
  }
  Json others = Json::array();
  for (const ArithmeticInfo& arithmetic : arithmetics()) {
    Json precisions = Json::array();
    if (arithmetic.in_binary32) precisions.push_back(name(Precision::binary32));
    if (arithmetic.in_binary64) precisions.push_back(name(Precision::binary64));
    if (format == "text") {
      fmt::print("{:<20} {}; {}\n", "+" + arithmetic.name, arithmetic.summary,
                 fmt::join(precisions.get<std::vector<std::string>>(), " "));
    }
    others.push_back({{"id", arithmetic.name}, {"summary", arithmetic.summary}, {"precisions", precisions}});
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

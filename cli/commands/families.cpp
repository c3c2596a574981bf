#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/options/predicate_options.h"
#include "fuzz/queries/family.h"
#include "reports/instrument/lists.h"

namespace axiscert {
namespace {

int print_families(const std::string& format, const Predicate& predicate) {
  FamiliesData data;
  for (const Family* family : families_of(predicate)) {
    if (format == "text") {
      fmt::print("{:<12} {}{}{}\n", family->name, family->purpose,
                 family->exact_arithmetic ? " [exact_arithmetic]" : "",
                 family->cost > 1 ? fmt::format(" [cost {}]", family->cost) : "");
    }
    data.families.push_back({family->name, family->predicate().id, std::string(family->purpose),
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
  auto predicate = std::make_shared<std::string>();
  add_predicate_option(*command, *predicate,
                       fmt::format("predicate whose families are listed (default: {})", default_predicate().id));
  command->callback([&action, format, predicate] {
    action = [format, predicate] { return print_families(*format, predicate_given(*predicate)); };
  });
}

}  // namespace axiscert

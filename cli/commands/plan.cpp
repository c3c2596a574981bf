#include <fmt/format.h>

#include <filesystem>

#include "cli/commands.h"
#include "cli/options/plan_file.h"
#include "cli/options/require_options.h"
#include "cli/values.h"
#include "reports/run_folder/run_folder.h"

namespace axiscert {
namespace {

struct PlanOptions : RunOptions {
  std::optional<std::uint64_t> units_each;
  std::string file = "plan.json";
};

int plan(const PlanOptions& options) {
  const PlanFile file = plan_file_of(options, options.units_each);
  const std::filesystem::path path(options.file);
  write_files(path.parent_path(), {{path.filename().string(), file.text()}});
  fmt::print("{}: {} queries in {} units; {} stretches of {}; digest {}\n", options.file,
             file.json["queries"].get<std::uint64_t>(), file.json["units"].get<std::uint64_t>(),
             file.json["stretches"].get<std::uint64_t>(), file.units_each, file.digest);
  return exit_done;
}

}  // namespace

void add_plan(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand(
      "plan", "Write a plan file, for `run --plan` in parts, on many machines, and again after an interruption");
  auto options = std::make_shared<PlanOptions>();
  add_plan_options(*command, *options);
  add_require_options(*command, options->required);
  command
      ->add_option("--units-per-stretch", options->units_each,
                   "units handed out, journalled and repeated together (default: 1 in small plans, 16 in others, more "
                   "where the journal would have more than 2^22 entries)")
      ->check(whole_number(1, std::uint64_t{1} << 40));
  command->add_option("--out", options->file, "the file")->capture_default_str();
  command->callback([&action, options] { action = [options] { return plan(*options); }; });
}

}  // namespace axiscert

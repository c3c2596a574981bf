#include "cli/commands.h"
#include "cli/judged_run.h"

namespace axiscert {

void add_run(CLI::App& app, Action& action) {
  auto* command =
      app.add_subcommand("run", "Run kernels over families, meshes and query files, judge them and write a report");
  auto options = std::make_shared<RunOptions>();
  add_run_options(*command, *options);
  command->callback(
      [&action, options] { action = [options] { return judged_run(plan_of(*options), *options, options->target); }; });
}

}  // namespace axiscert

#include "cli/commands.h"
#include "cli/running/judged_run.h"
#include "cli/running/planned_run.h"

namespace axiscert {

void add_run(CLI::App& app, Action& action) {
  auto* command =
      app.add_subcommand("run", "Run kernels over families, meshes and query files, judge them and write a report");
  auto options = std::make_shared<RunOptions>();
  auto planned = std::make_shared<PlannedOptions>();
  add_run_options(*command, *options);
  add_planned_options(*command, *planned);
  command->callback([&action, options, planned] {
    action = [options, planned] {
      if (!planned->plan.empty()) return run_planned(*planned, *options);
      return put_result(judge_run(plan_of(*options), *options, options->target), *options);
    };
  });
}

}  // namespace axiscert

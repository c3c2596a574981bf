#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/progress_line.h"
#include "reports/formats/render.h"

namespace axiscert {

void add_report(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand("report", "Render the reports of a run folder again from its record.json");
  auto folder = std::make_shared<std::string>();
  command->add_option("DIR", *folder, "the folder that `run --out` wrote")->required();
  add_progress(*command);
  command->callback([&action, folder] {
    action = [folder] {
      {
        ProgressLine progress("report");
        render_reports(*folder);
      }
      fmt::print("{}/report.html\n", *folder);
      return exit_done;
    };
  });
}

}  // namespace axiscert

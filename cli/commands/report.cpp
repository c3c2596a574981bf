#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/progress_line.h"
#include "fuzz/text/file_bytes.h"
#include "reports/formats/render.h"

namespace axiscert {

void add_report(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand("report", "Render the reports of a run folder again from its record.json");
  auto folder = std::make_shared<std::string>(), format = std::make_shared<std::string>("text");
  command->add_option("DIR", *folder, "the folder that `run --out` wrote")->required();
  add_format(*command, *format, {"csv"});
  add_progress(*command);
  command->callback([&action, folder, format] {
    action = [folder, format] {
      {
        ProgressLine progress("report");
        render_reports(*folder);
      }
      if (*format == "csv") fmt::print("{}", read_bytes(*folder + "/" + record_csv_file));
      else fmt::print("{}/report.html\n", *folder);
      return exit_done;
    };
  });
}

}  // namespace axiscert

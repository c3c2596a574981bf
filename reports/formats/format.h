// The report formats. A new one is a file that defines a Format, and a line in format.cpp.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "fuzz/text/json_fwd.h"
#include "reports/run_folder/run_folder.h"

namespace axiscert {
struct Format {
  const char* file;                   // its name in the run's folder
  const char* meaning;                // what report.html's list of files says of it; null for the page itself
  std::string (*render)(const Run&);  // takes a run that read_run accepted
};

// In the order in which report.html lists their files.
std::span<const Format* const> formats();

// Writes the reports of a run into its folder.

// The file that `--format csv` prints.
inline constexpr const char* record_csv_file = "record.csv";

// Renders record.json, and run.json where there is one, to the file of every format. All are
// rendered before any is written. Throws Error, and then has replaced nothing unless the disk itself failed.
void render_reports(const std::filesystem::path& run_folder);

// The list of files at the end of report.html.

// The files of the folder that the page can point to: [{"name", "meaning"}].
Json raw_files(const std::filesystem::path& folder);

}  // namespace axiscert

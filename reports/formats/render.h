// Writes the reports of a run into its folder.
#pragma once

#include <filesystem>

namespace axiscert {

// The file that `--format csv` prints.
inline constexpr const char* record_csv_file = "record.csv";

// Renders record.json, and run.json where there is one, to the file of every format (reports/formats/format.h). All are
// rendered before any is written. Throws Error, and then has replaced nothing unless the disk itself failed.
void render_reports(const std::filesystem::path& run_folder);

}  // namespace axiscert

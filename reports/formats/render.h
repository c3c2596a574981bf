// Writes what people read into a run's folder.
#pragma once

#include <filesystem>

namespace axiscert {

// The file of every format (reports/formats/format.h), from record.json, and run.json where there is one. All are
// rendered before any is written. Throws Error, and then has replaced nothing unless the disk itself failed.
void render_reports(const std::filesystem::path& run_folder);

}  // namespace axiscert

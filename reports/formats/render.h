// Writes what people read into a run's folder.
#pragma once

#include <filesystem>

namespace axiscert {

// From record.json, and run.json where there is one: report.html, report.md, junit.xml, report.sarif,
// ratchet.txt, witnesses.jsonl. All are
// rendered before any is written. Throws Error, and then has replaced nothing unless the disk itself failed.
void render_reports(const std::filesystem::path& run_folder);

}  // namespace axiscert

// Writes the reports of a run into its folder.
#pragma once

#include <filesystem>

namespace axiscert {

// Renders record.json, and run.json where there is one, to report.html, report.md, junit.xml, report.sarif, ratchet.txt
// and witnesses.jsonl. All are rendered before any is written. Throws Error, and then has replaced nothing unless the
// disk itself failed.
void render_reports(const std::filesystem::path& run_folder);

}  // namespace axiscert

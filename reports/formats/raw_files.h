// The list of files at the end of report.html.
#pragma once

#include <filesystem>

#include "fuzz/text/json.h"

namespace axiscert {

// The files of the folder that the page can point to: [{"name", "meaning"}].
Json raw_files(const std::filesystem::path& folder);

}  // namespace axiscert

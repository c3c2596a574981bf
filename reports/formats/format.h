// The report formats. A new one is a file that defines a Format, and a line in render.cpp.
#pragma once

#include <span>
#include <string>

#include "reports/run_folder/run_folder.h"

namespace axiscert {

struct Format {
  const char* file;                   // its name in the run's folder
  const char* meaning;                // what report.html's list of files says of it; null for the page itself
  std::string (*render)(const Run&);  // takes a run that read_run accepted
};

// In the order in which report.html lists their files.
std::span<const Format* const> formats();

}  // namespace axiscert

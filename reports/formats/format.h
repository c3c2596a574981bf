// The report formats: a new one is a file that defines a Format and a line in render.cpp.
#pragma once

#include <span>
#include <string>

#include "reports/run_folder/run_folder.h"

namespace axiscert {

struct Format {
  const char* file;                   // in the run's folder
  const char* meaning;                // as report.html's list of files says it; null for the page itself
  std::string (*render)(const Run&);  // of a run that read_run accepted
};

// In the order in which report.html lists their files.
std::span<const Format* const> formats();

}  // namespace axiscert

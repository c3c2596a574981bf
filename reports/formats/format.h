// The report formats. A new one is a file that defines a Format, and a line in render.cpp.
#pragma once

#include <string>

#include "reports/run_folder/run_folder.h"

namespace axiscert {

struct Format {
  const char* file;                   // its name in the run's folder
  std::string (*render)(const Run&);  // takes a run that read_run accepted
};

}  // namespace axiscert

// character MESH --sweep ERRAND: journeys by sweeps, side by side.
#pragma once

#include "examples/character/options.h"

namespace axiscert::character {

// Prints the tables; returns the exit code.
int run_sweeps(const Options& options);

}  // namespace axiscert::character

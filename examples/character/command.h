// character MESH --sweep ERRAND: journeys by sweeps, side by side.
#pragma once

#include <span>
#include <string>

#include "examples/character/judgement.h"
#include "examples/character/options.h"

namespace axiscert::character {
// Prints the tables; returns the exit code.
int run_sweeps(const Options& options);

// Journeys by sweeps as text.

struct TravelledSweep {
  std::string sweeper;
  std::uint64_t turns, set_down, left;
  SweepCounts counts;
  bool gives_times;
};

// Tables of the motions, of what was answered, and of what the sphere went into; the last per 1000 steps too.
std::string sweeps_table(std::span<const TravelledSweep> travelled, const JourneyOptions& options);

}  // namespace axiscert::character

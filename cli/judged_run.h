// A plan carried out, judged and reported: what `run` and `judge` do once they know their plan.
#pragma once

#include <string>

#include "cli/run_options.h"

namespace axiscert {

// Writes the run's folder and prints its summary; returns an ExitCode. Throws Error, and HarnessFault where the oracles
// disagree.
int judged_run(const Plan& plan, const OutputOptions& output, const std::string& target_asked);

}  // namespace axiscert

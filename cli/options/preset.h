// Presets of `axiscert run`: plans with a name. A new one is a line in preset.cpp.
#pragma once

#include <string>
#include <vector>

#include "cli/options/run_options.h"

namespace axiscert {

std::vector<std::string> preset_names();
// Sets the options that were not given to the preset's values for a run of this predicate, which may have no corpus.
// The name is one of preset_names().
void apply_preset(const std::string& name, const Predicate& predicate, RunOptions& options);

}  // namespace axiscert

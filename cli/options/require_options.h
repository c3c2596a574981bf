// The options that say what a run has to meet.
#pragma once

#include <CLI/CLI.hpp>

#include "fuzz/confirm/plan.h"

namespace axiscert {

// Adds --require and --allow-unchecked.
void add_require_options(CLI::App& command, RunRequirements& required);

// Throws Error where a level does not exist, is not written as it has to be, or may be left unchecked and is not
// required; and where a kernel that others are measured against is not among the plan's.
void check_required(const RunRequirements& required, const Plan& plan);

}  // namespace axiscert

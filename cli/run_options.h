// Declares the options of `axiscert run`, and those that it shares with `generate` and `judge`
// (plans/run_plan.h).
#pragma once

#include <CLI/CLI.hpp>

#include "plans/run_plan.h"

namespace axiscert {

// Adds the options and returns --trials, which others may exclude.
CLI::Option* add_source_options(CLI::App& command, SourceOptions& options);
// Adds the options that a plan file keeps: kernels, queries, precision, tolerances. Also returns --trials.
CLI::Option* add_plan_options(CLI::App& command, RunOptions& options);
void add_thread_option(CLI::App& command, int& threads);
void add_output_options(CLI::App& command, OutputOptions& options);
void add_run_options(CLI::App& command, RunOptions& options);

// The options that say what a run has to meet.

// Adds --require and --allow-unchecked.
void add_require_options(CLI::App& command, RunRequirements& required);

}  // namespace axiscert

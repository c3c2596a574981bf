// The options of `axiscert run`, and the plan they make.
#pragma once

#include <CLI/CLI.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "fuzz/campaign.h"

namespace axiscert {

struct RunOptions {
  std::vector<std::string> kernels, families, meshes, queries, tolerances;
  std::optional<std::uint64_t> trials;
  std::optional<double> seconds;
  std::uint64_t seed = 1;
  std::string precision;  // empty: both
  std::string target = "auto", require, out = "out";
  int threads = 0;  // 0: all cores
};

void add_run_options(CLI::App& command, RunOptions& options);
// Looks up every name and reads every file. Throws Error.
Plan plan_of(const RunOptions& options);

}  // namespace axiscert

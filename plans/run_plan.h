// What a run is asked for, by names, and the plan that it leads to: for whoever asks, a command line or a program.
// Messages have the words of the command line.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/campaign/campaign.h"
#include "fuzz/confirm/record.h"

namespace axiscert {
// The queries.
struct SourceOptions {
  std::string predicate;  // its id; empty: that of the kernels
  std::vector<std::string> families, meshes, queries;
  bool is_part = false;               // of query files with queries of several predicates, of those of one alone
  std::optional<std::string> corpus;  // its folder
  std::optional<std::uint64_t> trials;
  std::uint64_t seed = 1;
  std::string effort;    // of `axiscert certify`, which says how many queries where `trials` does not; empty: none
  bool is_slow = false;  // the kernels' answers take so long that an effort asks fewer
};

// The use of the judged answers.
struct OutputOptions {
  RunRequirements required;
  std::string out = "out", ratchet;
  std::vector<std::string> sources;  // [KERNEL=]FILE:LINE
  std::string format = "text";       // of what is printed at the end
  bool quiet = false;
  bool has_summary = true;   // printed at the end, and what came of the levels
  bool is_brief = false;     // the summary is without tables, and ends with one verdict
  std::uint64_t shrink = 0;  // evaluations to make each witness smaller; 0: they stay as they are
  int threads = 0;           // 0: all cores
};

struct RunOptions : SourceOptions, OutputOptions {
  std::vector<std::string> kernels, tolerances;
  std::optional<double> seconds;
  std::string precision;  // empty: both
  std::string preset;     // empty: none
  std::string target = "auto";
  bool exact_only = false;
  std::string planted = "none";
};

// Whether a kernel could not be loaded: it exists in no precision, whatever is requested.
bool is_unloadable(const Kernel& kernel);
// The families given by name, and the files, which are read; all families of `predicate` where nothing is named. Throws
// Error, also for a mesh or the corpus where these do not serve the predicate.
std::vector<SourcePtr> sources_of(const SourceOptions& options, const Predicate& predicate, std::size_t entry,
                                  Precision csv_precision);
// Number of queries of a source: as requested, or the default; the number of a query file's own queries is ignored.
std::uint64_t trials_of(const SourceOptions& options, const Source& source, Precision precision);
// Says in notices which queries of query files have none of these precisions.
void print_left_out(const std::vector<SourcePtr>& sources, const std::vector<Precision>& precisions,
                    std::string_view why = "--precision leaves out");
// The number of queries where none is given, for help.
std::string default_trials_text();
int threads_of(int given);
// Makes the plan: looks up every name and reads every file. Throws Error.
Plan plan_of(const RunOptions& options);

// The options with those of their preset that were not given: a plan with a name, for a run of the kernels' predicate.
// Throws Error.
RunOptions with_preset(const RunOptions& options);
std::vector<std::string> preset_names();
std::string presets_text();  // each with its meaning

// Throws Error where a level does not exist, is not written as it has to be, or may be left unchecked and is not
// required; and where a kernel that others are measured against is not among the plan's.
void check_required(const RunRequirements& required, const Plan& plan);

}  // namespace axiscert

#include "plans/kernel_figures.h"

#include <fmt/format.h>

#include <filesystem>

#include "fuzz/confirm/record.h"
#include "fuzz/queries/source.h"
#include "fuzz/search/pools.h"
#include "fuzz/text/file_bytes.h"
#include "kernel/base/error.h"
#include "kernel/registry/self_check.h"
#include "plans/notices.h"
#include "reports/instrument/diagnosis_report.h"
#include "reports/instrument/search_report.h"

namespace axiscert {
namespace {

// The precision that is given, or the first in which the kernel exists.
Precision precision_of_diagnosis(const DiagnoseOptions& options, const Kernel& kernel) {
  if (options.precision.empty()) return kernel.has(Precision::binary32) ? Precision::binary32 : Precision::binary64;
  const Precision precision = parse_precision(options.precision);
  if (!kernel.has(precision)) {
    throw Error(fmt::format("--precision {}: kernel {} does not exist in it", options.precision, kernel.id));
  }
  return precision;
}

}  // namespace

Diagnosed diagnosed(const DiagnoseOptions& options, const std::atomic<bool>& interrupted, const ShowProgress& show) {
  const Kernel& kernel = find_kernel(options.kernel);
  require_loaded(kernel);
  print_first_look(kernel);
  DiagnosisOptions asked;
  asked.precision = precision_of_diagnosis(options, kernel);
  asked.seed = options.seed;
  asked.interrupted = &interrupted;
  asked.report = show;
  Diagnosis diagnosis = diagnose(kernel, asked);
  const std::string command =
      fmt::format("axiscert diagnose {} --precision {} --seed {}", kernel.id, name(asked.precision), options.seed);
  InstrumentReport report = diagnosis_report(diagnosis, command);
  return {std::move(diagnosis), std::move(report)};
}

namespace {

constexpr const char* state_file = "search.state";

std::string command_of_search(const SearchOptions& options, const SearchPlan& plan, const SearchResult& result) {
  std::string command = fmt::format("axiscert search --kernel {} --precision {}", plan.kernel->id, options.precision);
  for (const std::string& which : options.comparisons) command += " --comparison " + which;
  for (const std::string& what : plan.what) command += " --what " + what;
  for (const std::string& family : options.families) command += " --family " + family;
  return command + fmt::format(" --evaluations {} --seed {}", result.evaluations, options.seed);
}

}  // namespace

std::optional<std::string> search_state(const SearchOptions& options) {
  if (!options.resume) return std::nullopt;
  if (options.out.empty()) throw Error("--resume: give the folder of the search to resume with --out");
  const std::filesystem::path stored = std::filesystem::path(options.out) / state_file;
  std::error_code ignored;
  if (!std::filesystem::exists(stored, ignored)) {
    throw Error(fmt::format("--resume --out {}: there is no {}; give the folder of a search that was begun with --out",
                            options.out, stored.string()));
  }
  std::string state = read_bytes(stored.string());
  require_state_format(state, stored.string());
  return state;
}

void write_search(const OutputFolder& folder, const SearchResult& result) {
  folder.write_text(state_file, result.state);
  folder.write_text("witnesses.jsonl", search_witnesses(result));
}

Searched searched(const SearchOptions& options, const SearchPlan& plan, const std::optional<std::string>& state,
                  const std::atomic<bool>& interrupted, const std::function<void(const SearchProgress&)>& show) {
  require_uncontracted(plan.target);
  SearchResult result = search(plan, state, interrupted, show);
  InstrumentReport report = search_report(plan, result, command_of_search(options, plan, result));
  return {std::move(result), std::move(report)};
}

}  // namespace axiscert

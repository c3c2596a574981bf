#include <fmt/format.h>

#include <filesystem>

#include "cli/commands.h"
#include "cli/running/judged_run.h"
#include "cli/running/planned_run.h"
#include "cli/progress_line.h"
#include "kernel/base/error.h"

namespace axiscert {
namespace {

namespace fs = std::filesystem;

struct MergeOptions {
  std::vector<std::string> folders;
  std::string out = "out", plan;
};

// Most parts of a list of units that a message names.
constexpr std::size_t most_parts = 20;

std::string in(const std::string& folder, const char* file) { return (fs::path(folder) / file).string(); }

// Requires every folder's copy of the plan to be this plan.
void require_same_plan(const PlanFile& file, const std::string& folder) {
  const PlanFile other = read_plan_file(in(folder, plan_copy));
  if (other.digest == file.digest) return;
  std::string differs = difference(other.json["plan"], file.json["plan"]);
  if (differs.empty()) differs = difference(other.json, file.json);
  throw Error(fmt::format("{}: part of another plan than {}: there {}", folder, file.path, differs));
}

void require_shard(const std::string& folder) {
  std::error_code ignored;
  if (fs::exists(in(folder, plan_copy), ignored)) return;
  throw Error(fmt::format("{}: {}; give folders that `axiscert run --plan --shard --out` wrote", folder,
                          !fs::exists(folder, ignored) ? "does not exist"
                          : fs::is_directory(folder, ignored)
                              ? fmt::format("no part of a plan: it has no {}", plan_copy)
                              : "not a folder"));
}

int merge(const MergeOptions& options) {
  for (const std::string& folder : options.folders) require_shard(folder);
  const PlanFile file = read_plan_file(options.plan.empty() ? in(options.folders.front(), plan_copy) : options.plan);
  for (const std::string& folder : options.folders) require_same_plan(file, folder);
  Plan plan = plan_of(file);
  plan.running.target = resolve_target("auto");
  const Stretches stretches(plan.questions, file.units_each);
  const OutputFolder folder(options.out);
  const auto started = std::chrono::system_clock::now();

  std::optional<ProgressLine> reading(std::in_place, "merge: the journals are read");
  GatheredStretches gathered(plan.questions, plan.answerers.kernels.size(), stretches);
  std::vector<std::uint32_t> from(stretches.count());  // for each stretch, the folder it is from
  std::uint64_t bytes = 0;
  for (std::uint32_t i = 0; i < options.folders.size(); ++i) {
    const std::string journal = in(options.folders[i], journal_file);
    const JournalEnd end = read_journal(journal, file.digest, [&](std::string_view content) {
      const auto entry = finished_in(content);
      if (entry && entry->stretch < stretches.count() && gathered.has(entry->stretch)) {
        throw Error(fmt::format("{}: {}: already in {}: give each part once", journal, stretches.text(entry->stretch),
                                in(options.folders[from[entry->stretch]], journal_file)));
      }
      gathered.replay(content);
      if (entry) from[entry->stretch] = i;
    });
    bytes += end.whole;
    if (end.torn != 0) {
      reading->clear();
      fmt::print(stderr, "axiscert: {}: its last entry was cut off while it was being written: {} bytes dropped\n",
                 journal, end.torn);
    }
  }
  reading.reset();
  if (const auto missing = gathered.missing(); !missing.empty()) {
    throw Error(
        fmt::format("{} of the plan's {} units are missing: {}; run their shards with --resume, or name their "
                    "folders too",
                    stretches.units() - gathered.units(), stretches.units(), stretches.text(missing, most_parts)));
  }
  OutputOptions output;
  output.out = options.out;
  output.required = file.options.required;
  const RunScale scale{file.digest, stretches.count(), stretches.units_each(), gathered.lost_units(), bytes, {}};
  return put_result({folder, std::nullopt, run_files(plan, std::move(gathered).take(), output, "auto", started, scale)},
                    output);
}

}  // namespace

void add_merge(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand("merge", "Join the shards of a plan into the record of the whole plan");
  auto options = std::make_shared<MergeOptions>();
  command->add_option("FOLDER", options->folders, "folders that `run --plan --shard --out` wrote, in any order")
      ->required();
  command->add_option("--plan", options->plan, "present path of the plan (default: the first folder's copy of it)");
  command->add_option("--out", options->out, "folder for record, reports and witnesses")->capture_default_str();
  add_progress(*command);
  command->callback([&action, options] { action = [options] { return merge(*options); }; });
}

}  // namespace axiscert

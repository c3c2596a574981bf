#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "cli/commands.h"
#include "cli/commands/judged_run.h"
#include "cli/commands/planned_run.h"
#include "cli/help.h"
#include "cli/progress_line.h"
#include "cli/reply_plan.h"
#include "cli/run_options.h"
#include "cli/shared_options.h"
#include "cli/usage.h"
#include "fuzz/text/file_bytes.h"
#include "kernel/base/error.h"
#include "plans/given_queries.h"
#include "plans/plan_file.h"
#include "plans/predicate_options.h"
#include "reports/formats/format.h"
#include "reports/run_folder/run_folder.h"
#include "reports/wording/reproduce.h"

namespace axiscert {
namespace {

// The options of each run that query files with several predicates ask for: its kernels, its folder. One where they
// have queries of one predicate and entry, as the files of most runs. Throws Error for what can be of one predicate
// alone.
std::vector<RunOptions> parts_of_run(const RunOptions& options) {
  const Precision csv_precision = options.precision.empty() ? Precision::binary32 : parse_precision(options.precision);
  const std::vector<QueryPart> parts = query_parts(options.queries, csv_precision, options.predicate, options.kernels);
  if (parts.size() < 2) return {with_preset(options)};
  for (const auto& [name, is_given] : {std::pair("--family", !options.families.empty()),
                                       {"--mesh", !options.meshes.empty()},
                                       {"--corpus", options.corpus.has_value()},
                                       {"--preset", !options.preset.empty()},
                                       {"--ratchet", !options.ratchet.empty()},
                                       {"--format csv", options.format == "csv"}}) {
    if (!is_given) continue;
    throw Error(fmt::format("{} is of one predicate, and the queries are of {}; choose one with --predicate", name,
                            parts.size()));
  }
  std::vector<RunOptions> runs;
  for (const QueryPart& part : parts) {
    RunOptions& run = runs.emplace_back(options);
    run.predicate = part.predicate->id;
    run.kernels = part.kernels;
    if (run.kernels.empty()) run.kernels = {default_kernel(*part.predicate, part.entry).id};
    run.is_part = true;
    run.out = (std::filesystem::path(options.out) / part.folder()).string();
  }
  return runs;
}

// One run after the other; the levels have to hold in each.
int run_parts(const RunOptions& options) {
  const std::vector<RunOptions> runs = parts_of_run(options);
  std::vector<Plan> plans;  // all of them are looked up before the first is begun
  for (const RunOptions& run : runs) plans.push_back(plan_of(run));
  int code = exit_done;
  for (std::size_t i = 0; i < runs.size() && code < exit_interrupted; ++i)
    code = std::max(code, put_result(judge_run(plans[i], runs[i], runs[i].target), runs[i]));
  return code;
}

}  // namespace

void add_run(CLI::App& app, Action& action) {
  auto* command =
      app.add_subcommand("run", "Run kernels over families, meshes and query files, judge them and write a report");
  auto options = std::make_shared<RunOptions>();
  auto planned = std::make_shared<PlannedOptions>();
  add_run_options(*command, *options);
  add_planned_options(*command, *planned);
  for (const char* name : {"--plan", "--resume", "--shard", "--stretches", "--recheck", "--recheck-seed",
                           "--recheck-target", "--recheck-with"})
    command->get_option(name)->group("A plan in parts");
  add_examples(*command,
               {{"Is the method of my kernel right?", "axiscert run plugin:./my_kernel.so --require logic"},
                {"Two kernels on two families",
                 "axiscert run published certified --family tangent --family sliver --trials 1000"},
                {"My own queries, with a report in out/", "axiscert run published --queries mine.jsonl --out out"}});
  command->callback([&action, options, planned] {
    action = [options, planned] {
      if (!planned->plan.empty()) return run_planned(*planned, *options);
      return run_parts(*options);
    };
  });
}

namespace {

struct PlanOptions : RunOptions {
  std::optional<std::uint64_t> units_each;
  std::string file = "plan.json";
};

int plan(const PlanOptions& options) {
  const PlanFile file = plan_file_of(options, options.units_each);
  const std::filesystem::path path(options.file);
  write_files(path.parent_path(), {{path.filename().string(), file.text()}});
  fmt::print("{}: {} queries in {} units; {} stretches of {}; digest {}\n", options.file,
             file.json["queries"].get<std::uint64_t>(), file.json["units"].get<std::uint64_t>(),
             file.json["stretches"].get<std::uint64_t>(), file.units_each, file.digest);
  return exit_done;
}

}  // namespace

void add_plan(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand(
      "plan", "Write a plan file, for `run --plan` in parts, on many machines, and again after an interruption");
  auto options = std::make_shared<PlanOptions>();
  add_plan_options(*command, *options);
  add_require_options(*command, options->required);
  command
      ->add_option("--units-per-stretch", options->units_each,
                   "units handed out, journalled and repeated together (default: 1 in small plans, 16 in others, more "
                   "where the journal would have more than 2^22 entries)")
      ->check(whole_number(1, std::uint64_t{1} << 40));
  add_out_file(*command, options->file, "the plan");
  add_examples(*command,
               {{"A long run", "axiscert plan published certified --family all --trials 1000000 -o plan.json"},
                {"What it has to meet is a part of it", "axiscert plan certified --require exact -o plan.json"}});
  command->callback([&action, options] { action = [options] { return plan(*options); }; });
}

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

// Says of each shard that these folders leave unfinished, or do not have, how it goes on.
void print_unfinished_shards(const MergeOptions& options, const PlanFile& file, const GatheredStretches& gathered) {
  const std::vector<std::uint64_t> missing = gathered.missing();
  std::map<std::string, std::string> folders;  // by shard, "I/N"
  std::string parts;                           // "/N", where all folders state the same
  for (const std::string& folder : options.folders) {
    std::error_code none;
    if (!fs::exists(in(folder, shard_file), none)) return;
    const std::string shard = read_bytes(in(folder, shard_file)), name = shard.substr(0, shard.find('\n'));
    shard_of(name);  // throws where it is none
    folders[name] = folder;
    const std::string its_parts = name.substr(name.find('/'));
    if (parts.empty()) parts = its_parts;
    if (parts != its_parts) return;
  }
  const std::uint64_t shards = std::stoull(parts.substr(1));
  std::size_t shown = 0;
  for (std::uint64_t i = 1; i <= shards && shown < most_parts; ++i) {
    const std::string name = fmt::format("{}{}", i, parts);
    const Selection is_selected = shard_of(name);
    if (std::ranges::none_of(missing, is_selected)) continue;
    const auto found = folders.find(name);
    const std::string out = found != folders.end()
                                ? found->second
                                : (fs::path(options.folders.front()).parent_path() / std::to_string(i)).string();
    fmt::print(stderr, "axiscert: shard {} {}; this {}:\n  axiscert run --plan {} --shard {} --out {} --resume\n", name,
               found != folders.end() ? printable_line("is not done in " + out) : "is in none of these folders",
               found != folders.end() ? "goes on" : "does it", shell_word(file.path), name, shell_word(out));
    ++shown;
  }
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
    print_unfinished_shards(options, file, gathered);
    throw Error(
        fmt::format("{} of the plan's {} units are missing: {}; run their shards with --resume, or name their "
                    "folders too",
                    stretches.units() - gathered.units(), stretches.units(), stretches.text(missing, most_parts)));
  }
  OutputOptions output;
  output.out = options.out;
  output.required = file.options.required;
  const RunScale scale{file.digest, stretches.count(), stretches.units_each(), gathered.lost_units(), bytes, {}};
  return put_result(
      {folder, std::nullopt, shown_run_files(plan, std::move(gathered).take(), output, "auto", started, scale)},
      output);
}

}  // namespace

void add_merge(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand("merge", "Join the shards of a plan into the record of the whole plan");
  auto options = std::make_shared<MergeOptions>();
  command->add_option("FOLDER", options->folders, "folders that `run --plan --shard --out` wrote, in any order")
      ->required();
  command->add_option("--plan", options->plan, "present path of the plan (default: the first folder's copy of it)");
  add_out(*command, options->out, "record, reports and witnesses");
  add_progress(*command);
  add_examples(*command,
               {{"Two shards", "axiscert merge shard-1 shard-2 --out merged"},
                {"The plan's file is elsewhere", "axiscert merge shard-1 shard-2 --plan plan.json --out merged"}});
  command->callback([&action, options] { action = [options] { return merge(*options); }; });
}

namespace {

struct JudgeOptions : OutputOptions, ReplyOptions {};

int judge_replies(const JudgeOptions& options) {
  std::optional<ProgressLine> reading(std::in_place, "judge: the replies are read", options.quiet);
  ReplyPlan replies = reply_plan(options);
  reading.reset();
  replies.plan.running.threads = threads_of(options.threads);
  check_required(options.required, replies.plan);
  return put_result(judge_run(replies.plan, options, replies.plan.running.target), options);
}

}  // namespace

void add_judge(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand(
      "judge", "Judge a program's replies to the queries of `generate --binary` and write a report as `run` does");
  auto options = std::make_shared<JudgeOptions>();
  command->add_option("FILE", options->replies, "reply files, one for each precision; - for standard input")
      ->capture_default_str();
  add_reply_options(*command, *options);
  add_output_options(*command, *options);
  add_examples(*command, {{"A file of replies", "axiscert judge replies.bin --as my-engine --require logic"},
                          {"A program in a pipe",
                           "axiscert generate --binary --family tangent | ./my_program | axiscert judge - --out out"}});
  command->callback([&action, options] { action = [options] { return judge_replies(*options); }; });
}

void add_report(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand("report", "Render the reports of a run folder again from its record.json");
  auto folder = std::make_shared<std::string>(), format = std::make_shared<std::string>("text");
  command->add_option("DIR", *folder, "the folder that `run --out` wrote")->required();
  add_format(*command, *format, {"csv"});
  add_progress(*command);
  add_examples(*command, {{"The page and the texts, again", "axiscert report out"},
                          {"The counts, for a spreadsheet", "axiscert report out --format csv"}});
  command->callback([&action, folder, format] {
    action = [folder, format] {
      {
        ProgressLine progress("report");
        render_reports(*folder);
      }
      if (*format == "csv") fmt::print("{}", read_bytes(*folder + "/" + record_csv_file));
      else fmt::print("{}/report.html\n", *folder);
      return exit_done;
    };
  });
}

}  // namespace axiscert

#include "cli/running/certify.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <map>

#include "cli/commands.h"
#include "cli/progress_line.h"
#include "cli/running/certify_stages.h"
#include "cli/running/judged_run.h"
#include "cli/running/planned_run.h"
#include "cli/running/stretch_crew.h"
#include "fuzz/campaign/parts/gathered.h"
#include "fuzz/campaign/parts/journal.h"
#include "kernel/base/error.h"
#include "kernel/base/version.h"
#include "kernel/registry/self_check.h"
#include "reports/certificate/certificate.h"
#include "reports/certificate/findings/breaks.h"
#include "reports/certificate/findings/levels.h"
#include "reports/certificate/page.h"
#include "reports/certificate/statement/statement.h"
#include "reports/run_folder/run_folder.h"
#include "reports/wording/reproduce.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

namespace fs = std::filesystem;

std::string command_of(const CertifyOptions& options) {
  std::string command = "axiscert certify";
  if (options.is_of_replies) {
    for (const std::string& file : options.replies.replies) command += " --replies " + shell_word(file);
    return command + fmt::format(" --effort {}", options.effort);
  }
  command += fmt::format(" {} --effort {} --seed {}", shell_word(options.kernel), options.effort, options.seed);
  for (const std::string& mesh : options.meshes) command += " --mesh " + shell_word(mesh);
  if (options.seconds) command += fmt::format(" --time {}", *options.seconds);
  return command;
}

// A run that was judged: what a certificate is made of besides the stages.
struct Judged {
  const CertifyOptions& options;
  const Plan& plan;  // of which the kernel is the first
  const Stretches& stretches;
  std::map<std::uint64_t, Json> digests;  // by stretch that was done, of each kernel's tally
  Json plan_json, subjects;
  std::string kind, effort, digest;  // of the kernel; the plan's digest
  std::vector<std::string> yardsticks;
  bool is_slow;

  const Kernel& kernel() const { return *plan.kernels.front(); }
};

// The stretches in their order, each with the digest of every kernel's tally.
Json tallies_json(const std::map<std::uint64_t, Json>& by_stretch, const Stretches& stretches) {
  Json tallies = Json::array();
  for (const auto& [stretch, digests] : by_stretch)
    tallies.push_back({{"stretch", stretch}, {"of", stretches.text(stretch)}, {"sha256", digests}});
  return tallies;
}

Json kernel_json(const Staged& staged, const std::string& kind) {
  const Kernel& kernel = staged.kernel;
  Json exposes = Json::array(), precisions = Json::array(), limits = nullptr;
  for (const Exposure e : enumerators<Exposure>) {
    if (e <= kernel.exposes) exposes.push_back(exposure_names[e]);
  }
  for (const Precision precision : staged.precisions()) precisions.push_back(name(precision));
  for (const Json& entry : staged.record["kernels"]) {
    if (entry["id"] == kernel.id && has_limits(entry)) limits = limits_text(entry);
  }
  return {{"id", kernel.id},
          {"kind", kind},
          {"test", kernel.test->id},
          {"entry", kernel.test->entries[kernel.entry].name},
          {"summary", kernel.summary},
          {"exposes", exposes},
          {"touching", name(kernel.touching)},
          {"limits", limits},
          {"precisions", precisions}};
}

// Every kernel of the run, on the same queries.
Json comparison_json(const Json& record) {
  Json rows = Json::array();
  for (const Json& entry : record["kernels"]) {
    const Json total = all_families(entry);
    if (total.empty()) continue;
    const Json& verdict = total["verdict"];
    const Json radius = entry.value("critical_radius", Json::object());
    const auto ulps = [&](const char* member) {
      const Json figure = radius.is_object() ? radius.value(member, Json()) : Json();
      return figure.is_number() ? Json(amount(figure.get<double>(), 3)) : figure;
    };
    rows.push_back({{"kernel", entry["id"]},
                    {"precision", entry["precision"]},
                    {"missed", verdict["false_separation"]},
                    {"deepest_missed", amount(verdict["deepest_false_separation"].get<double>(), 3)},
                    {"phantom", verdict["false_contact"]},
                    {"deepest_phantom", amount(verdict["deepest_false_contact"].get<double>(), 3)},
                    {"median_ulps", ulps("median_ulps")},
                    {"largest_ulps", ulps("largest_ulps")}});
  }
  return rows;
}

// Sentences that say what the certificate leaves open.
Json limits_of(const Staged& staged, const Json& predicate) {
  Json limits = Json::array();
  const Kernel& kernel = staged.kernel;
  limits.push_back(
      "What is met was observed on queries that these families make, but for what `proved` says there: no number of "
      "queries "
      "proves it for others, and the bounds are of rates in these families, not in a game.");
  if (!predicate["asked"]["complete"].get<bool>()) {
    limits.push_back(fmt::format("{} of the plan's {} stretches were not run: the time given was over.",
                                 predicate["asked"]["stretches"].get<std::uint64_t>() -
                                     predicate["asked"]["stretches_done"].get<std::uint64_t>(),
                                 predicate["asked"]["stretches"].get<std::uint64_t>()));
  }
  if (kernel.exposes == Exposure::verdict)
    limits.push_back("The kernel shows its verdict alone: why it is wrong was inferred from the input, and not seen.");
  const Json& harness = predicate["harness"];
  for (const auto& [precision, score] : harness["score"].items()) {
    limits.push_back(
        fmt::format("Of {} faults planted in a right kernel that shows as much, {} were not noticed in {}: a fault as "
                    "small as those "
                    "may be in this kernel too.",
                    score["mutants"].get<std::uint64_t>(), score["survived"].get<std::uint64_t>(), precision));
  }
  if (!harness["reason"].is_null())
    limits.push_back(
        fmt::format("How many faults such a run notices was not asked: {}.", harness["reason"].get<std::string>()));
  if (!predicate["search"]["reason"].is_null())
    limits.push_back(fmt::format("No search was made: {}.", predicate["search"]["reason"].get<std::string>()));
  else limits.push_back("A search gives lower bounds of the worst: it says nothing about what it did not find.");
  if (predicate["safe_margin"]["reason"].is_null())
    limits.push_back("The safe margin mends what was seen here; a contact that nothing here showed may need more.");
  if (!predicate["kernel"]["limits"].is_null()) {
    limits.push_back(fmt::format("The kernel promises to be right only there: {}; it was held to nothing else.",
                                 predicate["kernel"]["limits"].get<std::string>()));
  }
  if (staged.options.is_of_replies) {
    limits.push_back("The subject is replies: what gave them, and whether it gives them again, is not known.");
  } else if (kernel.file.empty()) {
    limits.push_back(
        "The subject is the kernel as axiscert's sources have it, built without contraction: an engine's copy of it, "
        "or "
        "another compiler's, is another kernel.");
  } else {
    limits.push_back(
        "The subject is these files as they were called here: the libraries that they load, and the machine, are not "
        "part of it.");
  }
  return limits;
}

Json asked_json(const Judged& judged, const Json& tallies) {
  const CertifyOptions& options = judged.options;
  const Plan& plan = judged.plan;
  const Stretches& stretches = judged.stretches;
  std::uint64_t queries = 0;
  for (const Json& tally : tallies) queries += stretches.at(tally["stretch"].get<std::uint64_t>()).queries;
  Json families = Json::array();
  for (const SourcePtr& source : plan.sources) families.push_back(source->name());
  return {{"effort", judged.effort},
          {"seed", plan.seed},
          {"seconds", options.seconds ? Json(fmt::format("{}", *options.seconds)) : Json(nullptr)},
          {"complete", tallies.size() == stretches.count()},
          {"stretches", stretches.count()},
          {"stretches_done", tallies.size()},
          {"queries", queries},
          {"families", families}};
}

// The second half, by rank 0, once the run's folder is written.
int write_certificate(const Judged& judged, const std::optional<SigningKey>& key) {
  const CertifyOptions& options = judged.options;
  const Kernel& kernel = judged.kernel();
  const OutputFolder folder(options.out);
  const Run run = read_run(fs::path(options.out) / "run");
  const EffortSize size = size_of(parse_effort(options.effort), *judged.plan.test, judged.is_slow);
  const Staged staged{options, kernel, judged.plan, run.record, size};
  Stages stages(folder, options.out, judged.digest, options.resume);

  const Json tallies = tallies_json(judged.digests, judged.stretches);
  Json predicate = {{"schema", certificate_schema}, {"signed_at", nullptr}};
  predicate["kernel"] = kernel_json(staged, judged.kind);
  predicate["asked"] = asked_json(judged, tallies);
  predicate["search"] = search_stage(staged, stages);
  predicate["levels"] = levels_json(run.record, kernel, judged.yardsticks, predicate["search"]["precisions"]);
  predicate["safe_margin"] = margin_stage(staged, stages, predicate["search"]);
  predicate["diagnosis"] = diagnosis_stage(staged, stages);
  predicate["harness"] = harness_stage(staged, stages);
  predicate["comparison"] = comparison_json(run.record);
  predicate["breaks_first"] = what_breaks_first(run.record, kernel.id);
  predicate["situations"] = where_it_is_wrong(run.record, kernel.id);
  predicate["witnesses"] = worst_of_certificate(run.record, kernel.id);
  predicate["limits"] = limits_of(staged, predicate);
  const Json portable = portable_plan(judged.plan_json);
  predicate["materials"] = {{"axiscert", {{"version", axiscert_version}, {"sources", source_digests().sources}}},
                            {"proofs", source_digests().proofs},
                            {"plan",
                             {{"digest", digest_of_json(portable)},
                              {"units_per_stretch", judged.stretches.units_each()},
                              {"yardsticks", judged.yardsticks},
                              {"plan", portable}}},
                            {"tallies", tallies}};
  if (key) predicate["signed_at"] = iso_time(std::chrono::system_clock::now());
  const Json statement = with_digest({{"_type", statement_schema},
                                      {"subject", judged.subjects},
                                      {"predicateType", certificate_type},
                                      {"predicate", predicate}});
  const InstrumentReport report = certificate_report(statement, command_of(options));
  const std::string words = certificate_words(report);
  folder.write_text("certificate.json", certificate_text(statement, key ? &*key : nullptr));
  folder.write_text("certificate.html", instrument_page(report));
  folder.write_text("certificate.txt", words);
  folder.write_text("badge.svg", certificate_badge(statement));
  if (!options.quiet) fmt::print("{}\n{}/certificate.json\n", words, options.out);
  return exit_done;
}

int interrupted_in(const CertifyOptions& options) {
  fmt::print(stderr, "axiscert: interrupted; `certify` with --resume continues in {}\n", options.out);
  return exit_interrupted;
}

std::string run_folder_of(const CertifyOptions& options) { return (fs::path(options.out) / "run").string(); }

// The kernel's run is a plan with a journal, on ranks where there are some.
int certify_kernel(const CertifyOptions& options, const std::optional<SigningKey>& key) {
  const PlanFile file = certified_plan(options);
  RunOptions run = file.options;
  run.out = run_folder_of(options);
  run.threads = options.threads;
  run.quiet = options.quiet;
  run.has_summary = false;
  const std::string journal = (fs::path(run.out) / journal_file).string();
  std::error_code ignored;
  const bool is_begun = fs::exists(journal, ignored);
  if (is_begun && !options.resume) {
    throw Error(fmt::format(
        "--out {}: holds a certificate's run already; --resume continues it, or give another folder", options.out));
  }
  PlannedOptions planned;
  planned.made = file;
  planned.seconds = options.seconds;
  planned.resume = is_begun;
  const std::atomic<bool>& interrupted = watch_for_interrupts();
  planned.after = [&](int code) -> int {
    if (interrupted) return interrupted_in(options);
    if (code == exit_harness_fault || code == exit_bad_input) return code;
    const Plan plan = plan_of(file);
    const Stretches stretches(plan, file.units_each);
    const Kernel& kernel = *plan.kernels.front();
    Judged judged{options,
                  plan,
                  stretches,
                  {},
                  file.json["plan"],
                  subjects_of(kernel),
                  kind_of_kernel(kernel),
                  options.effort,
                  file.digest,
                  yardsticks_for(kernel),
                  file.options.is_slow};
    read_journal(journal, file.digest, [&](std::string_view content) {
      if (const auto entry = finished_in(content)) judged.digests[entry->stretch] = tally_digests(*entry);
    });
    try {
      return write_certificate(judged, key);
    } catch (const StageInterrupted&) {
      return interrupted_in(options);
    }
  };
  return planned_run(planned, run);
}

// Replies are judged as they are: nothing can be asked again.
int certify_replies(const CertifyOptions& options, const std::optional<SigningKey>& key) {
  ReplyPlan replies = reply_plan(options.replies);
  Plan& plan = replies.plan;
  plan.threads = threads_of(options.threads);
  for (const std::string& target : targets_of(plan)) require_uncontracted(target);
  const Stretches stretches(plan, Stretches::default_units_each(plan));
  Gathered gathered(plan, stretches);
  Judged judged{options,   plan, stretches, {},  plan_json(plan, planned(plan), {}), Json::array(), "replies",
                "replies", "",   {},        true};
  for (const std::string& path : options.replies.replies) judged.subjects.push_back(file_subject(path, "replies"));
  judged.digest = digest_of_json(judged.subjects);
  const OutputFolder folder(run_folder_of(options));
  const auto started = std::chrono::system_clock::now();
  const std::atomic<bool>& interrupted = watch_for_interrupts();
  try {
    ProgressLine progress("certify: the replies are judged", options.quiet);
    run_stretches(plan, stretches, gathered.missing(), interrupted, progress.report(), [&](const Entry& entry) {
      judged.digests[entry.stretch] = tally_digests(entry);
      gathered.add(entry);
    });
  } catch (const OracleDisagreement& disagreement) {
    throw saved(folder, disagreement);
  }
  if (interrupted) return exit_interrupted;
  OutputOptions output;
  output.out = run_folder_of(options);
  output.quiet = options.quiet;
  output.has_summary = false;
  put_result(folder, plan, std::move(gathered).take(), output, std::nullopt, plan.target, started);
  try {
    return write_certificate(judged, key);
  } catch (const StageInterrupted&) {
    return exit_interrupted;
  }
}

}  // namespace

int certify(const CertifyOptions& options) {
  std::optional<SigningKey> key;
  if (!options.key.empty()) key = SigningKey::private_from(options.key);  // refused before anything runs
  return options.is_of_replies ? certify_replies(options, key) : certify_kernel(options, key);
}

}  // namespace axiscert

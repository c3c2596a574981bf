#include "cli/running/certify.h"

#include <fmt/format.h>

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
#include "reports/certificate/derived/counts.h"
#include "reports/certificate/derived/derived.h"
#include "reports/certificate/derived/margin_check.h"
#include "reports/certificate/derived/reduced.h"
#include "reports/certificate/findings/asked_words.h"
#include "reports/certificate/findings/breaks.h"
#include "reports/certificate/findings/levels.h"
#include "reports/certificate/page.h"
#include "reports/certificate/statement/canonical.h"
#include "reports/certificate/statement/statement.h"
#include "reports/run_folder/run_folder.h"
#include "reports/wording/reproduce.h"

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
  std::map<std::uint64_t, Json> tallies;  // by stretch, as the certificate has it
  Json plan_json, subjects;
  std::string kind, effort, digest;  // of the kernel; the plan's digest
  bool is_slow;

  const Kernel& kernel() const { return *plan.answerers.kernels.front(); }
};

Json materials_json(const Judged& judged, const Record& record) {
  const Json portable = portable_plan(judged.plan_json);
  Json tallies = Json::array();
  for (const auto& [stretch, tally] : judged.tallies) tallies.push_back(tally);
  return {{"axiscert", {{"version", axiscert_version}, {"sources", source_digests().sources}}},
          {"proofs", source_digests().proofs},
          {"plan",
           {{"digest", digest_of_json(portable)},
            {"units_per_stretch", judged.stretches.units_each()},
            {"plan", portable}}},
          {"kernels", kernels_of_record(record)},
          {"findings", findings_of_record(record)},
          {"tallies", tallies}};
}

// A kernel that answers the same queries otherwise has no safe margin, since what it missed it may find next time.
void drop_margin_beside(const Record& record, Json& predicate) {
  Json& margins = predicate["safe_margin"];
  for (const Json& margin : margins["precisions"]) {
    for (const KernelRecord& entry : record.kernels) {
      if (entry.id != predicate["kernel"]["id"].get<std::string>() ||
          margin["precision"].get<std::string>() != name(entry.precision))
        continue;
      const std::string fault = margin_fault(margin, entry);
      if (fault.empty()) continue;
      margins = {{"reason", fmt::format("{}in {}, {}", margin_answered_otherwise, name(entry.precision), fault)},
                 {"precisions", Json::array()}};
      return;
    }
  }
}

// Makes what follows from the counts, of them alone, as `verify` does. Throws HarnessFault where the run's record says
// otherwise.
void put_derived(const Record& record, const Record& run_record, Json& predicate) {
  const Json members = derived_members(predicate, record);
  predicate.update(members);
  const std::string id = predicate["kernel"]["id"];
  predicate["breaks_first"] = what_breaks_first(run_record, id);
  const Json levels = levels_json(run_record, id, predicate["search"]["precisions"]);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const Json& derived = members["levels"][i];
    if (levels[i]["state"] == derived["state"]) continue;
    throw HarnessFault(fmt::format("{} of {} is {} by the record, and {} by its counts", levels[i]["level"].dump(), id,
                                   levels[i]["state"].dump(), derived["state"].dump()));
  }
}

// The second half, by rank 0, once the run's folder is written.
int write_certificate(const Judged& judged, const std::optional<SigningKey>& key) {
  const CertifyOptions& options = judged.options;
  const Kernel& kernel = judged.kernel();
  const OutputFolder folder(options.out);
  const Run run = read_run(fs::path(options.out) / "run");
  const EffortSize size = size_of(parse_effort(options.effort), *kernel.test, judged.is_slow);
  const Staged staged{options, kernel, judged.plan.questions, judged.plan.running, run.record, size};
  Stages stages(folder, options.out, judged.digest, options.resume);

  Json predicate = {{"schema", certificate_schema}, {"signed_at", nullptr}, {"signed_by", nullptr}};
  predicate["kernel"] = {{"id", kernel.id},
                         {"kind", judged.kind},
                         {"test", kernel.test->id},
                         {"entry", kernel.test->entries[kernel.entry].name}};
  predicate["asked"]["effort"] = judged.effort;
  predicate["materials"] = materials_json(judged, run.record);
  predicate["search"] = search_stage(staged, stages);
  predicate["safe_margin"] = margin_stage(staged, stages, predicate["search"]);
  predicate["diagnosis"] = diagnosis_stage(staged, stages);
  predicate["harness"] = harness_stage(staged, stages);
  predicate["witnesses"] = worst_of_certificate(run.record, kernel.id);
  predicate = Json::parse(canonical_json(predicate));  // members in the order in which `verify` reads them
  bool is_answered = false;
  try {
    const Record record = reduced_record(predicate, "the certificate");
    drop_margin_beside(record, predicate);
    put_derived(record, run.record, predicate);
    require_derived(predicate, "the certificate");
    is_answered = has_answers(record, kernel.id);
  } catch (const NotValid& wrong) {
    throw HarnessFault(
        fmt::format("a certificate that does not hold to itself was about to be written: {}", wrong.what()));
  }
  if (key) {
    predicate["signed_at"] = iso_time(std::chrono::system_clock::now());
    predicate["signed_by"] = key->id();
  }
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
  if (is_answered) return exit_done;
  fmt::print(stderr, "axiscert: {}: {}\n", kernel.id, no_answers_sentence(predicate));
  return exit_requirement_failed;
}

// --time is over before the plan is: there is nothing to sign yet.
int unfinished_in(const CertifyOptions& options, std::uint64_t done, std::uint64_t stretches) {
  fmt::print(stderr,
             "axiscert: {} of the plan's {} stretches are done, and a certificate has all of them: none is written; "
             "`certify` with --resume finishes it in {}\n",
             done, stretches, options.out);
  return exit_requirement_failed;
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
    const Stretches stretches(plan.questions, file.units_each);
    const Kernel& kernel = *plan.answerers.kernels.front();
    Judged judged{options,
                  plan,
                  stretches,
                  {},
                  file.json["plan"],
                  subjects_of(kernel),
                  kind_of_kernel(kernel),
                  options.effort,
                  file.digest,
                  file.options.is_slow};
    read_journal(journal, file.digest, [&](std::string_view content) {
      if (const auto entry = finished_in(content))
        judged.tallies[entry->stretch] = stretch_json(plan.answerers.kernels, stretches, *entry);
    });
    if (judged.tallies.size() != stretches.count())
      return unfinished_in(options, judged.tallies.size(), stretches.count());
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
  plan.running.threads = threads_of(options.threads);
  for (const std::string& target : targets_of(plan.answerers.kernels, plan.running.target))
    require_uncontracted(target);
  const Stretches stretches(plan.questions, Stretches::default_units_each(plan.questions));
  Gathered gathered(plan.questions, plan.answerers.kernels.size(), stretches);
  Judged judged{options,       plan,      stretches, {}, json_of(plan_record(plan)),
                Json::array(), "replies", "replies", "", true};
  for (const std::string& path : options.replies.replies) judged.subjects.push_back(file_subject(path, "replies"));
  judged.digest = digest_of_json(judged.subjects);
  const OutputFolder folder(run_folder_of(options));
  const auto started = std::chrono::system_clock::now();
  const std::atomic<bool>& interrupted = watch_for_interrupts();
  try {
    ProgressLine progress("certify: the replies are judged", options.quiet);
    run_stretches(plan, stretches, gathered.missing(), interrupted, progress.report(), [&](const Entry& entry) {
      judged.tallies[entry.stretch] = stretch_json(plan.answerers.kernels, stretches, entry);
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
  put_result({folder, std::nullopt, run_files(plan, std::move(gathered).take(), output, plan.running.target, started)},
             output);
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

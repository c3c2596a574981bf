#include "cli/commands/certify.h"

#include <fmt/format.h>

#include <filesystem>
#include <map>

#include "cli/commands.h"
#include "cli/ending.h"
#include "cli/progress_line.h"
#include "cli/commands/judged_run.h"
#include "cli/commands/planned_run.h"
#include "fuzz/campaign/gathered.h"
#include "fuzz/campaign/journal.h"
#include "fuzz/text/json_form.h"
#include "kernel/base/error.h"
#include "kernel/base/version.h"
#include "kernel/registry/self_check.h"
#include "reports/certificate/statement.h"
#include "reports/certificate/materials.h"
#include "reports/certificate/derived.h"
#include "reports/certificate/margin.h"
#include "reports/certificate/page.h"
#include "reports/certificate/breaks.h"
#include "reports/certificate/levels.h"
#include "reports/certificate/canonical.h"
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
struct CertificateMaterial {
  const CertifyOptions& options;
  const Plan& plan;  // of which the kernel is the first
  const Stretches& stretches;
  std::map<std::uint64_t, TallyMaterial> tallies;  // by stretch
  Json plan_json;
  std::vector<SubjectStatement> subjects;
  KernelKind kind;
  std::string effort, digest;  // the plan's digest
  bool is_slow;

  const Kernel& kernel() const { return *plan.answerers.kernels.front(); }
};

MaterialsStatement materials_of(const CertificateMaterial& judged, const Record& record) {
  const Json portable = portable_plan(judged.plan_json);
  MaterialsStatement materials{{axiscert_version, source_digests().sources},
                               source_digests().proofs,
                               {digest_of_json(portable), {judged.stretches.units_each()}, {portable}},
                               kernels_of_record(record),
                               findings_of_record(record),
                               {}};
  for (const auto& [stretch, tally] : judged.tallies) materials.tallies.push_back(tally);
  return materials;
}

// A kernel that answers the same queries otherwise has no safe margin, since what it missed it may find next time.
void drop_margin_beside(const Record& record, CertificatePredicate& predicate) {
  SafeMarginStatement& margins = predicate.safe_margin;
  for (const MarginStatement& margin : margins.precisions) {
    for (const KernelRecord& entry : record.kernels) {
      if (entry.id != predicate.kernel.id || margin.precision != entry.precision) continue;
      const std::string fault = margin_fault(margin, entry);
      if (fault.empty()) continue;
      margins = {fmt::format("{}in {}, {}", margin_answered_otherwise, name(entry.precision), fault), {}};
      return;
    }
  }
}

// Makes what follows from the counts, of them alone, as `verify` does. Throws HarnessFault where the run's record says
// otherwise.
void put_derived(const Record& record, const Record& run_record, CertificatePredicate& predicate) {
  predicate = derived_predicate(std::move(predicate), record);
  const std::string& id = predicate.kernel.id;
  predicate.breaks_first = what_breaks_first(run_record, id);
  const std::vector<LevelStatement> levels =
      levels_of(run_record, id, predicate.search.precisions, predicate.diagnosis.precisions);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const LevelState by_record = levels[i].state, by_counts = predicate.levels[i].state;
    if (by_record == by_counts) continue;
    throw HarnessFault(fmt::format("\"{}\" of {} is \"{}\" by the record, and \"{}\" by its counts", levels[i].level,
                                   id, name(by_record), name(by_counts)));
  }
}

// A part in the order in which `verify` reads it.
template <class Part>
Part in_canonical_order(const Part& part) {
  return read_as<Part>(Json::parse(canonical_json(json_of(part))));
}

// The second half, by rank 0, once the run's folder is written.
int write_certificate(const CertificateMaterial& judged, const std::optional<SigningKey>& key) {
  const CertifyOptions& options = judged.options;
  const Kernel& kernel = judged.kernel();
  const OutputFolder folder(options.out);
  const Run run = read_run(fs::path(options.out) / "run");
  const EffortSize size = size_of(parse_effort(options.effort), *kernel.predicate, judged.is_slow);
  const StagedCertificate staged{options, kernel, judged.plan.questions, judged.plan.running, run.record, size};
  Stages stages(folder, options.out, judged.digest, options.resume);

  CertificateStatement statement;
  statement.subject = judged.subjects;
  CertificatePredicate& predicate = statement.predicate;
  predicate.kernel.id = kernel.id;
  predicate.kernel.kind = judged.kind;
  predicate.kernel.question = kernel.predicate->id;
  predicate.kernel.entry = kernel.predicate->entries[kernel.entry].name;
  predicate.asked.effort = judged.effort;
  predicate.materials = in_canonical_order(materials_of(judged, run.record));
  predicate.search = run_search_stage(staged, stages);
  predicate.safe_margin = run_margin_stage(staged, stages, predicate.search);
  predicate.search = in_canonical_order(predicate.search);
  predicate.safe_margin = in_canonical_order(predicate.safe_margin);
  predicate.diagnosis = run_diagnosis_stage(staged, stages);
  predicate.harness = in_canonical_order(run_harness_stage(staged, stages));
  predicate.witnesses = in_canonical_order(worst_of_certificate(run.record, kernel.id));
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
    predicate.signed_at = iso_time(std::chrono::system_clock::now());
    predicate.signed_by = key->id();
  }
  predicate.digest = digest_without_itself(json_of(statement));
  const InstrumentReport report = certificate_report(statement, command_of(options), &run.record);
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
int print_unfinished(const CertifyOptions& options, std::uint64_t done, std::uint64_t stretches) {
  fmt::print(
      stderr,
      "axiscert: {} of the plan's {} stretches are done, and a certificate has all of them: none is written in {}\n",
      done, stretches, options.out);
  print_how_to_go_on();
  return exit_requirement_failed;
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
    if (interrupted) return interrupted_code();
    if (code == exit_harness_fault || code == exit_bad_input) return code;
    const Plan plan = plan_of(file);
    const Stretches stretches(plan.questions, file.units_each);
    const Kernel& kernel = *plan.answerers.kernels.front();
    CertificateMaterial judged{options,
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
        judged.tallies[entry->stretch] = tally_of_stretch(plan.answerers.kernels, stretches, *entry);
    });
    if (judged.tallies.size() != stretches.count())
      return print_unfinished(options, judged.tallies.size(), stretches.count());
    keep_work(fmt::format("the run, and what is done of the stages, are in {}", options.out), own_command("--resume"));
    try {
      return write_certificate(judged, key);
    } catch (const StageInterrupted&) {
      return interrupted_code();
    }
  };
  return run_planned(planned, run);
}

// Replies are judged as they are: nothing can be asked again.
int certify_replies(const CertifyOptions& options, const std::optional<SigningKey>& key) {
  ReplyPlan replies = reply_plan(options.replies);
  Plan& plan = replies.plan;
  plan.running.threads = threads_of(options.threads);
  for (const std::string& target : targets_of(plan.answerers.kernels, plan.running.target))
    require_uncontracted(target);
  const Stretches stretches(plan.questions, Stretches::default_units_each(plan.questions));
  GatheredStretches gathered(plan.questions, plan.answerers.kernels.size(), stretches);
  CertificateMaterial judged{options,   plan, stretches, {}, json_of(plan_record(plan)), {}, KernelKind::replies,
                             "replies", "",   true};
  for (const std::string& path : options.replies.replies) judged.subjects.push_back(file_subject(path, "replies"));
  judged.digest = digest_of_json(json_of(judged.subjects));
  const OutputFolder folder(run_folder_of(options));
  const auto started = std::chrono::system_clock::now();
  const std::atomic<bool>& interrupted = watch_for_interrupts();
  try {
    ProgressLine progress("certify: the replies are judged", options.quiet);
    run_stretches(plan, stretches, gathered.missing(), interrupted, progress.report(), [&](const Entry& entry) {
      judged.tallies[entry.stretch] = tally_of_stretch(plan.answerers.kernels, stretches, entry);
      gathered.add(entry);
    });
  } catch (const OracleDisagreement& disagreement) {
    throw save_disagreement(folder, disagreement);
  }
  if (interrupted) return interrupted_code();
  OutputOptions output;
  output.out = run_folder_of(options);
  output.quiet = options.quiet;
  output.has_summary = false;
  put_result(
      {folder, std::nullopt, shown_run_files(plan, std::move(gathered).take(), output, plan.running.target, started)},
      output);
  try {
    return write_certificate(judged, key);
  } catch (const StageInterrupted&) {
    return interrupted_code();
  }
}

}  // namespace

int certify(const CertifyOptions& options) {
  std::optional<SigningKey> key;
  if (!options.key.empty()) key = SigningKey::private_from(options.key);  // refused before anything runs
  return options.is_of_replies ? certify_replies(options, key) : certify_kernel(options, key);
}

}  // namespace axiscert

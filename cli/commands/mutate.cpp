#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "cli/commands/mutation_gate.h"
#include "cli/commands/run_output.h"
#include "cli/ending.h"
#include "cli/help.h"
#include "cli/instrument_options.h"
#include "cli/progress_line.h"
#include "cli/run_options.h"
#include "cli/shared_options.h"
#include "cli/usage.h"
#include "exact/judge/oracles.h"
#include "fuzz/queries/family.h"
#include "fuzz/queries/source.h"
#include "fuzz/text/json_form.h"
#include "kernel/base/error.h"
#include "kernel/registry/self_check.h"
#include "plans/predicate_options.h"
#include "proofs/certified/mutants.h"
#include "reports/instrument/black_box_report.h"
#include "reports/instrument/mutation_report.h"

namespace axiscert {
namespace {

struct MutateOptions {
  std::string predicate, kernel, precision, format = "text", out;
  std::vector<std::string> mutants, families;
  std::vector<double> magnitudes;
  std::optional<std::uint64_t> trials;
  std::uint64_t seed = 1;
  int threads = 0;
  bool list = false, no_controls = false, verdict_only = false;
};

// A mutant that shows its verdict alone is judged as a run does, at many times the cost.
constexpr std::uint64_t trials_by_formulae = std::uint64_t{1} << 16, trials_by_verdict = std::uint64_t{1} << 11;
// Without filters every query is judged by exact arithmetic, and there are more formulae and families.
constexpr std::uint64_t divisor_without_filters = 8;
std::uint64_t default_trials(const MutateOptions& options, const Predicate& predicate) {
  const std::uint64_t trials = options.verdict_only ? trials_by_verdict : trials_by_formulae;
  return has_filters(predicate) ? trials : trials / divisor_without_filters;
}

// The controls in other arithmetics are judged by exact arithmetic, at a hundred times the cost of a mutant's query.
constexpr std::uint64_t trials_of_a_control(std::uint64_t trials) { return std::max<std::uint64_t>(1, trials / 64); }

// The mutants to choose from: with --verdict-only those with a fault of a value too.
std::vector<const mutants::Mutant*> mutants_there(const MutateOptions& options) {
  std::vector<const mutants::Mutant*> all;
  for (const mutants::Mutant& m : mutants::mutants_of(options.kernel)) all.push_back(&m);
  if (!options.verdict_only) return all;
  std::vector<double> magnitudes = options.magnitudes;
  if (magnitudes.empty()) magnitudes.assign(mutants::default_magnitudes.begin(), mutants::default_magnitudes.end());
  for (const mutants::Mutant* m : mutants::value_mutants_of(options.kernel, magnitudes)) all.push_back(m);
  return all;
}

// Mutants by id, or by fault: "swap".
std::vector<const mutants::Mutant*> mutants_asked(const MutateOptions& options) {
  const std::vector<const mutants::Mutant*> all = mutants_there(options);
  if (options.mutants.empty()) return all;
  std::vector<const mutants::Mutant*> asked;
  for (const std::string& given : options.mutants) {
    const std::size_t before = asked.size();
    for (const mutants::Mutant* m : all) {
      if (m->id == given || m->fault == given) asked.push_back(m);
    }
    if (asked.size() > before) continue;
    const std::string id = given.find('~') == given.npos ? options.kernel + "~" + given : given;
    asked.push_back(&mutants::find_mutant(id));  // throws an error that lists what exists
    if (!id.starts_with(options.kernel + "~"))
      throw Error(fmt::format("--mutant {}: not a mutant of {}", given, options.kernel));
  }
  return asked;
}

int print_mutants(const MutationPlan& plan) {
  for (const mutants::Mutant* m : plan.mutants) fmt::print("{}  {}; {}\n", m->id, m->where, m->what);
  return exit_done;
}

std::string command_of(const MutateOptions& options, const MutationPlan& plan) {
  std::string command = fmt::format("axiscert mutate --kernel {}", options.kernel);
  if (options.verdict_only) command += " --verdict-only";
  for (const std::string& mutant : options.mutants) command += " --mutant " + mutant;
  for (const double magnitude : options.magnitudes) command += fmt::format(" --magnitude {}", magnitude);
  for (const std::string& family : options.families) command += " --family " + family;
  command += fmt::format(" --trials {} --seed {}", plan.trials, plan.seed);
  if (!options.precision.empty()) command += " --precision " + options.precision;
  if (options.no_controls) command += " --no-controls";
  return command;
}

// Prints and writes the report, and throws where the harness contradicts itself.
int print_and_write_score(const MutateOptions& options, const std::optional<OutputFolder>& folder,
                          const InstrumentReport& shown, const InstrumentReport& whole, bool complete,
                          const std::vector<std::string>& faults) {
  fmt::print("{}", options.format == "text" ? instrument_text(shown) : data_text(shown.data, options.format));
  if (folder) {
    folder->write(whole.name + ".json", whole.data);
    folder->write_text(whole.name + ".csv", data_text(whole.data, "csv"));
    folder->write_text(whole.name + ".md", instrument_markdown(whole));
    folder->write_text(whole.name + ".html", instrument_page(whole));
  }
  if (!complete) return interrupted_code();
  if (!faults.empty()) throw HarnessFault(fmt::format("{}", fmt::join(faults, "\n")));
  return shown.is_of_nothing ? exit_requirement_failed : exit_done;
}

int mutate_by_verdict(const MutateOptions& options, const MutationPlan& plan,
                      const std::optional<OutputFolder>& folder) {
  const std::atomic<bool>& interrupted = watch_for_interrupts();
  const BlackBoxScore score = with_progress(
      "mutate", [&](const ShowProgress& show) { return judge_black_boxes(plan, mutation_gate, interrupted, show); });
  const InstrumentReport report = black_box_report(plan, score, level_of_mutation, command_of(options, plan));
  return print_and_write_score(options, folder, report, report, score.complete, black_box_faults(score));
}

// The kernel that the mutants are made of: the one given, or the first of the predicate.
std::string base_asked(const MutateOptions& options) {
  if (options.kernel.empty()) return std::string(mutants::base_for(predicate_given(options.predicate)));
  mutants::base_index(options.kernel);  // throws an error that lists what exists
  predicate_of_kernels(options.predicate, {&find_kernel(options.kernel)});
  return options.kernel;
}

// The certified predicate has steps in place of comparisons, and no wrong verdict shows a fault of one that a later
// step puts right: its mutants are those of the recorded steps, asked step by step.
constexpr const char* certified_kernel = "certified";
constexpr std::uint64_t queries_of_a_step = 12000;

std::vector<proofs::certified::RecordedStep> steps_asked(const MutateOptions& options) {
  std::vector<proofs::certified::RecordedStep> steps;
  for (proofs::certified::RecordedStep& step : proofs::certified::recorded_steps()) {
    const bool is_asked = options.precision.empty() || options.precision == fmt::format("binary{}", step.bits);
    if (!step.fused && is_asked) steps.push_back(std::move(step));
  }
  return steps;
}

int mutate_certified(const MutateOptions& options) {
  using namespace proofs::certified;
  if (!options.mutants.empty() || !options.families.empty() || options.verdict_only || !options.predicate.empty()) {
    throw Error(
        "mutate --kernel certified plants each fault in each step of the certified predicate; it takes "
        "--precision, --trials, --seed, --list, --format and --out");
  }
  const std::vector<RecordedStep> steps = steps_asked(options);
  if (options.list) {
    for (const RecordedStep& step : steps) {
      for (const Mutant& m : mutants_of(step)) fmt::print("{}, binary{}: {}\n", step.name, step.bits, m.name);
    }
    return exit_done;
  }
  const std::uint64_t queries = options.trials.value_or(queries_of_a_step);
  std::optional<OutputFolder> folder;
  if (!options.out.empty()) folder.emplace(options.out);
  InstrumentReport report{.name = "mutation-of-certified",
                          .title = "Faults of the certified predicate",
                          .command = {},
                          .notes = {},
                          .tables = {},
                          .plots = {},
                          .data = {}};
  report.command = fmt::format("axiscert mutate --kernel certified --trials {} --seed {}", queries, options.seed);
  if (!options.precision.empty()) report.command += " --precision " + options.precision;
  report.notes = {
      "In each recorded step (proofs/certified) each constant is halved and doubled, the operands of each operation "
      "that "
      "depends on their order exchanged, and each of two conditions dropped. Shown: an answer of the step differs on "
      "one "
      "of the queries, many of which are an ulp to both sides of a change of an answer. Equivalent: "
      "proofs/certified/mutants.cpp argues that no query shows it. Every fault, shown or not, changes the "
      "recording, "
      "which the test proofs.Current compares with the committed one."};
  InstrumentTable table{.caption = "Score", .columns = {}, .rows = {}};
  table.columns = {"step", "precision", "mutants", "shown", "equivalent", "by the recording alone"};
  InstrumentTable unseen{.caption = "By the recording alone", .columns = {}, .rows = {}};
  unseen.columns = {"step", "precision", "fault"};
  MutationOfCertifiedData data;
  data.command = report.command;
  data.queries = queries;
  data.seed = {options.seed};
  std::vector<std::string> faults;
  {
    ProgressLine progress("mutate");
    for (const RecordedStep& step : steps) {
      progress.begin_stage(step.name);
      const StepScore score = score_of(step, queries, options.seed);
      const std::string precision = fmt::format("binary{}", score.bits);
      const std::size_t shown = score.mutants - score.equivalent.size() - score.unseen.size();
      table.rows.push_back({score.step, precision, fmt::format("{}", score.mutants), fmt::format("{}", shown),
                            fmt::format("{}", score.equivalent.size()), fmt::format("{}", score.unseen.size())});
      for (const std::string& fault : score.unseen) unseen.rows.push_back({score.step, precision, fault});
      data.steps.push_back({score.step,
                            precision,
                            score.mutants,
                            shown,
                            {score.equivalent.begin(), score.equivalent.end()},
                            {score.unseen.begin(), score.unseen.end()}});
      for (const std::string& what : score.contradictions) {
        faults.push_back(fmt::format("{}, {}: {}", score.step, precision, what));
      }
    }
  }
  report.tables = {table, unseen};
  report.data = json_of(data);
  return print_and_write_score(options, folder, report, report, true, faults);
}

int mutate(const MutateOptions& given) {
  if (given.kernel == certified_kernel) return mutate_certified(given);
  MutateOptions options = given;
  options.kernel = base_asked(given);
  MutationPlan plan;
  plan.mutants = mutants_asked(options);
  plan.base = options.kernel;
  if (options.list) return print_mutants(plan);
  const Kernel& base = find_kernel(plan.base);
  plan.families = families_named(options.families, *base.predicate, base.entry);
  for (const Family* family : plan.families) require_one_predicate({&base}, {family_source(*family)});
  if (plan.families.empty()) plan.families = families_of(*base.predicate, base.entry);
  if (options.precision.empty()) plan.precisions = {Precision::binary32, Precision::binary64};
  else plan.precisions = {parse_precision(options.precision)};
  plan.trials = options.trials.value_or(default_trials(options, *base.predicate));
  plan.seed = options.seed;
  plan.threads = threads_of(options.threads);
  plan.controls = !options.no_controls;
  std::optional<OutputFolder> folder;
  if (!options.out.empty()) folder.emplace(options.out);
  require_uncontracted(scalar_target);

  if (options.verdict_only) return mutate_by_verdict(options, plan, folder);

  const std::atomic<bool>& interrupted = watch_for_interrupts();
  MutationResult result;
  std::vector<Control> controls;
  {
    ProgressLine progress("mutate");
    result = run_mutation(plan, interrupted, progress.report());
    if (!options.no_controls && result.complete) {
      progress.begin_stage("kernels that are right");
      controls = run_controls(plan, trials_of_a_control(plan.trials), interrupted, progress.report());
      result.complete = !interrupted;
    }
  }
  const std::string command = command_of(options, plan);
  const std::vector<std::string> faults = mutation_faults(result, controls);
  return print_and_write_score(options, folder, mutation_report(plan, result, controls, command, false),
                               mutation_report(plan, result, controls, command, true), result.complete, faults);
}

}  // namespace

void add_mutate(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand(
      "mutate", "Plant one fault after the other in a correct kernel, and show which are caught, and how soon");
  auto options = std::make_shared<MutateOptions>();
  MutateOptions& o = *options;
  add_predicate(*command, o.predicate,
                "predicate whose first such kernel the mutants are made from (axiscert predicates)");
  add_kernel(*command, o.kernel,
             fmt::format("kernel that the mutants are made from: {}; or {}, each of whose steps is judged by itself",
                         fmt::join(mutants::bases, ", "), certified_kernel),
             "the first of the predicate");
  command->add_option("--mutant", o.mutants, "id or fault, repeatable (default: all)")->allow_extra_args(false);
  add_families(*command, o.families, "all");
  add_trials(*command, o.trials,
             fmt::format("{}, with --verdict-only {}; of a predicate other than {} an eighth", trials_by_formulae,
                         trials_by_verdict, ids_of(predicates_with(has_filters))));
  add_seed(*command, o.seed);
  add_precision(*command, o.precision, "", "both");
  auto* verdict_only = command->add_flag(
      "--verdict-only", o.verdict_only,
      "judge each mutant by its verdict alone, as a plug-in that shows nothing else, and plant epsilons, clamps, "
      "thresholds and early answers too; what survives is listed with its reason");
  command
      ->add_option(
          "--magnitude", o.magnitudes,
          fmt::format("magnitude of these, repeatable (default: {})", fmt::join(mutants::default_magnitudes, ", ")))
      ->allow_extra_args(false)
      ->check(number_above_zero())
      ->needs(verdict_only);
  command->add_flag("--list", o.list, "list the mutants and run no queries");
  command->add_flag("--no-controls", o.no_controls, "leave out the controls, which are correct kernels");
  add_thread_option(*command, o.threads);
  add_progress(*command);
  add_format(*command, o.format, data_formats);
  add_out(*command, o.out, "mutation.json, .csv, .md and .html (with --verdict-only mutation-by-verdict.*)");
  add_examples(*command,
               {{"Which faults are there?", "axiscert mutate --list"},
                {"Which does a family catch?", "axiscert mutate nonstrict --family lattice --trials 64 --no-controls"},
                {"Which by the verdict alone?", "axiscert mutate nonstrict --verdict-only --out mutation"}});
  command->callback([&action, options] { action = [options] { return mutate(*options); }; });
}

}  // namespace axiscert

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "cli/options/instrument_options.h"
#include "cli/options/run_options.h"
#include "cli/options/test_options.h"
#include "cli/values.h"
#include "cli/running/run_output.h"
#include "fuzz/queries/address.h"
#include "kernel/base/error.h"
#include "kernel/registry/self_check.h"
#include "reports/instrument/mutation_report.h"

namespace axiscert {
namespace {

struct MutateOptions {
  std::string kernel = std::string(mutants::bases.front()), precision, format = "text", out;
  std::vector<std::string> mutants, families;
  std::uint64_t trials = 0, seed = 1;
  int threads = 0;
  bool list = false, no_controls = false;
};

// The controls in other arithmetics are judged by exact arithmetic, at a hundred times the cost of a mutant's query.
constexpr std::uint64_t trials_of_a_control(std::uint64_t trials) { return std::max<std::uint64_t>(1, trials / 64); }

// Mutants by id, or by fault: "swap".
std::vector<const mutants::Mutant*> mutants_asked(const MutateOptions& options) {
  std::vector<const mutants::Mutant*> asked;
  const std::span<const mutants::Mutant> all = mutants::mutants_of(options.kernel);
  if (options.mutants.empty()) {
    for (const mutants::Mutant& m : all) asked.push_back(&m);
  }
  for (const std::string& given : options.mutants) {
    const std::size_t before = asked.size();
    for (const mutants::Mutant& m : all) {
      if (m.id == given || m.fault == given) asked.push_back(&m);
    }
    if (asked.size() > before) continue;
    const std::string id = given.find('~') == given.npos ? options.kernel + "~" + given : given;
    asked.push_back(&mutants::find_mutant(id));  // throws an error that lists what exists
    if (!id.starts_with(options.kernel + "~"))
      throw Error(fmt::format("--mutant {}: not a mutant of {}", given, options.kernel));
  }
  return asked;
}

int show_list(const MutationPlan& plan) {
  for (const mutants::Mutant* m : plan.mutants) fmt::print("{}  {}; {}\n", m->id, m->where, m->what);
  return exit_done;
}

int mutate(const MutateOptions& options) {
  MutationPlan plan;
  for (const Kernel& kernel : kernels()) {
    if (kernel.id == options.kernel) require_served("mutate", *kernel.test);
  }
  plan.mutants = mutants_asked(options);
  plan.base = options.kernel;
  if (options.list) return show_list(plan);
  for (const std::string& name : options.families) {
    plan.families.push_back(&find_family(name));
    require_served("mutate", plan.families.back()->test());
  }
  if (plan.families.empty()) plan.families = families_of(first_test());
  if (options.precision.empty()) plan.precisions = {Precision::binary32, Precision::binary64};
  else plan.precisions = {parse_precision(options.precision)};
  plan.trials = options.trials;
  plan.seed = options.seed;
  plan.threads = threads_of(options.threads);
  std::optional<OutputFolder> folder;
  if (!options.out.empty()) folder.emplace(options.out);
  require_uncontracted(scalar_target);

  const std::atomic<bool>& interrupted = watch_for_interrupts();
  MutationResult result;
  std::vector<Control> controls;
  {
    ProgressLine progress;
    result = run_mutation(plan, interrupted, [&](const Progress& p) { progress.show(p); });
  }
  if (!options.no_controls && result.complete) {
    controls = run_controls(plan, trials_of_a_control(plan.trials), interrupted);
    result.complete = !interrupted;
  }
  std::string command = fmt::format("axiscert mutate --kernel {}", options.kernel);
  for (const std::string& mutant : options.mutants) command += " --mutant " + mutant;
  for (const std::string& family : options.families) command += " --family " + family;
  command += fmt::format(" --trials {} --seed {}", plan.trials, plan.seed);
  if (!options.precision.empty()) command += " --precision " + options.precision;
  if (options.no_controls) command += " --no-controls";

  const InstrumentReport report = mutation_report(plan, result, controls, command, false);
  fmt::print("{}", options.format == "json" ? report.data.dump(2) + "\n" : instrument_text(report));
  if (folder) {
    const InstrumentReport whole = mutation_report(plan, result, controls, command, true);
    folder->write("mutation.json", whole.data);
    folder->write_text("mutation.md", instrument_markdown(whole));
    folder->write_text("mutation.html", instrument_page(whole));
  }
  if (!result.complete) return exit_interrupted;
  const std::vector<std::string> faults = mutation_faults(result, controls);
  if (!faults.empty()) throw HarnessFault(fmt::format("{}", fmt::join(faults, "\n")));
  return exit_done;
}

}  // namespace

void add_mutate(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand(
      "mutate", "Plant one fault after the other in a correct kernel, and show which are caught, and how soon");
  auto options = std::make_shared<MutateOptions>();
  MutateOptions& o = *options;
  o.trials = std::uint64_t{1} << 16;
  command
      ->add_option("--kernel", o.kernel,
                   fmt::format("kernel that the mutants are made from: {}", fmt::join(mutants::bases, ", ")))
      ->capture_default_str();
  command->add_option("--mutant", o.mutants, "id or fault, repeatable (default: all)")->allow_extra_args(false);
  command->add_option("--family", o.families, "family, repeatable (default: all)")->allow_extra_args(false);
  command->add_option("--trials", o.trials, "queries per family and precision")
      ->check(whole_number(1, std::uint64_t{1} << 48))
      ->capture_default_str();
  command->add_option("--seed", o.seed, "seed of every family")->check(whole_number())->capture_default_str();
  command->add_option("--precision", o.precision, "binary32 or binary64")->default_str("both");
  command->add_flag("--list", o.list, "list the mutants and run no queries");
  command->add_flag("--no-controls", o.no_controls, "leave out the controls, which are correct kernels");
  add_thread_option(*command, o.threads);
  add_format(*command, o.format, "json");
  command->add_option("--out", o.out, "folder for mutation.json, mutation.md and mutation.html");
  command->callback([&action, options] { action = [options] { return mutate(*options); }; });
}

}  // namespace axiscert

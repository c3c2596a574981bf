#include <fmt/format.h>

#include <algorithm>
#include <atomic>

#include "cli/commands/run_output.h"
#include "cli/help.h"
#include "cli/instrument_options.h"
#include "cli/progress_line.h"
#include "cli/run_options.h"
#include "fuzz/confirm/cause.h"
#include "fuzz/confirm/record.h"
#include "fuzz/queries/source.h"
#include "fuzz/sphere_triangle/formulae/kernel_speed.h"
#include "kernel/base/error.h"
#include "kernel/plugin/load.h"
#include "kernel/registry/self_check.h"
#include "plans/notices.h"
#include "plans/predicate_options.h"
#include "reports/instrument/league_contacts.h"
#include "reports/instrument/league_report.h"

namespace axiscert {
namespace {

struct LeagueOptions : InstrumentOptions {
  bool no_speed = false, no_engines = false, contacts = false;
};

const std::vector<std::string> own_kernels = {"published",     "nonstrict", "reduced-nonstrict", "minkowski",
                                              "closest-point", "certified", "conservative"};
const std::vector<std::string> league_families = {"general", "tangent",   "tie",      "lattice", "sliver",
                                                  "needle",  "collinear", "repeated", "on",      "grid",
                                                  "scale",   "far",       "subnormal"};
constexpr int repetitions = 5;

// That of our own kernels.
const Predicate& league_predicate() { return *find_kernel(own_kernels.front()).predicate; }

// Those above, and every family of scenes.
std::vector<std::string> default_families() {
  std::vector<std::string> names = league_families;
  for (const Family* family : families_of(league_predicate())) {
    if (family->trust_group == TrustGroup::scene) names.emplace_back(family->name);
  }
  return names;
}

void add_to_league(League& league, const std::string& id) {
  const Kernel& kernel = find_kernel(id);
  require_served("league", *kernel.predicate, {&league_predicate()});
  if (std::find(league.kernels.begin(), league.kernels.end(), &kernel) != league.kernels.end()) return;
  league.kernels.push_back(&kernel);
}

// Our own kernels and every peer, those from npm only with `engines`; every kernel with a planted fault is kept apart
// from them, and left out of `contacts`.
void add_all_kernels(League& league, bool engines, bool contacts) {
  for (const std::string& id : own_kernels) add_to_league(league, id);
  for (const plugin::ShippedPlugins& shipped : plugin::shipped_plugins()) {
    if (shipped.predicate != &league_predicate()) continue;
    const bool competes = shipped.prefix == "peer/";
    // A planted fault is one of verdicts.
    if (!competes && contacts) continue;
    for (const std::string& name : shipped.names) {
      const std::string id = shipped.prefix + name;
      if (engines || !plugin::is_program(find_kernel(id))) add_to_league(league, id);
    }
    if (competes) league.contenders = league.kernels.size();
    if (shipped.names.empty()) {
      league.not_checked.push_back(
          fmt::format("NOT CHECKED: {}*: this axiscert was built without them.", shipped.prefix));
    }
    for (const auto& absent : shipped.absent) {
      if (!absent.command.empty()) {
        if (!engines) continue;
        league.not_checked.push_back(fmt::format("NOT CHECKED: {}{}: {} is not installed; `{}` installs it.",
                                                 shipped.prefix, absent.name, absent.package, absent.command));
        continue;
      }
      league.not_checked.push_back(
          fmt::format("NOT CHECKED: {}{}: it was not built, because the Debian package {} is missing.", shipped.prefix,
                      absent.name, absent.package));
    }
  }
}

template <class Real>
void take_times(League& league, const ShowProgress& report) {
  std::vector<const Kernel*> timed;
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < league.contenders; ++k) {
    // The time of a program would be that of the pipe.
    if (!league.kernels[k]->has(precision_of<Real>) || plugin::is_program(*league.kernels[k])) continue;
    timed.push_back(league.kernels[k]);
    places.push_back(k);
  }
  const auto speeds = measure_speed<Real>(timed, repetitions, report);
  for (std::size_t i = 0; i < timed.size(); ++i) {
    const auto& best = speeds[i].best_target;
    league.nanoseconds[{precision_of<Real>, places[i]}] = best ? best->second : speeds[i].scalar_ns;
  }
}

int run_league(const LeagueOptions& options) {
  League league;
  Questions& questions = league.questions;
  if (options.kernels.empty()) {
    add_all_kernels(league, !options.no_engines, options.contacts);
  } else {
    for (const std::string& id : options.kernels) add_to_league(league, id);
    league.contenders = league.kernels.size();
  }
  begin_instrument(options);
  questions.sources = instrument_sources(options, default_families());
  if (options.precision.empty()) questions.precisions = {Precision::binary32, Precision::binary64};
  else questions.precisions = {parse_precision(options.precision)};
  // An empty table would say nothing of a kernel that was asked for.
  for (std::size_t k = 0; !options.kernels.empty() && k < league.contenders; ++k) {
    const Kernel& kernel = *league.kernels[k];
    require_loaded(kernel);
    if (std::ranges::none_of(questions.precisions, [&](Precision precision) { return kernel.has(precision); })) {
      throw Error(fmt::format("--precision {}: kernel {} does not exist in it",
                              options.precision.empty() ? "both" : options.precision, kernel.id));
    }
  }
  print_first_look(league.kernels);
  questions.seed = options.seed;
  questions.trials = [&](const Source&, Precision) { return options.trials; };
  Plan plan;
  plan.questions = questions;
  plan.answerers.kernels = league.kernels;
  plan.running = {resolve_target("auto"), threads_of(options.threads)};
  for (const std::string& target : targets_of(league.kernels, plan.running.target)) require_uncontracted(target);

  const std::atomic<bool> interrupted = false;
  const CampaignResult result = with_progress("league", [&](const ShowProgress& show) {
    CampaignResult found = run_campaign(plan, interrupted, show);
    if (options.contacts) return found;
    for (const Precision precision : questions.precisions) {
      for (std::size_t k = 0; k < league.contenders; ++k) {
        if (!league.kernels[k]->has(precision)) continue;
        if (auto cause = cause_in_run(plan, found, k, precision)) league.causes[{precision, k}] = *std::move(cause);
      }
    }
    if (options.no_speed) return found;
    for (const Precision precision : questions.precisions) {
      if (precision == Precision::binary32) take_times<float>(league, show);
      else take_times<double>(league, show);
    }
    return found;
  });
  const std::string command = instrument_command("league", options) + (options.no_speed ? " --no-speed" : "") +
                              (options.no_engines ? " --no-engines" : "") + (options.contacts ? " --contacts" : "");
  for (const std::string& sentence : league.not_checked) fmt::print(stderr, "axiscert: {}\n", sentence);
  const int done = print_and_write_instrument(
      options.contacts ? league_contacts_report(league, result, command) : league_report(league, result, command),
      options);
  return undecided_contenders(league, result).empty() ? done : exit_requirement_failed;
}

}  // namespace

void add_league(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand("league",
                                     "Run production libraries, engines and axiscert's kernels on the same queries: "
                                     "may each be trusted, what is its worst, and how soon are planted faults caught");
  auto options = std::make_shared<LeagueOptions>();
  options->precision.clear();
  add_instrument_options(*command, *options, std::uint64_t{1} << 14);
  command->add_flag("--no-speed", options->no_speed, "measure no times");
  command->add_flag("--no-engines", options->no_engines, "leave out the engines from npm, installed or not");
  command->add_flag("--contacts", options->contacts,
                    "say what each gives beside its verdicts, and how far separations, normals and points are off; no "
                    "times, no causes");
  options->asks_less = "--no-speed and --no-engines leave out the times and the engines";
  add_examples(
      *command,
      {{"My kernel beside others", "axiscert league plugin:./my_kernel.so published --trials 256 --no-speed"},
       {"Every library that is here, with a page", "axiscert league --out league"},
       {"What they say beside their verdicts", "axiscert league --contacts --trials 1024 --precision binary32"}});
  command->callback([&action, options] { action = [options] { return run_league(*options); }; });
}

}  // namespace axiscert

#include "plans/run_plan.h"

#include <fmt/format.h>
#include <sched.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <thread>

#include "exact/judge/oracles.h"
#include "fuzz/files/corpus.h"
#include "fuzz/files/mesh.h"
#include "fuzz/files/query_file.h"
#include "fuzz/instruments/effort.h"
#include "fuzz/queries/family.h"
#include "fuzz/queries/source.h"
#include "fuzz/text/file_bytes.h"
#include "kernel/base/error.h"
#include "kernel/base/sha256.h"
#include "kernel/plugin/load.h"
#include "plans/notices.h"
#include "plans/predicate_options.h"
#include "reports/gates/requirement.h"

namespace axiscert {
namespace {

// The binary logarithms of the queries per family: fewer in binary64, where exact arithmetic costs more, and fewest
// where no filter decides before it, at a hundred times the cost.
constexpr int trials_of_binary32 = 18, trials_of_binary64 = 16, trials_without_filters = 12;

// Fewer in binary64 where a family says so.
std::uint64_t default_trials(const Source& source, Precision precision) {
  const bool filters = has_filters(source.predicate());
  if (precision == Precision::binary32)
    return std::uint64_t{1} << (filters ? trials_of_binary32 : trials_without_filters);
  return (std::uint64_t{1} << (filters ? trials_of_binary64 : trials_without_filters)) /
         static_cast<std::uint64_t>(source.trial_divisor());
}

// Parses "T" for all comparisons or "COMPARISON=T" for one; a later one overrides.
void add_tolerance(const std::string& given, const Predicate& predicate, JudgingOptions& judging) {
  const std::size_t equals = given.find('=');
  const std::string which = equals == given.npos ? "" : given.substr(0, equals);
  const std::string number = equals == given.npos ? given : given.substr(equals + 1);
  std::optional<Rational> value;
  try {
    value = parse_decimal(number);
  } catch (const Error& wrong) {
    throw Error(fmt::format("--tolerance {}: {}; the form is T, or COMPARISON=T as in edge_ab.radius=1000", given,
                            wrong.what()));
  }
  if (sgn(*value) < 0) throw Error(fmt::format("--tolerance {}: a tolerance is not negative", given));
  bool found = false;
  const std::vector<PredicateComparison>& comparisons = predicate.comparisons;
  for (std::size_t i = 0; i < comparisons.size(); ++i) {
    if (!which.empty() && comparisons[i].name != which) continue;
    judging.tolerances.set(i, *value);
    judging.tolerance_texts[std::string(comparisons[i].name)] = number;
    found = true;
  }
  if (found) return;
  std::vector<std::string_view> names;
  for (const PredicateComparison& c : comparisons) names.push_back(c.name);
  throw Error(fmt::format("--tolerance {}: {}", given, unknown_name("comparison", "comparisons", which, names)));
}

// Adds the record's entries for the files of a plug-in or a program that was given by its path. A plug-in that cannot
// be read has no hash: a finding reports that it could not be loaded.
void add_plugin(const Kernel& kernel, std::vector<FileInfo>& plugins) {
  if (!plugin::is_given_by_file(kernel.id) || kernel.file.empty()) return;
  for (const auto& [kind, path] : plugin::files_of(kernel)) {
    FileInfo& file = plugins.emplace_back();
    file.name = base_name(path);
    file.kind = kind;
    file.kernel = kernel.id;
    try {
      const std::string bytes = read_bytes(path);
      file.sha256 = sha256_hex(std::as_bytes(std::span(bytes)));
    } catch (const Error&) {
      if (kernel.findings.empty()) throw;
    }
  }
}

// Whether the file of a plug-in or a program is already that of one of the kernels, by another spelling of its path.
bool is_file_of(const Kernel& kernel, const std::vector<const Kernel*>& kernels) {
  if (!plugin::is_given_by_file(kernel.id)) return false;
  for (const Kernel* other : kernels) {
    std::error_code none;
    if (!plugin::is_given_by_file(other->id) || !std::filesystem::equivalent(kernel.file, other->file, none)) continue;
    notice("--kernel {}: the file of {}, which is judged once", kernel.id, other->id);
    return true;
  }
  return false;
}

std::vector<const Kernel*> kernels_of(const std::vector<std::string>& ids) {
  std::vector<const Kernel*> kernels;
  for (const std::string& id : ids) {
    const Kernel* kernel = &find_kernel(id);
    if (std::find(kernels.begin(), kernels.end(), kernel) == kernels.end() && !is_file_of(*kernel, kernels))
      kernels.push_back(kernel);
  }
  return kernels;
}

// A precision in which no kernel exists is left out of the plan; one that was requested by name is an error for each
// kernel that lacks it. A plug-in that cannot be loaded exists in none, which its findings report.
void drop_idle_precisions(Questions& questions, const std::vector<const Kernel*>& kernels, const std::string& asked) {
  for (const Kernel* kernel : kernels) {
    if (asked.empty() || is_unloadable(*kernel) || kernel->has(questions.precisions.front())) continue;
    throw Error(fmt::format("--precision {}: kernel {} exists in {} only", asked, kernel->id,
                            kernel->has(Precision::binary32) ? "binary32" : "binary64"));
  }
  std::erase_if(questions.precisions, [&](Precision precision) {
    const bool is_idle = std::ranges::none_of(kernels, [&](const Kernel* kernel) { return kernel->has(precision); });
    if (is_idle) questions.idle.push_back(precision);
    return is_idle;
  });
}

// Any kernel meets a depth beyond the greatest; a record that requires one is read all the same.
void require_depth_that_occurs(const AskedLevel& asked, const Predicate& predicate) {
  const GateLevel& level = level_of(asked);
  if (!asked.has_argument || level.allowed == nullptr) return;
  const AllowedDepths allowed = level.allowed(asked);
  if (allowed.are_lengths || !(allowed.phantom > predicate.greatest_depth)) return;
  const bool is_optional = std::string_view(level.usage).find('[') != std::string_view::npos;
  throw Error(fmt::format(
      "--require {}: D is a depth, a share of the scene from 0 to {} in a predicate of {}, as in {}=0.001{}",
      asked.text, predicate.greatest_depth, predicate.id, asked.name,
      is_optional ? fmt::format("; `{}` alone sets no limit", asked.name) : ""));
}

}  // namespace

std::string default_trials_text() {
  const std::vector<const Predicate*> filtered = predicates_with(has_filters);
  std::string text = fmt::format("2^{} in binary32, 2^{} in binary64, 2^{} of a predicate other than {}",
                                 trials_of_binary32, trials_of_binary64, trials_without_filters, ids_of(filtered));
  for (const Predicate* predicate : filtered) {
    for (const Family* family : families_of(*predicate)) {
      if (family->trial_divisor > 1)
        text += fmt::format(", {} for {}", (1 << trials_of_binary64) / family->trial_divisor, family->name);
    }
  }
  return text;
}

bool is_unloadable(const Kernel& kernel) {
  return !kernel.has(Precision::binary32) && !kernel.has(Precision::binary64);
}

namespace {

// The file's queries of this entry of the predicate. Others are left out, and said to be, where the predicate is given;
// else a file with several parts is refused. Of a file with one part that one, whatever it is of.
SourcePtr part_of_file(const std::string& path, Precision csv_precision, const SourceOptions& options,
                       const Predicate& predicate, std::size_t entry) {
  const std::vector<SourcePtr> parts = query_file_sources(path, csv_precision);
  if (parts.size() == 1) return parts.front();
  const std::string where = path == "-" ? "stdin" : path;
  const auto own = std::ranges::find_if(
      parts, [&](const SourcePtr& part) { return &part->predicate() == &predicate && part->entry() == entry; });
  if (own == parts.end() || options.predicate.empty()) {
    throw Error(
        fmt::format("{}: it has {}; `axiscert run` judges each by itself, elsewhere choose one with --predicate", where,
                    parts_text(counts_of(parts))));
  }
  if (!options.is_part)
    notice("{}: it has {}; those of {}, entry {}, are taken", where, parts_text(counts_of(parts)), predicate.id,
           predicate.entries[entry].name);
  return *own;
}

}  // namespace

std::vector<SourcePtr> sources_of(const SourceOptions& options, const Predicate& predicate, std::size_t entry,
                                  Precision csv_precision) {
  if (!options.meshes.empty()) require_served("--mesh", predicate, mesh_predicates());
  std::vector<SourcePtr> sources;
  const auto add = [&](SourcePtr source) {
    for (const SourcePtr& other : sources) {
      if (other->address_name() == source->address_name()) return;  // given twice
      if (other->name() == source->name()) {
        throw Error(fmt::format("two different files would both be '{}' in the report: rename one", source->name()));
      }
    }
    sources.push_back(std::move(source));
  };
  const bool nothing_given =
      options.families.empty() && options.meshes.empty() && options.queries.empty() && !options.corpus;
  const bool all =
      nothing_given || std::find(options.families.begin(), options.families.end(), "all") != options.families.end();
  if (all) {
    for (const Family* family : families_of(predicate, entry)) add(family_source(*family));
  }
  for (const std::string& name : options.families) {
    if (name != "all") add(family_source(find_family(name)));
  }
  for (const std::string& path : options.meshes) add(mesh_source(path, predicate));
  for (const std::string& path : options.queries) add(part_of_file(path, csv_precision, options, predicate, entry));
  if (options.corpus) add(corpus_source(*options.corpus, predicate, entry));
  return sources;
}

void print_left_out(const std::vector<SourcePtr>& sources, const std::vector<Precision>& precisions,
                    std::string_view why) {
  for (const SourcePtr& source : sources) {
    for (const Precision precision : {Precision::binary32, Precision::binary64}) {
      const bool runs = std::find(precisions.begin(), precisions.end(), precision) != precisions.end();
      const std::uint64_t left_out = runs ? 0 : source->fixed_size(precision).value_or(0);
      if (left_out == 0) continue;
      notice("{}: {} {} queries in {}", source->name(), why, left_out, name(precision));
    }
  }
}

std::uint64_t trials_of(const SourceOptions& options, const Source& source, Precision precision) {
  if (options.trials) return *options.trials;
  if (!options.effort.empty()) return trials_of(parse_effort(options.effort), source, options.is_slow);
  return default_trials(source, precision);
}

int threads_of(int given) {
  if (given != 0) return given;
  // The processors on which this process may run: an MPI binds each rank to its own.
  cpu_set_t processors;
  if (sched_getaffinity(0, sizeof processors, &processors) == 0) return CPU_COUNT(&processors);
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

void check_required(const RunRequirements& required, const Plan& plan) {
  const PlanRecord stated = plan_record(plan, CampaignResult(), required);
  const Requirements requirements = requirements_of(stated);
  for (const AskedLevel& asked : requirements.levels) require_depth_that_occurs(asked, plan.questions.predicate());
  for (const std::string& id : yardsticks_of(stated)) {
    const bool is_run = std::any_of(plan.answerers.kernels.begin(), plan.answerers.kernels.end(),
                                    [&](const Kernel* kernel) { return kernel->id == id; });
    if (is_run) continue;
    throw Error(fmt::format("--require no-worse-than={}: {}", id,
                            plan.answerers.replies
                                ? "replies are of one program; only `run` judges two kernels on the same queries"
                                : fmt::format("that kernel is not in this run; add --kernel {}", id)));
  }
}

Plan plan_of(const RunOptions& options) {
  if (options.seconds) {
    // A run that is bounded by time has other queries on every machine.
    for (const auto& [name, value] : {std::pair("--preset", options.preset), {"--ratchet", options.ratchet}}) {
      if (!value.empty())
        throw Error(
            fmt::format("--time with {} {}: it requires a fixed plan, so bound the run by --trials", name, value));
    }
  }
  Plan plan;
  auto& [questions, answerers, judging, running] = plan;
  std::vector<const Kernel*>& kernels = answerers.kernels;
  questions.seed = options.seed;
  running.target = resolve_target(options.target);
  kernels = kernels_of(options.kernels);
  for (const Kernel* kernel : kernels) add_plugin(*kernel, answerers.plugins);
  const Predicate& predicate = predicate_of_kernels(options.predicate, kernels);
  if (kernels.empty()) {
    const bool is_of_a_mesh = options.families.empty() && !options.meshes.empty();
    if (is_of_a_mesh) require_served("--mesh", predicate, mesh_predicates());
    const std::size_t entry =
        is_of_a_mesh ? mesh_queries_of(predicate).entry : entry_of_families(predicate, options.families);
    kernels.push_back(&default_kernel(predicate, entry));
  }
  if (options.planted != RunOptions().planted) require_served("--plant", predicate, predicates_with(has_filters));
  if (options.precision.empty()) questions.precisions = {Precision::binary32, Precision::binary64};
  else questions.precisions = {parse_precision(options.precision)};
  drop_idle_precisions(questions, kernels, options.precision);
  for (const std::string& tolerance : options.tolerances) add_tolerance(tolerance, predicate, judging);
  questions.seconds = options.seconds;
  judging.exact_only = options.exact_only;
  judging.planted = static_cast<FilterFault>(
      std::find(filter_fault_names.begin(), filter_fault_names.end(), options.planted) - filter_fault_names.begin());
  questions.trials = [options](const Source& source, Precision precision) {
    return trials_of(options, source, precision);
  };
  running.threads = threads_of(options.threads);
  questions.sources = sources_of(options, predicate, kernels.front()->entry,
                                 options.precision.empty() ? Precision::binary32 : parse_precision(options.precision));
  require_one_predicate(kernels, questions.sources);
  check_required(options.required, plan);
  // Only of files that were asked for: the corpus of a preset was not.
  std::vector<SourcePtr> asked = questions.sources;
  if (!options.preset.empty()) std::erase_if(asked, [](const SourcePtr& source) { return source->name() == "corpus"; });
  print_left_out(asked, questions.precisions,
                 options.precision.empty() ? "no kernel of this run takes the" : "--precision leaves out");
  return plan;
}

}  // namespace axiscert

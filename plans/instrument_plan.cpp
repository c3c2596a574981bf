#include "plans/instrument_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "fuzz/confirm/record.h"
#include "fuzz/files/corpus.h"
#include "fuzz/files/query_file.h"
#include "fuzz/queries/family.h"
#include "fuzz/queries/query_shape.h"
#include "fuzz/queries/source.h"
#include "fuzz/queries/sweep.h"
#include "kernel/base/error.h"
#include "kernel/formulae_list.h"
#include "plans/notices.h"
#include "plans/predicate_options.h"
#include "plans/run_plan.h"
#include "reports/run_folder/run_folder.h"
#include "reports/wording/reproduce.h"

namespace axiscert {
namespace {

std::string needs_of(const InstrumentOptions& options, const Kernel& kernel, Measures measures) {
  const bool is_plugin = !kernel.file.empty();
  if (measures == Measures::verdicts) return "";
  if (measures == Measures::formulae && is_plugin) {
    return "this command evaluates built-in formulae itself; a plug-in that declares `formulae` is measured by the "
           "built-in kernel of these, and by run, check, ladder, condition, critical-radius and league as it is";
  }
  if (kernel.call != Call{}) return "this command measures formulae in an arithmetic, which '@CALL' does not change";
  if (!is_plugin) return "";
  if (kernel.may_decline)
    return options.command + " counts the comparisons of every query, and this plug-in declares that it may decline";
  const bool has_claim = formulae_of(kernel) != Formulae::none, shows_verdict = kernel.exposes == Exposure::verdict;
  if (has_claim && !shows_verdict) return "";
  return fmt::format(
      "{} holds comparisons to the formulae that a kernel evaluates: a plug-in has to declare `formulae`, and to "
      "expose comparisons or sides; this one {} and exposes {}",
      options.command, has_claim ? "declares formulae" : "declares no formulae",
      shows_verdict ? "its verdict alone" : "comparisons");
}

}  // namespace

std::vector<const Kernel*> instrument_kernels(const InstrumentOptions& options, std::vector<std::string> defaults,
                                              Measures measures, const std::vector<const Predicate*>& served) {
  const Precision precision = parse_precision(options.precision);
  std::vector<const Kernel*> kernels;
  for (const std::string& id : options.kernels.empty() ? defaults : options.kernels) {
    const Kernel& kernel = find_kernel(id);
    require_served(options.command, *kernel.predicate, served);
    require_loaded(kernel);
    if (const std::string needs = needs_of(options, kernel, measures); !needs.empty())
      throw Error(fmt::format("--kernel {}: {}", id, needs));
    if (!kernel.has(precision)) {
      throw Error(fmt::format("--precision {}: kernel {} does not exist in it", options.precision, id));
    }
    if (std::ranges::find(kernels, &kernel) == kernels.end()) kernels.push_back(&kernel);
  }
  print_first_look(kernels);
  return kernels;
}

EntryAsked entry_asked(const InstrumentOptions& options) {
  std::vector<const Kernel*> kernels;
  for (const std::string& id : options.kernels) kernels.push_back(&find_kernel(id));
  if (!kernels.empty()) return {&predicate_of_kernels("", kernels), kernels.front()->entry};
  for (const std::string& name : options.families) {
    if (name == "all") continue;
    const Family& family = find_family(name);
    return {&family.predicate(), family.entry};
  }
  return {&default_predicate(), 0};
}

namespace {

template <class Real>
bool has_valid_query(const Source& source) {
  const QueryShape shape = shape_of(source.predicate().entries[source.entry()]);
  const std::uint64_t size = source.fixed_size(precision_of<Real>).value_or(1);
  for (std::uint64_t position = 0; position < size; ++position) {
    if (may_be_valid(shape, source.make<Real>(0, position))) return true;
  }
  return false;
}

// Throws Error where a file of queries has none of the precision, or no valid one.
void require_valid_query(const Source& source, Precision precision) {
  const auto size = source.fixed_size(precision);
  if (!size) return;
  const Precision other = precision == Precision::binary32 ? Precision::binary64 : Precision::binary32;
  if (*size == 0) {
    throw Error(fmt::format("{}: none of its queries is in {}; --precision {} measures the {} that it has",
                            source.name(), name(precision), name(other), source.fixed_size(other).value_or(0)));
  }
  if (precision == Precision::binary32 ? has_valid_query<float>(source) : has_valid_query<double>(source)) return;
  throw Error(
      fmt::format("{}: none of its {} queries in {} is valid, so that there is nothing to measure; a valid one "
                  "has {}",
                  source.name(), *size, name(precision), source.predicate().entries[source.entry()].validity));
}

}  // namespace

std::vector<SourcePtr> instrument_sources(const InstrumentOptions& options, std::vector<std::string> defaults,
                                          const std::vector<const Predicate*>& served) {
  const auto [predicate, entry] = entry_asked(options);
  const Precision precision = parse_precision(options.precision.empty() ? "binary32" : options.precision);
  const bool are_own = !options.queries.empty() || !options.meshes.empty() || options.corpus;
  SourceOptions asked;
  asked.predicate = predicate->id;
  asked.is_part = true;
  asked.meshes = options.meshes;
  asked.queries = options.queries;
  asked.corpus = options.corpus;
  asked.families = options.families.empty() && !are_own ? std::move(defaults) : options.families;
  for (const Family* family : families_named(asked.families, *predicate, entry))
    require_served(options.command, family->predicate(), served);
  const std::vector<SourcePtr> sources = sources_of(asked, *predicate, entry, precision);
  if (!options.precision.empty()) {
    for (const SourcePtr& source : sources) {
      if (&source->predicate() != predicate || source->entry() != entry) {
        throw Error(
            fmt::format("{}: its queries are of {}, but the kernels are of {}; give a kernel of the queries' "
                        "predicate, if {} measures any",
                        source->name(), part_text(source->predicate(), source->entry()), part_text(*predicate, entry),
                        options.command));
      }
      require_valid_query(*source, precision);
    }
  }
  if (options.sweep.empty()) return sources;
  const Sweep sweep = parse_sweep(options.sweep);
  require_within(sweep, precision);
  std::vector<SourcePtr> swept;
  for (const SourcePtr& source : sources) {
    for (const SweepPoint& point : sweep.points) swept.push_back(swept_source(source, point));
  }
  return swept;
}

std::string instrument_command(const std::string& name, const InstrumentOptions& options) {
  std::string command = "axiscert " + name;
  for (const std::string& kernel : options.kernels) command += " --kernel " + kernel;
  for (const std::string& family : options.families) command += " --family " + family;
  for (const std::string& file : options.meshes) command += " --mesh " + shell_word(file);
  for (const std::string& file : options.queries) command += " --queries " + shell_word(file);
  if (options.corpus) command += " --corpus " + shell_word(*options.corpus);
  if (!options.sweep.empty()) command += " --sweep " + shell_word(options.sweep);
  command += fmt::format(" --trials {} --seed {}", options.trials, options.seed);
  return options.precision.empty() ? command : command + " --precision " + options.precision;
}

}  // namespace axiscert

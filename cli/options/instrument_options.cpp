#include "cli/options/instrument_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "cli/ending.h"
#include "cli/first_look.h"
#include "cli/options/run_options.h"
#include "cli/options/predicate_options.h"
#include "cli/options/shared_options.h"
#include "cli/progress_line.h"
#include "cli/usage.h"
#include "fuzz/files/file_parts.h"
#include "fuzz/files/corpus.h"
#include "fuzz/queries/query_shape.h"
#include "fuzz/queries/source.h"
#include "fuzz/queries/sweep.h"
#include "kernel/formulae_list.h"
#include "reports/wording/reproduce.h"
#include "fuzz/queries/family.h"
#include "kernel/base/error.h"
#include "fuzz/confirm/record.h"
#include "reports/run_folder/run_folder.h"

namespace axiscert {
void add_instrument_options(CLI::App& command, InstrumentOptions& o, std::uint64_t trials) {
  o.command = command.get_name();
  o.trials = trials;
  add_kernels(command, o.kernels, "kernel that is measured", "those that the documents show");
  add_families(command, o.families, "those that the documents show");
  add_trials(command, o.trials);
  add_seed(command, o.seed);
  add_precision(command, o.precision, "", o.precision.empty() ? "both" : "");
  add_thread_option(command, o.threads);
  add_plugin_seconds(command);
  add_progress(command);
  add_format(command, o.format, data_formats);
  add_out(command, o.out, "the figures as JSON, as CSV and as a page");
}

void add_own_queries(CLI::App& command, InstrumentOptions& o) {
  command.add_option("--mesh", o.meshes, "mesh file of any format assimp reads, repeatable")
      ->allow_extra_args(false)
      ->group(asked_group);
  add_query_files(command, o.queries);
  command.add_option("--corpus", o.corpus, "the corpus, from this folder or the one supplied with axiscert")
      ->expected(0, 1)
      ->default_str(default_corpus_folder())
      ->group(asked_group);
  command
      .add_option(
          "--sweep", o.sweep,
          "measure all queries again with each value of a parameter: offset=2^0..2^20 moves them so far in every "
          "coordinate, size=1,10,100 scales them about the sphere's centre, radius=0.5,1,2 multiplies the "
          "radius; numbers are rounded to --precision, and a query is judged as what it has become")
      ->check(known_by([](const std::string& text) { parse_sweep(text); }))
      ->group(asked_group);
}

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

namespace {

// For an interrupt: the figures are of all queries or of none.
void say_how_to_ask_less(const InstrumentOptions& options) {
  keep_nothing(fmt::format(
      "{} keeps nothing of a part of its figures; it asks less by fewer --trials (a tenth: --trials {}), kernels and "
      "families{}",
      options.command, std::max<std::uint64_t>(1, options.trials / 10),
      options.asks_less.empty() ? "" : ", and " + options.asks_less));
}

}  // namespace

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
  if (!options.out.empty()) make_folder(options.out);  // refused before anything runs
  say_how_to_ask_less(options);
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

int print_and_write_instrument(const InstrumentReport& report, const InstrumentOptions& options) {
  fmt::print("{}", options.format == "text" ? instrument_text(report) : data_text(report.data, options.format));
  if (options.out.empty()) return exit_done;
  make_folder(options.out);
  write_files(options.out, {{report.name + ".json", data_text(report.data, "json")},
                            {report.name + ".csv", data_text(report.data, "csv")},
                            {report.name + ".html", instrument_page(report)}});
  if (options.format == "text")
    fmt::print("{}\n", (std::filesystem::path(options.out) / (report.name + ".html")).string());
  return exit_done;
}

}  // namespace axiscert

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>

#include "cli/first_look.h"
#include "cli/options/address_query.h"
#include "cli/options/predicate_options.h"
#include "cli/options/query_parts.h"
#include "cli/options/shared_options.h"
#include "cli/commands.h"
#include "cli/help.h"
#include "cli/progress_line.h"
#include "cli/usage.h"
#include "cli/running/shrunk.h"
#include "fuzz/text/file_bytes.h"
#include "kernel/base/text.h"
#include "kernel/base/error.h"
#include "fuzz/confirm/record.h"
#include "fuzz/shrink/pair.h"

namespace axiscert {
namespace {

struct ShrinkOptions {
  std::vector<std::string> queries;
  std::vector<std::string> kernels;
  std::string target = "auto", precision = "binary32", what, format = "text";
  std::uint64_t evaluations = 1000000;
  bool any_class = false;
  AddressFiles files;
};

// "COMPARISON:error" keeps the error, whether or not the sign is wrong; "asymmetry" the difference between the answers
// to a query and to an image of it.
constexpr std::string_view error_suffix = ":error", asymmetry_name = "asymmetry";

std::string unknown_symptom(const Predicate& predicate, std::string_view given) {
  std::vector<std::string_view> names = {"verdict"};
  for (const PredicateClause& clause : predicate.clauses) names.push_back(clause.name);
  for (const PredicateComparison& comparison : predicate.comparisons) names.push_back(comparison.name);
  for (const auto& words : {judged_measures(predicate), fault_words(predicate)}) {
    for (const std::string_view one : words) {
      if (std::ranges::find(names, one) == names.end()) names.push_back(one);
    }
  }
  names.push_back(asymmetry_name);
  const std::string_view suffix = given.find(':') == given.npos ? "" : error_suffix;
  const std::string_view word = given.substr(0, given.find(':')), guess = meant(word, names);
  return fmt::format("--what {}: unknown{} possible values: {}, and COMPARISON{}", given,
                     guess.empty() ? ";" : fmt::format("; did you mean '{}{}'?", guess, suffix),
                     fmt::join(most_alike_first(word, names), ", "), error_suffix);
}

// The symptom of that name, without the parts that have to be determined from a query; empty where there is no such
// name.
std::optional<Symptom> symptom_named(const Predicate& predicate, std::string_view what) {
  const bool is_error = what.ends_with(error_suffix);
  if (is_error) what.remove_suffix(error_suffix.size());
  if (what == "verdict" && !is_error) return Symptom{.predicate = &predicate};
  for (std::uint8_t i = 0; i < predicate.clauses.size(); ++i) {
    if (predicate.clauses[i].name == what && !is_error)
      return Symptom{.predicate = &predicate, .level = Level::axis, .index = i};
  }
  for (std::uint8_t i = 0; i < predicate.comparisons.size(); ++i) {
    if (predicate.comparisons[i].name == what)
      return Symptom{.predicate = &predicate, .level = Level::comparison, .index = i};
  }
  return std::nullopt;
}

bool is_measure(const Predicate& predicate, std::string_view what) {
  for (const MeasureFault which : enumerators<MeasureFault>) {
    if (has_measure(predicate, measure_of(which)) && is_named(which, what)) return true;
  }
  return false;
}

// Refuses what is no name of a symptom.
void require_known(const Kernel& kernel, std::string_view what) {
  const Predicate& predicate = *kernel.predicate;
  if (what.empty() || is_measure(predicate, what)) return;
  if (what != asymmetry_name && !symptom_named(predicate, what)) throw Error(unknown_symptom(predicate, what));
}

std::string symptoms_text(const std::vector<Symptom>& symptoms) {
  std::vector<std::string> texts;
  for (const Symptom& s : symptoms) texts.push_back(text(s));
  return texts.empty() ? "its verdict and every axis and comparison are right there"
                       : fmt::format("{}", fmt::join(texts, "; "));
}

// Thrown for a query that shows nothing to keep.
struct NothingToKeep : Error {
  using Error::Error;
};

// The fault of a measure; where none is named, the first that there is.
template <class Real>
std::optional<Symptom> measure_fault(const Numbers<Real>& q, std::string_view measure, SymptomFinder<Real>& finder) {
  for (const Symptom& fault : finder.measure_faults(q)) {
    if (measure.empty() || is_named(*fault.measure, measure)) return fault;
  }
  return std::nullopt;
}

// The symptom to keep: the one requested, or the first that is wrong: verdict, axes, comparisons, the numbers beside a
// contact; and where nothing is, the largest error of a comparison.
template <class Real>
Symptom symptom_to_keep(const Numbers<Real>& q, const StoredQuery& stored, const ShrinkOptions& options,
                        const Kernel& kernel, std::string_view target) {
  const auto fail = [&](const std::string& what) {
    return NothingToKeep(fmt::format("query '{}': {}", stored.id, what));
  };
  if (oracles_of(kernel).truth(q).verdict == Verdict::invalid)
    throw fail(fmt::format("not a valid query ({}): no answer of a kernel could be wrong", stored.columns().validity));
  SymptomFinder<Real> finder(kernel, target);
  const std::vector<Symptom> flips = finder.flips(q);
  const bool is_of_verdict = options.what.empty() ? flips.empty() : options.what == "verdict";
  if (is_of_verdict || !is_promised(kernel, q)) {
    // No wrong verdict is one thing, and no verdict another.
    if (const auto why = finder.why_no_verdict(q)) {
      throw fail(
          fmt::format("{} has no verdict to keep: {}; shrink keeps verdicts, axes and comparisons that are wrong",
                      kernel.id, *why));
    }
  }
  if (options.what.empty()) {
    if (!flips.empty()) return flips.front();
    if (const auto fault = measure_fault<Real>(q, "", finder)) return *fault;
    if (const auto error = finder.largest_error(q)) return *error;
    throw fail(fmt::format("{} is not wrong on it: {}{}; to keep the error of a comparison, give --what COMPARISON{}",
                           kernel.id, symptoms_text(flips),
                           stored.address.empty() ? "" : ", and it answers no image of it differently", error_suffix));
  }
  if (is_measure(*kernel.predicate, options.what)) {
    if (const auto fault = measure_fault(q, options.what, finder)) return *fault;
    throw fail(fmt::format("--what {0}: {1} has no {0} that is wrong there{2}", options.what, kernel.id,
                           is_of_motions(*kernel.predicate) ? ", beside a right contact" : ""));
  }
  const Symptom asked = *symptom_named(*kernel.predicate, options.what);
  if (!std::string_view(options.what).ends_with(error_suffix)) {
    for (const Symptom& flip : flips) {
      if (flip.level == asked.level && flip.index == asked.index) return flip;
    }
    throw fail(fmt::format("--what {}: {} has it right; it is wrong there: {}", options.what, kernel.id,
                           flips.empty() ? "nothing" : symptoms_text(flips)));
  }
  if (finder.severity(q, asked)) return asked;
  throw fail(
      fmt::format("--what {}: {} has no measurable error there: it shows no sides of its own "
                  "formulae, or a side is not finite, or there is nothing to measure against",
                  options.what, kernel.id));
}

KeepingRule keeping_rule(const ShrinkOptions& options) {
  return options.any_class ? KeepingRule::symptom : KeepingRule::symptom_and_class;
}

template <class Real>
void print_before_and_after(const StoredQuery& stored, const StoredQuery& smaller, const ShrinkResult<Real>& found) {
  const auto row = [](const char* when, const QuerySize& size, const Severity& severity, const StoredQuery& q) {
    fmt::print("  {:<7} {:>3} bits in {:>2} numbers, {}: {}\n", when, size.bits, size.nonzero, severity.text,
               query_line(q));
  };
  row("before", found.sizes.front(), found.before, stored);
  row("after", found.sizes.back(), found.after, smaller);
}

// "; input of class near_tie": what is kept besides the symptom.
template <class Real>
std::string class_text(const ShrinkResult<Real>& found) {
  const auto& classes = found.kept.classes();
  return classes ? fmt::format("; input of class {}", classes->front()) : "";
}

template <class Real>
void print_steps(const ShrinkResult<Real>& found) {
  fmt::print("  {} steps, {} queries evaluated{}\n", found.sizes.size() - 1, found.evaluations,
             found.complete ? ", no step makes it smaller" : ": the limit; --evaluations raises it");
  if (found.sizes.size() > 1 || !found.complete || !found.kept.classes()) return;
  fmt::print(
      "  cannot be made smaller with its class and a depth of at most {} times its own; --any-class lets both go\n",
      depth_factor);
}

template <class Real>
void print_text(const StoredQuery& stored, const StoredQuery& smaller, const Symptom& kept,
                const ShrinkResult<Real>& found, const Kernel& kernel) {
  fmt::print("{}: {} keeps {}{}\n", stored.id, kernel.id, text(kept), class_text(found));
  print_before_and_after(stored, smaller, found);
  print_steps(found);
  fmt::print("  check   echo '{}' | axiscert check - --kernel {}\n", query_line(smaller), kernel.id);
}

template <class Real>
void print_pair(const StoredQuery& stored, const StoredQuery& smaller, const StoredQuery& image,
                const PairSymptom& kept, const ShrunkPair<Real>& found, const Kernel& kernel) {
  fmt::print("{}: {} keeps asymmetry: {}{}\n", stored.id, kernel.id, text(kept), class_text(found.query));
  print_before_and_after(stored, smaller, found.query);
  fmt::print("  image   {}\n", query_line(image));
  print_steps(found.query);
  fmt::print("  check   printf '%s\\n' '{}' '{}' | axiscert check - --kernel {}\n", query_line(smaller),
             query_line(image), kernel.id);
}

template <class Real>
void shrink_as_pair(const Pair<Real>& pair, const StoredQuery& stored, const ShrinkOptions& options,
                    const Kernel& kernel, std::string_view target, ProgressLine& progress,
                    const CountEvaluations& evaluated) {
  const auto found = shrink_pair(pair, kernel, target, options.evaluations, keeping_rule(options), evaluated);
  progress.clear();
  const StoredQuery smaller = smaller_query(stored, found.query.query);
  const StoredQuery image = image_of(smaller, found.image);
  if (options.format == "text") print_pair(stored, smaller, image, pair.symptom, found, kernel);
  else fmt::print("{}\n", json_of(ShrinkLine{{}, shrunk_pair(stored, pair, found, kernel)}).dump());
}

template <class Real>
void shrink_one(const Numbers<Real>& q, const StoredQuery& stored, const ShrinkOptions& options, const Kernel& kernel,
                std::string_view target, ProgressLine& progress, Progress at) {
  const auto start = std::chrono::steady_clock::now();
  const CountEvaluations evaluated = [&](std::uint64_t evaluations) {
    at.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    progress.show(at, fmt::format("; {} evaluations for the next, of at most {}", evaluations, options.evaluations));
  };
  const bool wants_pair = options.what == asymmetry_name;
  // Without --what, a query that is right by itself is half of a pair, if it is in one.
  const auto is_right = [&] {
    return may_be_valid(shape_of(stored.columns()), q) && SymptomFinder<Real>(kernel, target).flips(q).empty();
  };
  if (wants_pair || (options.what.empty() && is_right())) {
    if (const auto pair = asymmetric_pair(q, stored.address, kernel, target)) {
      shrink_as_pair(*pair, stored, options, kernel, target, progress, evaluated);
      std::fflush(stdout);
      return;
    }
  }
  // Where no map leads from the one to the other, the one that is answered wrongly is made smaller.
  if (wants_pair || (options.what.empty() && !stored.address.empty() && is_right())) {
    if (const auto relative = wrong_relative(q, stored.address, kernel, target)) {
      if (options.format == "text") {
        fmt::print("{}: {} is right on it, and wrong on {} of the same images, which is made smaller\n", stored.id,
                   kernel.id, relative->address);
      }
      StoredQuery other{relative->address, stored.precision, relative->query, stored.predicate, stored.entry};
      ShrinkOptions of_verdict = options;
      of_verdict.what = "verdict";
      return shrink_one(relative->query, other, of_verdict, kernel, target, progress, at);
    }
  }
  if (wants_pair) {
    throw NothingToKeep(fmt::format(
        "query '{}': --what {}: {}", stored.id, asymmetry_name,
        stored.address.empty() ? "give an address, or a witness, of a family of images: it states no address"
                               : kernel.id + " answers no image of it differently, its family has none, or its "
                                             "numbers are not those of its address"));
  }
  const Symptom kept = symptom_to_keep(q, stored, options, kernel, target);
  const auto found = shrink<Real>(q, kept, kernel, target, options.evaluations, keeping_rule(options), evaluated);
  progress.clear();
  const StoredQuery smaller = smaller_query(stored, found.query);
  if (options.format == "text") print_text(stored, smaller, kept, found, kernel);
  else fmt::print("{}\n", json_of(ShrinkLine{{}, shrunk_query(stored, kept, found, kernel)}).dump());
  std::fflush(stdout);
}

// The kernel that a query is asked of, which has to take it. Of several given the one of its predicate and entry.
const Kernel& kernel_for(const StoredQuery& stored, const std::vector<const Kernel*>& given) {
  const Kernel& kernel = given.size() == 1 ? *given.front()
                                           : kernel_for_query(given, *stored.predicate, stored.entry,
                                                              fmt::format("query '{}'", stored.id));
  if (stored.predicate != kernel.predicate || stored.entry != kernel.entry) {
    throw Error(fmt::format("query '{}' is of the predicate {}, entry {}, and kernel {} of {}, {}", stored.id,
                            stored.predicate->id, stored.columns().name, kernel.id, kernel.predicate->id,
                            kernel.predicate->entries[kernel.entry].name));
  }
  if (!kernel.has(stored.precision)) {
    throw Error(fmt::format("query '{}' is in {}, in which kernel {} does not exist", stored.id, name(stored.precision),
                            kernel.id));
  }
  return kernel;
}

int shrink_all(const ShrinkOptions& options) {
  // Before queries are read, which may be long.
  std::vector<const Kernel*> given;
  for (const std::string& id : options.kernels) require_known(*given.emplace_back(&find_kernel(id)), options.what);
  require_one_of_each(given);
  const auto queries = queries_given(options.queries, options.precision, options.files);
  for (const Kernel* kernel : given) require_loaded(*kernel);
  print_first_look(given);
  const std::string target = resolve_target(options.target);
  for (const StoredQuery& stored : queries) require_known(kernel_for(stored, given), options.what);
  // A query that shows nothing to keep does not stop the others, but is an error where it is the only one.
  std::size_t shrunk = 0;
  ProgressLine progress("shrink");
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const StoredQuery& stored = queries[i];
    const Kernel& kernel = kernel_for(stored, given);
    const Progress at{i, queries.size(), 0, 0};
    try {
      std::visit([&](const auto& q) { shrink_one(q, stored, options, kernel, target, progress, at); }, stored.numbers);
      ++shrunk;
    } catch (const NothingToKeep& nothing) {
      if (queries.size() == 1) throw;
      progress.clear();
      fmt::print(stderr, "axiscert: {}\n", nothing.what());
    }
  }
  if (shrunk == 0) throw Error(fmt::format("none of the {} queries shows anything to keep", queries.size()));
  return exit_done;
}

}  // namespace

void add_shrink(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand(
      "shrink",
      "Make queries on which a kernel is wrong smaller and easier to read, with the same fault, no less severe");
  auto options = std::make_shared<ShrinkOptions>();
  command->add_option("QUERY", options->queries, "query files (- for standard input) and addresses")
      ->required()
      ->check(no_kernel());
  add_kernels(*command, options->kernels, "kernel that is asked, one of a predicate",
              "the first of the query's predicate");
  add_target(*command, options->target);
  add_precision(*command, options->precision, of_csv_files);
  command->add_option(
      "--what", options->what,
      fmt::format("what to keep: verdict, an axis or a comparison that is wrong, COMPARISON:error, "
                  "a measure (time, separation, feature, normal, point), or asymmetry: another answer to an image of "
                  "the query, as a pair of {} and else of the one that is wrong (default: the first "
                  "that is wrong: verdict, axis, comparison, asymmetry, measure; else the largest "
                  "error of a comparison)",
                  ids_of(predicates_with(has_image_maps))));
  command->add_flag("--any-class", options->any_class,
                    fmt::format("as small as it goes: keep neither the class of the input nor a depth of at most {} "
                                "times the given one",
                                depth_factor));
  command->add_option("--evaluations", options->evaluations, "most smaller queries to evaluate, for each query")
      ->check(whole_number(1, std::uint64_t{1} << 40))
      ->capture_default_str();
  add_address_files(*command, options->files);
  add_plugin_seconds(*command);
  add_progress(*command);
  add_format(*command, options->format, {"jsonl"});
  add_examples(*command, {{"Every witness of a run", "axiscert shrink out/witnesses.jsonl"},
                          {"A query of a family", "axiscert shrink 1:sliver:2:binary32:0:9107 published"}});
  command->callback([&action, options] { action = [options] { return shrink_all(*options); }; });
}

}  // namespace axiscert

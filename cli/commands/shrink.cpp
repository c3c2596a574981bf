#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>

#include "cli/options/address_query.h"
#include "cli/options/test_options.h"
#include "cli/commands.h"
#include "cli/progress_line.h"
#include "cli/running/shrunk.h"
#include "fuzz/files/sphere_triangle_query.h"
#include "fuzz/text/file_bytes.h"
#include "kernel/base/error.h"
#include "fuzz/confirm/finding_record.h"

namespace axiscert {
namespace {

struct ShrinkOptions {
  std::vector<std::string> queries;
  std::string kernel = "published", target = "auto", precision = "binary32", what, format = "text";
  std::uint64_t evaluations = 1000000;
  AddressFiles files;
};

// "COMPARISON:error" keeps the error, whether or not the sign is wrong.
constexpr std::string_view error_suffix = ":error";

std::string known_symptoms() {
  std::vector<std::string_view> names = {"verdict"};
  names.insert(names.end(), axis_names.begin(), axis_names.end());
  for (const ComparisonInfo& c : comparisons) names.push_back(c.name);
  return fmt::format("{}, and COMPARISON{}", fmt::join(names, ", "), error_suffix);
}

// The symptom of that name, without the parts that have to be determined from a query; empty where there is no such
// name.
std::optional<Symptom> named(std::string_view what) {
  const bool is_error = what.ends_with(error_suffix);
  if (is_error) what.remove_suffix(error_suffix.size());
  if (what == "verdict" && !is_error) return Symptom{};
  for (std::uint8_t i = 0; i < axis_count; ++i) {
    if (axis_names[i] == what && !is_error) return Symptom{.level = Level::axis, .index = i};
  }
  for (std::uint8_t i = 0; i < comparison_count; ++i) {
    if (comparisons[i].name == what) return Symptom{.level = Level::comparison, .index = i};
  }
  return std::nullopt;
}

std::string joined(const std::vector<Symptom>& symptoms) {
  std::vector<std::string> texts;
  for (const Symptom& s : symptoms) texts.push_back(text(s));
  return texts.empty() ? "its verdict and every axis and comparison are right there"
                       : fmt::format("{}", fmt::join(texts, "; "));
}

// Thrown for a query that shows nothing to keep.
struct NothingToKeep : Error {
  using Error::Error;
};

// The symptom to keep: the one requested, or the first that is wrong: verdict before axes before comparisons.
template <class Real>
Symptom wanted(const Query<Real>& q, const StoredQuery& stored, const ShrinkOptions& options, const Kernel& kernel,
               std::string_view target) {
  const auto fail = [&](const std::string& what) {
    return NothingToKeep(fmt::format("query '{}': {}", stored.id, what));
  };
  if (!is_valid(q)) throw fail("not a valid query (finite, r >= 0): no answer of a kernel could be wrong");
  Diagnosis<Real> diagnosis(kernel, target);
  const std::vector<Symptom> flips = diagnosis.flips(q);
  if (options.what.empty()) {
    if (!flips.empty()) return flips.front();
    throw fail(fmt::format("{} is not wrong on it: {}; to keep the error of a comparison, give --what COMPARISON{}",
                           kernel.id, joined(flips), error_suffix));
  }
  const Symptom asked = *named(options.what);
  if (!std::string_view(options.what).ends_with(error_suffix)) {
    for (const Symptom& flip : flips) {
      if (flip.level == asked.level && flip.index == asked.index) return flip;
    }
    throw fail(fmt::format("--what {}: {} has it right; it is wrong there: {}", options.what, kernel.id,
                           flips.empty() ? "nothing" : joined(flips)));
  }
  if (diagnosis.severity(q, asked)) return asked;
  throw fail(
      fmt::format("--what {}: {} has no measurable error there: it shows no sides of its own "
                  "formulae, or a side is not finite, or there is nothing to measure against",
                  options.what, kernel.id));
}

template <class Real>
void print_text(const StoredQuery& stored, const StoredQuery& smaller, const Symptom& kept, const Shrunk<Real>& found,
                const Kernel& kernel) {
  const auto row = [](const char* when, const QuerySize& size, const Severity& severity, const StoredQuery& q) {
    fmt::print("  {:<7} {:>3} bits in {:>2} numbers, {}: {}\n", when, size.bits, size.nonzero, severity.text,
               query_line(q));
  };
  fmt::print("{}: {} keeps {}\n", stored.id, kernel.id, text(kept));
  row("before", found.sizes.front(), found.before, stored);
  row("after", found.sizes.back(), found.after, smaller);
  fmt::print("  {} steps, {} queries evaluated{}\n", found.sizes.size() - 1, found.evaluations,
             found.complete ? ", no step makes it smaller" : ": the limit; --evaluations raises it");
  fmt::print("  check   echo '{}' | axiscert check - --kernel {}\n", query_line(smaller), kernel.id);
}

template <class Real>
void shrink_one(const Query<Real>& q, const StoredQuery& stored, const ShrinkOptions& options, const Kernel& kernel,
                std::string_view target, ProgressLine& progress, Progress at) {
  const Symptom kept = wanted(q, stored, options, kernel, target);
  const auto start = std::chrono::steady_clock::now();
  const auto found = shrink(q, kept, kernel, target, options.evaluations, [&](std::uint64_t evaluations) {
    at.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    progress.show(at, fmt::format("; {} evaluations for the next, of at most {}", evaluations, options.evaluations));
  });
  progress.clear();
  const StoredQuery smaller{"shrunk-" + stored.id, stored.precision, found.query, 0};
  if (options.format == "text") print_text(stored, smaller, kept, found, kernel);
  else fmt::print("{}\n", shrunk_json(stored, kept, found, kernel).dump());
  std::fflush(stdout);
}

int shrink_all(const ShrinkOptions& options) {
  const Kernel& kernel = find_kernel(options.kernel);
  require_served("shrink", *kernel.test);
  require_loaded(kernel);
  const std::string target = resolve_target(options.target);
  if (!options.what.empty() && !named(options.what)) {
    throw Error(fmt::format("--what {}: unknown; possible values: {}", options.what, known_symptoms()));
  }
  const auto queries = queries_given(options.queries, options.precision, options.files);
  for (const StoredQuery& stored : queries) {
    if (kernel.has(stored.precision)) continue;
    throw Error(fmt::format("query '{}' is in {}, in which kernel {} does not exist", stored.id, name(stored.precision),
                            kernel.id));
  }
  // A query that shows nothing to keep does not stop the others, but is an error where it is the only one.
  std::size_t shrunk = 0;
  ProgressLine progress("shrink");
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const StoredQuery& stored = queries[i];
    const Progress at{i, queries.size(), 0, 0};
    try {
      std::visit([&](const auto& q) { shrink_one(q, stored, options, kernel, target, progress, at); },
                 sphere_triangle_query(stored));
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
  command->add_option("QUERY", options->queries, "query files (- for standard input) and addresses")->required();
  command->add_option("--kernel", options->kernel, "kernel id")->capture_default_str();
  command->add_option("--target", options->target, "instruction set, or auto")->capture_default_str();
  command->add_option("--precision", options->precision, "precision of a CSV file, which does not state it")
      ->capture_default_str();
  command->add_option("--what", options->what,
                      "what to keep: verdict, an axis or a comparison that is wrong, or COMPARISON:error (default: the "
                      "first that is wrong, in this order)");
  command->add_option("--evaluations", options->evaluations, "most smaller queries to evaluate, for each query")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1} << 40))
      ->capture_default_str();
  add_address_files(*command, options->files);
  add_plugin_seconds(*command);
  add_progress(*command);
  add_format(*command, options->format, "jsonl");
  command->callback([&action, options] { action = [options] { return shrink_all(*options); }; });
}

}  // namespace axiscert

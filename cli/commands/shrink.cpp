#include <fmt/format.h>

#include <chrono>
#include <cstdio>

#include "cli/commands.h"
#include "cli/help.h"
#include "cli/progress_line.h"
#include "cli/shared_options.h"
#include "cli/usage.h"
#include "fuzz/confirm/record.h"
#include "fuzz/text/json_form.h"
#include "kernel/base/error.h"
#include "plans/given_queries.h"
#include "plans/notices.h"
#include "plans/predicate_options.h"
#include "plans/shrink_query.h"

namespace axiscert {
namespace {

void print_text(const StoredQuery& stored, const Shrunk& found, const Kernel& kernel) {
  const StoredQuery& asked = found.asked;
  if (found.is_relative) {
    fmt::print("{}: {} is right on it, and wrong on {} of the same images, which is made smaller\n", stored.id,
               kernel.id, asked.id);
  }
  // What is kept besides the symptom.
  const std::string besides = found.input_class.empty() ? "" : fmt::format("; input of class {}", found.input_class);
  fmt::print("{}: {} keeps {}{}\n", asked.id, kernel.id, found.kept, besides);
  const auto row = [](const char* when, const QuerySize& size, const std::string& severity, const StoredQuery& q) {
    fmt::print("  {:<7} {:>3} bits in {:>2} numbers, {}: {}\n", when, size.bits, size.nonzero, severity, query_line(q));
  };
  row("before", found.size_before, found.severity_before, asked);
  row("after", found.size_after, found.severity_after, found.smaller);
  if (found.image) fmt::print("  image   {}\n", query_line(*found.image));
  fmt::print("  {} steps, {} queries evaluated{}\n", found.steps, found.evaluations,
             found.complete ? ", no step makes it smaller" : ": the limit; --evaluations raises it");
  if (found.steps == 0 && found.complete && !found.input_class.empty()) {
    fmt::print(
        "  cannot be made smaller with its class and a depth of at most {} times its own; --any-class lets both go\n",
        depth_factor);
  }
  if (found.image) {
    fmt::print("  check   printf '%s\\n' '{}' '{}' | axiscert check - --kernel {}\n", query_line(found.smaller),
               query_line(*found.image), kernel.id);
  } else {
    fmt::print("  check   echo '{}' | axiscert check - --kernel {}\n", query_line(found.smaller), kernel.id);
  }
}

int shrink_all(const ShrinkOptions& options) {
  // Before queries are read, which may be long.
  std::vector<const Kernel*> given;
  for (const std::string& id : options.kernels)
    require_known_symptom(*given.emplace_back(&find_kernel(id)), options.what);
  require_one_of_each(given);
  const auto queries = queries_given(options.queries, options.precision, options.files);
  for (const Kernel* kernel : given) require_loaded(*kernel);
  print_first_look(given);
  const std::string target = resolve_target(options.target);
  for (const StoredQuery& stored : queries) require_known_symptom(kernel_to_shrink(stored, given), options.what);
  // A query that shows nothing to keep does not stop the others, but is an error where it is the only one.
  std::size_t done = 0;
  ProgressLine progress("shrink");
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const StoredQuery& stored = queries[i];
    const Kernel& kernel = kernel_to_shrink(stored, given);
    const Progress at{i, queries.size(), 0, 0};
    try {
      const auto start = std::chrono::steady_clock::now();
      const Shrunk found = shrunk(stored, options, kernel, target, [&](std::uint64_t evaluations) {
        Progress now = at;
        now.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        progress.show(now,
                      fmt::format("; {} evaluations for the next, of at most {}", evaluations, options.evaluations));
        return true;
      });
      progress.clear();
      if (options.format == "text") print_text(stored, found, kernel);
      else fmt::print("{}\n", json_of(ShrinkLine{{}, found.line}).dump());
      std::fflush(stdout);
      ++done;
    } catch (const NothingToKeep& nothing) {
      if (queries.size() == 1) throw;
      progress.clear();
      fmt::print(stderr, "axiscert: {}\n", nothing.what());
    }
  }
  if (done == 0) throw Error(fmt::format("none of the {} queries shows anything to keep", queries.size()));
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
      fmt::format(
          "what to keep: verdict, an axis or a comparison that is wrong, COMPARISON:error, "
          "a measure (time, separation, feature, normal, left, unit, flip, point), or asymmetry: another "
          "answer to an image of the query, as a pair of {} and else of the one that is wrong (default: the first "
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

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <map>

#include "cli/commands.h"
#include "cli/commands/check_output.h"
#include "cli/commands/query_rows.h"
#include "cli/help.h"
#include "cli/progress_line.h"
#include "cli/shared_options.h"
#include "fuzz/confirm/record.h"
#include "fuzz/files/query_file.h"
#include "fuzz/queries/capabilities.h"
#include "fuzz/queries/source.h"
#include "fuzz/text/json_form.h"
#include "kernel/permitted/kernels.h"
#include "kernel/query.h"
#include "plans/given_queries.h"
#include "plans/notices.h"
#include "plans/predicate_options.h"

namespace axiscert {
namespace {

struct CheckOptions {
  std::string file, format = "text", target = "auto", precision = "binary32";
  std::vector<std::string> kernels;
  AddressFiles files;
  bool errors = false, exact = false;
};

std::optional<SideErrors> errors_of(const StoredQuery& stored, const Kernel& kernel, const std::string& target) {
  return std::visit([&]<class Real>(const Numbers<Real>& q) { return Confirmer<Real>(kernel, target).errors(q); },
                    stored.numbers);
}

template <class Real>
CheckResult check_query(Examiner& examiner, const Numbers<Real>& q) {
  const Examination found = examiner.examine(q);
  const Predicate& predicate = *examiner.kernel().predicate;
  const Oracles& oracles = oracles_of(examiner.kernel());
  if (found.truth.verdict != Verdict::invalid) {
    CheckResult checked = checked_of(predicate, found, oracles.details(q));
    checked.digits = std::numeric_limits<Real>::max_digits10;
    if (const auto facts_of = capabilities_of(predicate).exact_facts)
      checked.facts = facts_of(in_doubles(q), examiner.kernel().entry);
    return checked;
  }
  CheckResult invalid = checked_of(predicate, found);
  invalid.why_invalid = oracles.why_invalid(q);
  return invalid;
}

// `what`: "mine.jsonl: query 'q' is".
void require_query_of(const Kernel& kernel, const Predicate& predicate, std::size_t entry, Precision precision,
                      const std::string& what) {
  if (!kernel.has(precision)) {
    throw Error(fmt::format("{} in {}, in which kernel {} does not exist", what, name(precision), kernel.id));
  }
  if (kernel.predicate == &predicate && kernel.entry == entry) return;
  throw Error(
      fmt::format("{} of the predicate {}, entry {}, and kernel {} of {}, entry {}; a query is judged "
                  "by a kernel of its own predicate and entry",
                  what, predicate.id, predicate.entries[entry].name, kernel.id, kernel.predicate->id,
                  kernel.predicate->entries[kernel.entry].name));
}

std::vector<const Kernel*> kernels_given(const CheckOptions& options) {
  std::vector<const Kernel*> kernels;
  for (const std::string& id : options.kernels) require_loaded(*kernels.emplace_back(&find_kernel(id)));
  print_first_look(kernels);
  return kernels;
}

// A file without a query that the kernel promises and decided shows nothing of it, which is said.
void print_if_nothing_decided(const Kernel& kernel, std::size_t queries, const StandingCounts& standings) {
  if (queries == 0 || standings.contains("decided")) return;
  std::vector<std::string> parts;
  for (const auto& [standing, count] : standings) parts.push_back(fmt::format("{} {}", count, standing));
  fmt::print(stderr, "axiscert: nothing was looked at: {} decided none of {} queries ({})\n", kernel.id, queries,
             fmt::join(parts, ", "));
}

// A row for each query of the range and each kernel, and first how many these are.
int check_range(const CheckOptions& options) {
  const QueryRange range = query_range(options.file, options.files);
  if (options.format == "text")
    throw Error(fmt::format("{}: the queries of addresses are rows; give --format csv or jsonl", options.file));
  if (options.errors)
    throw Error("--errors: the errors of sides are of queries in a file; `axiscert query` writes one");
  if (options.exact) throw Error("--exact: exact numbers are of queries in a file; `axiscert query` writes one");
  std::vector<const Kernel*> kernels = kernels_given(options);
  const std::string target = resolve_target(options.target);
  const Predicate& predicate = range.source->predicate();
  if (kernels.empty()) kernels.push_back(&default_kernel(predicate, range.source->entry()));
  for (const Kernel* kernel : kernels) {
    require_query_of(*kernel, predicate, range.source->entry(), range.first.precision,
                     fmt::format("the query {} is", text(range.first)));
  }
  QueryRows rows(range, kernels, target, options.format);
  fmt::print(stderr, "axiscert: {} row{}, about {} bytes\n", rows.size(), rows.size() == 1 ? "" : "s", rows.bytes());
  ProgressLine progress("check");
  const ShowProgress show = progress.report();
  constexpr std::uint64_t batch = 1024;
  ProgressCount count(show, (range.size + batch - 1) / batch);
  fmt::print("{}", rows.head());
  for (std::uint64_t done = 0; done < range.size; done += batch) {
    const std::string part = rows.next(batch);
    count.finish_unit(std::min(batch, range.size - done));
    progress.clear();
    fmt::print("{}", part);
  }
  for (std::size_t k = 0; k < kernels.size(); ++k)
    print_if_nothing_decided(*kernels[k], range.size, rows.standings()[k]);
  return exit_done;  // whatever it found
}

// What one kernel was asked of a file, which may have queries of several predicates.
struct CheckedByOne {
  CheckedByOne(const Kernel& kernel, const std::string& target) : examiner(kernel, target) {}
  Examiner examiner;
  StandingCounts standings;
  std::size_t queries = 0;
};

// With one of those given, a query of another predicate or entry is refused in its words.
const Kernel& kernel_checked(const StoredQuery& stored, const std::vector<const Kernel*>& given,
                             const std::string& file) {
  const std::string what = fmt::format("{}: query '{}'", file, stored.id);
  const Kernel& kernel =
      given.size() == 1 ? *given.front() : kernel_for_query(given, *stored.predicate, stored.entry, what);
  require_query_of(kernel, *stored.predicate, stored.entry, stored.precision, what + " is");
  return kernel;
}

int check(const CheckOptions& options) {
  if (is_address(options.file)) return check_range(options);
  if (options.format == "csv")
    throw Error(
        fmt::format("--format csv: has the rows of addresses, SEED:NAME:VERSION:PRECISION:UNIT:FIRST-LAST; the "
                    "queries of {} are printed as text or jsonl",
                    options.file));
  const std::vector<const Kernel*> given = kernels_given(options);
  require_one_of_each(given);
  const std::string target = resolve_target(options.target);
  const Precision csv_precision = parse_precision(options.precision);
  const auto queries = read_query_file(options.file, csv_precision);
  if (const auto parts = counts_of(queries); parts.size() > 1)
    fmt::print(stderr, "axiscert: {}: {}\n", options.file == "-" ? "stdin" : options.file, parts_text(parts));
  std::vector<const Kernel*> kernels;  // of each query
  for (const StoredQuery& stored : queries) kernels.push_back(&kernel_checked(stored, given, options.file));
  std::map<std::string_view, CheckedByOne> asked;
  ProgressLine progress("check");
  const ShowProgress show = progress.report();
  ProgressCount count(show, queries.size());
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const StoredQuery& stored = queries[i];
    const Kernel& kernel = *kernels[i];
    auto& [examiner, standings, asked_of_it] = asked.try_emplace(kernel.id, kernel, target).first->second;
    ++asked_of_it;
    const CheckResult found = std::visit([&](const auto& q) { return check_query(examiner, q); }, stored.numbers);
    ++standings[standing_of(kernel, found)];
    count.finish_unit();
    progress.clear();
    if (options.format == "text") {
      fmt::print("{}\n", check_text(stored.id, kernel, found));
      if (const std::string facts = facts_text(found, options.exact); !facts.empty()) fmt::print("{}\n", facts);
      if (options.errors) fmt::print("{}\n", errors_text(*kernel.predicate, errors_of(stored, kernel, target)));
      if (const auto* query = std::get_if<Numbers<float>>(&stored.numbers)) {
        for (const std::string& line : permitted::evaluation(kernel, *query)) fmt::print("  {}\n", line);
      }
    } else {
      CheckLine line = check_line(stored.id, kernel, found);
      if (options.errors) line.errors.emplace(errors_line(*kernel.predicate, errors_of(stored, kernel, target)));
      fmt::print("{}\n", json_of(line).dump());
    }
  }
  for (const auto& [id, checked] : asked)
    print_if_nothing_decided(checked.examiner.kernel(), checked.queries, checked.standings);
  return exit_done;  // whatever it found
}

}  // namespace

void add_check(CLI::App& app, Action& action) {
  auto* command =
      app.add_subcommand("check", "Judge each query of a file, or of a range of addresses: exact and computed answers");
  auto options = std::make_shared<CheckOptions>();
  command
      ->add_option("FILE", options->file,
                   "query file, JSON Lines or CSV; - reads standard input; or a range of addresses, "
                   "SEED:NAME:VERSION:PRECISION:UNIT:FIRST-LAST, whose rows --format csv and jsonl print")
      ->required()
      ->check(no_kernel());
  add_kernels(*command, options->kernels, "kernel that is asked", "the first of the predicate of the query");
  add_address_files(*command, options->files);
  add_target(*command, options->target);
  add_precision(*command, options->precision, of_csv_files);
  command->add_flag("--errors", options->errors, "also print the errors of the computed sides, in u, exactly");
  command->add_flag("--exact", options->exact,
                    "also print distances, places and times as fractions and roots, which --format jsonl always has");
  add_plugin_seconds(*command);
  add_progress(*command);
  add_format(*command, options->format, {"jsonl", "csv"});
  add_examples(*command, {{"Each query of a file: exact, computed, how wrong", "axiscert check mine.jsonl published"},
                          {"The same for a program", "axiscert check mine.jsonl published --format jsonl"},
                          {"A row for each of a hundred queries of a family and each of two kernels",
                           "axiscert check 1:tangent:2:binary32:0:0-99 published certified --format csv"}});
  command->callback([&action, options] { action = [options] { return check(*options); }; });
}

}  // namespace axiscert

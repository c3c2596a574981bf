#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>

#include "cli/running/check_output.h"
#include "cli/progress_line.h"
#include "cli/commands.h"
#include "cli/options/test_options.h"
#include "fuzz/queries/address.h"
#include "fuzz/files/query_file.h"
#include "fuzz/confirm/finding_record.h"
#include "reports/instrument/data.h"

namespace axiscert {
namespace {

struct CheckOptions {
  std::string file, kernel, format = "text", target = "auto", precision = "binary32";
  bool errors = false;
};

std::optional<SideErrors> errors_of(const StoredQuery& stored, const Kernel& kernel, const std::string& target) {
  return std::visit([&]<class Real>(const Numbers<Real>& q) { return Confirmer<Real>(kernel, target).errors(q); },
                    stored.numbers);
}

template <class Real>
Checked checked(Examiner& examiner, const Numbers<Real>& q) {
  const Examination found = examiner.examine(q);
  const TestDescription& test = *examiner.kernel().test;
  const Oracles& oracles = oracles_of(examiner.kernel());
  if (found.truth.verdict != Verdict::invalid) return checked_of(test, found, oracles.details(q));
  Checked invalid = checked_of(test, found);
  invalid.why_invalid = oracles.why_invalid(q);
  return invalid;
}

void require_query_of(const Kernel& kernel, const StoredQuery& stored, const std::string& file) {
  if (kernel.test == stored.test && kernel.entry == stored.entry) return;
  throw Error(
      fmt::format("{}: query '{}' is of the test {}, entry {}, and kernel {} of {}, entry {}; a query is judged "
                  "by a kernel of its own test and entry",
                  file, stored.id, stored.test->id, stored.columns().name, kernel.id, kernel.test->id,
                  kernel.test->entries[kernel.entry].name));
}

// A file of which the kernel decided no query that it promises shows nothing of it, which is said.
void say_if_nothing(const Kernel& kernel, std::size_t queries,
                    const std::map<std::string_view, std::size_t>& standings) {
  const auto invalid = standings.find("no_query");
  const bool are_none = queries == (invalid == standings.end() ? 0 : invalid->second);
  if (are_none || standings.contains("decided")) return;
  std::vector<std::string> parts;
  for (const auto& [standing, count] : standings) parts.push_back(fmt::format("{} {}", count, standing));
  fmt::print(stderr, "axiscert: nothing was looked at: {} decided none of {} queries ({})\n", kernel.id, queries,
             fmt::join(parts, ", "));
}

int check(const CheckOptions& options) {
  const Kernel* const given = options.kernel.empty() ? nullptr : &find_kernel(options.kernel);
  if (given != nullptr) require_loaded(*given);
  const std::string target = resolve_target(options.target);
  const auto queries = read_query_file(options.file, parse_precision(options.precision));
  const Kernel& kernel = given != nullptr  ? *given
                         : queries.empty() ? default_kernel(default_test())
                                           : default_kernel(*queries.front().test, queries.front().entry);
  Examiner examiner(kernel, target);
  ProgressLine progress("check");
  const ShowProgress show = progress.report();
  ProgressCount count(show, queries.size());
  std::map<std::string_view, std::size_t> standings;
  for (const StoredQuery& stored : queries) {
    if (!kernel.has(stored.precision)) {
      throw Error(fmt::format("{}: query '{}' is in {}, in which kernel {} does not exist", options.file, stored.id,
                              name(stored.precision), kernel.id));
    }
    require_query_of(kernel, stored, options.file);
    const Checked found = std::visit([&](const auto& q) { return checked(examiner, q); }, stored.numbers);
    ++standings[standing_of(kernel, found)];
    count.finished();
    progress.clear();
    if (options.format == "text") {
      fmt::print("{}\n", check_text(stored.id, kernel, found));
      if (options.errors) fmt::print("{}\n", errors_text(*kernel.test, errors_of(stored, kernel, target)));
    } else {
      Json json = check_json(stored.id, kernel, found);
      if (options.errors) json["errors"] = errors_json(*kernel.test, errors_of(stored, kernel, target));
      fmt::print("{}\n", headed("axiscert-check/1", json).dump());
    }
  }
  say_if_nothing(kernel, queries.size(), standings);
  return exit_done;  // whatever it found
}

}  // namespace

void add_check(CLI::App& app, Action& action) {
  auto* command =
      app.add_subcommand("check", "Judge each query of a file: exact and computed answers, and why they differ");
  auto options = std::make_shared<CheckOptions>();
  command->add_option("FILE", options->file, "query file, JSON Lines or CSV; - reads standard input")->required();
  command->add_option("--kernel", options->kernel, "kernel id (default: the first of the test of the file's queries)");
  command->add_option("--target", options->target, "instruction set, or auto")->capture_default_str();
  command->add_option("--precision", options->precision, "precision of a CSV file, which does not state it")
      ->capture_default_str();
  command->add_flag("--errors", options->errors, "also print the errors of the computed sides, in u, exactly");
  add_plugin_seconds(*command);
  add_progress(*command);
  add_format(*command, options->format, {"jsonl"});
  command->callback([&action, options] { action = [options] { return check(*options); }; });
}

}  // namespace axiscert

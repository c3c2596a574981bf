#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "cli/commands.h"
#include "cli/help.h"
#include "cli/shared_options.h"
#include "fuzz/confirm/record.h"
#include "fuzz/queries/family.h"
#include "fuzz/text/json_form.h"
#include "kernel/kernel.h"
#include "kernel/permitted/permissions.h"
#include "kernel/plugin/load.h"
#include "kernel/predicate.h"
#include "kernel/registry/called.h"
#include "plans/predicate_options.h"
#include "reports/instrument/lists.h"

namespace axiscert {
namespace {

std::vector<Precision> precisions_of(const ArithmeticInfo& arithmetic) {
  std::vector<Precision> all;
  if (arithmetic.in_binary32) all.push_back(Precision::binary32);
  if (arithmetic.in_binary64) all.push_back(Precision::binary64);
  return all;
}

std::vector<Precision> precisions_of(const Kernel& kernel) {
  std::vector<Precision> all;
  for (const Precision precision : {Precision::binary32, Precision::binary64}) {
    if (kernel.has(precision)) all.push_back(precision);
  }
  return all;
}

// The names of enumerators.
template <class Enum>
std::vector<std::string_view> words_of(const std::vector<Enum>& all) {
  std::vector<std::string_view> words;
  for (const Enum one : all) words.push_back(name(one));
  return words;
}

// The built-in kernels of a predicate.
std::vector<const Kernel*> built_in_kernels(const Predicate& predicate) {
  std::vector<const Kernel*> all;
  for (const Kernel& kernel : kernels()) {
    if (kernel.predicate == &predicate) all.push_back(&kernel);
  }
  return all;
}

// The plug-ins of a predicate that come with axiscert, by their ids.
std::vector<const Kernel*> shipped_kernels(const Predicate& predicate) {
  std::vector<const Kernel*> all;
  for (const plugin::ShippedPlugins& shipped : plugin::shipped_plugins()) {
    if (shipped.predicate != &predicate) continue;
    for (const std::string& name : shipped.names) all.push_back(&find_kernel(shipped.prefix + name));
  }
  return all;
}

void print_kernel(const Kernel& kernel, const std::string& targets) {
  fmt::print("{:<20} {}; {}; {}; exposes {}{}\n", kernel.id, kernel.summary,
             fmt::join(words_of(precisions_of(kernel)), " "), targets, fmt::join(words_of(exposures_of(kernel)), ", "),
             kernel.may_decline ? "; may decline" : "");
}

// A plug-in runs on no target of axiscert's.
const char* how_run(const Kernel& kernel) { return plugin::is_program(kernel) ? "program" : "plug-in"; }

void print_arithmetics() {
  fmt::print(
      "\nKERNEL+ARITHMETIC, for each kernel from published to ladder-9, is its scalar form in another arithmetic:\n");
  for (const ArithmeticInfo& arithmetic : arithmetics()) {
    fmt::print("{:<20} {}; {}\n", "+" + arithmetic.name, arithmetic.summary,
               fmt::join(words_of(precisions_of(arithmetic)), " "));
  }
  fmt::print(
      "\nKERNEL+PART-misses and KERNEL+PART-invents, of sums and products alone, separate and touch where any "
      "evaluation "
      "does that PART permits; binary32:\n");
  for (const permitted::Part& part : permitted::parts)
    fmt::print("{:<20} {}\n", fmt::format("+{}-", part.name), part.summary);
}

void print_kernels(const Predicate& predicate) {
  const auto targets = available_targets();
  for (const Kernel* kernel : built_in_kernels(predicate)) {
    print_kernel(*kernel, kernel->has_simd ? fmt::format("{}", fmt::join(targets, " ")) : std::string(scalar_target));
  }
  const auto is_rung = [&](const Kernel& kernel) {
    return kernel.predicate == &predicate && kernel.takes_arithmetic && predicate.claims_arithmetic;
  };
  if (std::any_of(kernels().begin(), kernels().end(), is_rung)) print_arithmetics();
  fmt::print(
      "\nKERNEL@CALL[,CALL...], for each of the above, is the kernel on a chosen instruction set ({}), or called in "
      "other "
      "floating-point modes:\n",
      fmt::join(targets, ", "));
  for (const CallMode& mode : call_modes()) fmt::print("{:<20} {}\n", fmt::format("@{}", mode.name), mode.summary);
  fmt::print(
      "\nPlug-ins: plugin:PATH.so is one of your own, program:MANIFEST.json a program; peer/ are libraries, fault/ "
      "kernels with a planted fault:\n");
  for (const Kernel* kernel : shipped_kernels(predicate)) print_kernel(*kernel, how_run(*kernel));
  for (const plugin::ShippedPlugins& shipped : plugin::shipped_plugins()) {
    if (shipped.predicate != &predicate) continue;
    for (const auto& absent : shipped.absent) {
      const std::string id = fmt::format("{}{}", shipped.prefix, absent.name);
      if (!absent.command.empty()) {
        fmt::print("{:<20} NOT INSTALLED: {} is missing; {} installs it\n", id, absent.package, absent.command);
        continue;
      }
      fmt::print("{:<20} NOT BUILT: the Debian package {} is missing\n", id, absent.package);
    }
  }
}

// As what is run as a plug-in has none.
std::vector<std::string> targets_of(const Kernel& kernel) {
  if (!kernel.file.empty()) return {};
  return kernel.has_simd ? available_targets() : std::vector{std::string(scalar_target)};
}

void print_one(const Kernel& kernel) {
  print_kernel(kernel, kernel.file.empty() ? fmt::format("{}", fmt::join(targets_of(kernel), " ")) : how_run(kernel));
  fmt::print("{:<20} predicate {}, entry {}\n", "", kernel.predicate->id, kernel.predicate->entries[kernel.entry].name);
  if (kernel.measure_count != 0) {
    std::vector<std::string_view> names;
    for (std::size_t k = 0; k < kernel.measure_count; ++k) names.push_back(kernel.predicate->measures[k].name);
    fmt::print("{:<20} measures {}\n", "", fmt::join(names, " "));
  }
  if (kernel.limits.sides != SidesPolicy::both) fmt::print("{:<20} sides {}\n", "", name(kernel.limits.sides));
  if (kernel.limits.margin != 0) fmt::print("{:<20} margin {}\n", "", kernel.limits.margin);
  if (kernel.motion != MotionPolicy{}) {
    fmt::print("{:<20} of motions: start {}, still {}, sides {}\n", "", start_policy_names[kernel.motion.start],
               still_policy_names[kernel.motion.still], sides_policy_names[kernel.motion.sides]);
  }
  if (!kernel.source.empty()) fmt::print("{:<20} source {}\n", "", kernel.source);
  for (const Finding& finding : kernel.findings) fmt::print("{:<20} {}: {}\n", "", name(finding.kind), finding.detail);
}

// A kernel that takes other arithmetics is listed with their ids.
ListedKernel listed_kernel(const Kernel& kernel) {
  const std::vector<std::string> targets = targets_of(kernel);
  ListedKernel listed{.id = kernel.id,
                      .summary = kernel.summary,
                      .predicate = kernel.predicate->id,
                      .entry = kernel.predicate->entries[kernel.entry].name,
                      .formulae = kernel.predicate->claims_arithmetic ? kernel.formulae : std::string(),
                      .precisions = precisions_of(kernel),
                      .targets = {targets.begin(), targets.end()},
                      .exposes = exposures_of(kernel),
                      .may_decline = kernel.may_decline,
                      .source = {},
                      .findings = finding_rows(kernel.findings),
                      .arithmetics = {},
                      .measures = {},
                      .motion = {}};
  if (!kernel.source.empty()) listed.source = Name(kernel.source);
  for (const ArithmeticInfo& arithmetic : arithmetics()) {
    if (!kernel.takes_arithmetic) break;
    listed.arithmetics.push_back(
        {kernel.id + "+" + arithmetic.name, arithmetic.name, arithmetic.summary, precisions_of(arithmetic)});
  }
  if (!kernel.predicate->measures.empty()) listed.measures = given_measures(kernel);
  if (is_of_motions(*kernel.predicate)) listed.motion = policy_of(kernel.motion);
  return listed;
}

int list_kernels(const std::string& format, const std::vector<std::string>& ids, const std::string& predicate_id) {
  std::vector<const Kernel*> listed;
  for (const std::string& id : ids) listed.push_back(&find_kernel(id));
  const Predicate& predicate = predicate_given(predicate_id);
  if (!predicate_id.empty()) predicate_of_kernels(predicate_id, listed);
  if (format == "text") {
    for (const Kernel* kernel : listed) print_one(*kernel);
    if (ids.empty()) print_kernels(predicate);
    return exit_done;
  }
  if (ids.empty()) {
    listed = built_in_kernels(predicate);
    for (const Kernel* kernel : shipped_kernels(predicate)) listed.push_back(kernel);
  }
  KernelsData data;
  for (const Kernel* kernel : listed) data.kernels.push_back(listed_kernel(*kernel));
  fmt::print("{}", data_text(json_of(data), format));
  return exit_done;
}

}  // namespace

void add_kernels(CLI::App& app, Action& action) {
  auto* command =
      app.add_subcommand("kernels", "List the kernels, their precisions, instruction sets and what they expose");
  auto format = std::make_shared<std::string>("text");
  add_format(*command, *format, data_formats);
  auto ids = std::make_shared<std::vector<std::string>>();
  add_kernels(*command, *ids, "list this kernel alone, with its predicate and where its source is");
  auto predicate = std::make_shared<std::string>();
  add_predicate(*command, *predicate, "predicate whose kernels are listed", std::string(default_predicate().id));
  add_examples(*command, {{"All of the usual predicate", "axiscert kernels"},
                          {"Two, with their predicate and entry", "axiscert kernels published certified"},
                          {"For a program", "axiscert kernels --format json"}});
  command->callback([&action, format, ids, predicate] {
    action = [format, ids, predicate] { return list_kernels(*format, *ids, *predicate); };
  });
}

namespace {

int print_families(const std::string& format, const Predicate& predicate) {
  FamiliesData data;
  for (const Family* family : all_families_of(predicate)) {
    if (format == "text") {
      fmt::print("{:<12} {}{}{}{}\n", family->name, family->purpose, family->is_by_name ? " [by name]" : "",
                 family->exact_arithmetic ? " [exact_arithmetic]" : "",
                 family->cost > 1 ? fmt::format(" [cost {}]", family->cost) : "");
    }
    data.families.push_back({family->name, family->predicate().id, std::string(family->purpose),
                             static_cast<std::uint64_t>(family->version), family->exact_arithmetic,
                             static_cast<std::uint64_t>(family->cost)});
  }
  if (format != "text") fmt::print("{}", data_text(json_of(data), format));
  return exit_done;
}

}  // namespace

void add_families(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand("families", "List the families of queries and the purpose of each");
  auto format = std::make_shared<std::string>("text");
  add_format(*command, *format, data_formats);
  auto predicate = std::make_shared<std::string>();
  add_predicate(*command, *predicate, "predicate whose families are listed", std::string(default_predicate().id));
  add_examples(*command, {{"All of the usual predicate", "axiscert families"},
                          {"For a spreadsheet", "axiscert families --format csv"}});
  command->callback([&action, format, predicate] {
    action = [format, predicate] { return print_families(*format, predicate_given(*predicate)); };
  });
}

// `axiscert predicates`: the predicates, the numbers that each takes and the answers that it gives.

namespace {

std::vector<Name> kernels_of(const Predicate& predicate) {
  std::vector<Name> ids;
  for (const Kernel& kernel : kernels()) {
    if (kernel.predicate == &predicate) ids.push_back(kernel.id);
  }
  return ids;
}

std::vector<Name> family_names(const Predicate& predicate) {
  std::vector<Name> names;
  for (const Family* family : all_families_of(predicate)) names.emplace_back(family->name);
  return names;
}

// The columns group by group: "ax ay az (coordinate)".
std::vector<std::string> group_texts(const PredicateEntry& entry) {
  std::vector<std::string> texts;
  for (const ColumnGroup& group : groups_of(entry)) {
    std::vector<std::string_view> names;
    for (std::size_t k = 0; k < group.size; ++k) names.push_back(entry.columns[group.first + k].name);
    texts.push_back(fmt::format("{} ({})", fmt::join(names, " "), name(entry.columns[group.first].role)));
  }
  return texts;
}

std::vector<std::string_view> comparisons_of(const Predicate& predicate, const PredicateClause& clause) {
  std::vector<std::string_view> names;
  for (std::size_t i = 0; i < predicate.comparisons.size(); ++i) {
    if (has_bit(clause.comparisons, i)) names.push_back(predicate.comparisons[i].name);
  }
  return names;
}

void print_predicate(const Predicate& predicate) {
  fmt::print("{}: {}; {}\n", predicate.id, predicate.asks, predicate.rule.text);
  for (const PredicateEntry& entry : predicate.entries) {
    fmt::print("  entry {}: {} columns: {}; {}\n", entry.name, entry.columns.size(),
               fmt::join(group_texts(entry), ", "), entry.validity);
  }
  fmt::print("  {} comparisons in {} clauses, each of which holds where all of its comparisons do:\n",
             predicate.comparisons.size(), predicate.clauses.size());
  for (const PredicateClause& clause : predicate.clauses) {
    fmt::print("    {}: {}\n", clause.name, fmt::join(comparisons_of(predicate, clause), " "));
  }
  if (predicate.measures.empty()) fmt::print("  measures: none\n");
  for (const PredicateMeasure& measure : predicate.measures) {
    fmt::print("  measure {}: {}; {}\n", measure.name, measure.unit, measure.error);
  }
  fmt::print("  touching: {}\n", predicate.touching);
  for (const WrongAnswer& wrong : predicate.wrong_answers) {
    fmt::print("  {}: {} said, {} right\n", wrong.name, name(wrong.said), name(wrong.right));
  }
  fmt::print("  {} kernels, {} families\n", kernels_of(predicate).size(), all_families_of(predicate).size());
}

ListedEntry listed_entry(const PredicateEntry& entry) {
  ListedEntry listed{entry.name, entry.validity, {}};
  for (const PredicateColumn& column : entry.columns)
    listed.columns.push_back({column.name, column.role, std::string(column.group)});
  return listed;
}

ListedPredicate listed_predicate(const Predicate& predicate) {
  ListedPredicate listed{.id = predicate.id,
                         .asks = predicate.asks,
                         .rule = predicate.rule.text,
                         .touching = predicate.touching,
                         .entries = {},
                         .comparisons = {},
                         .clauses = {},
                         .measures = {},
                         .kernels = kernels_of(predicate),
                         .families = family_names(predicate),
                         .wrong_answers = {}};
  for (const PredicateEntry& entry : predicate.entries) listed.entries.push_back(listed_entry(entry));
  for (const PredicateComparison& comparison : predicate.comparisons)
    listed.comparisons.push_back({comparison.name, predicate.clauses[comparison.clause].name});
  for (const PredicateClause& clause : predicate.clauses) {
    const auto comparisons = comparisons_of(predicate, clause);
    listed.clauses.push_back({clause.name, {comparisons.begin(), comparisons.end()}});
  }
  for (const PredicateMeasure& measure : predicate.measures)
    listed.measures.push_back({measure.name, measure.unit, measure.error});
  for (const WrongAnswer& wrong : predicate.wrong_answers)
    listed.wrong_answers.push_back({wrong.name, wrong.said, wrong.right});
  return listed;
}

int list_predicates(const std::string& format, const std::string& id) {
  std::vector<const Predicate*> listed{predicates().begin(), predicates().end()};
  if (!id.empty()) listed = {&predicate_given(id)};
  if (format == "text") {
    for (const Predicate* predicate : listed) print_predicate(*predicate);
    return exit_done;
  }
  PredicatesData data;
  for (const Predicate* predicate : listed) data.predicates.push_back(listed_predicate(*predicate));
  fmt::print("{}", data_text(json_of(data), format));
  return exit_done;
}

}  // namespace

void add_predicates(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand("predicates", "List the predicates: columns, comparisons, clauses, measures");
  auto format = std::make_shared<std::string>("text");
  add_format(*command, *format, data_formats);
  auto predicate = std::make_shared<std::string>();
  add_predicate(*command, *predicate, "the one predicate that is listed", "all");
  add_examples(*command, {{"All", "axiscert predicates"},
                          {"One", "axiscert predicates --predicate box-box"},
                          {"For a program", "axiscert predicates --format json"}});
  command->callback(
      [&action, format, predicate] { action = [format, predicate] { return list_predicates(*format, *predicate); }; });
}

}  // namespace axiscert

#include "reports/wording/reproduce.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <set>

#include "fuzz/queries/source.h"
#include "kernel/base/error.h"
#include "kernel/predicate.h"
#include "reports/wording/depths.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

// Bytes that no report can hold unchanged, written as numbers: a form that bash, zsh and ksh read, and POSIX from 2024
// on.
std::string quoted_bytes(const std::string& text) {
  std::string word = "$'";
  for (const unsigned char c : text) {
    if (c == '\'' || c == '\\') word += fmt::format("\\{}", static_cast<char>(c));
    else if (c < 0x20 || c >= 0x7f) word += fmt::format("\\{:03o}", c);
    else word += static_cast<char>(c);
  }
  return word + "'";
}

std::string quoted(const std::string& text) {
  const bool has_control = std::any_of(text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; });
  if (has_control || !is_utf8(text)) return quoted_bytes(text);
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? "'\\''" : std::string(1, c);
  return word + "'";
}

// The option that brings in a family, by its name: a mesh is "mesh/FILE", a query file "queries/FILE", the corpus
// "corpus".
std::string source_option(const std::string& family) {
  if (family == corpus_name) return " --corpus";
  for (const std::string kind : {"mesh", "queries"}) {
    if (family.starts_with(kind + "/"))
      return fmt::format(" --{} {}", kind, shell_word(family.substr(kind.size() + 1)));
  }
  return " --family " + shell_word(family);
}

bool is_of_a_file(const std::string& family) { return family.starts_with("mesh/") || is_query_file(family); }

// The common number of queries of all generated families, if there is one: the value of --trials.
std::optional<std::uint64_t> common_trials(const PlanRecord& plan) {
  std::set<std::uint64_t> counts;
  for (const auto& [family, by_precision] : plan.trials) {
    if (is_query_list(family)) continue;
    for (const auto& [precision, count] : by_precision) counts.insert(count);
  }
  return counts.size() == 1 ? std::optional(*counts.begin()) : std::nullopt;
}

// Where every comparison has a tolerance, the most frequent one is given for all of them, followed by the exceptions.
std::string tolerance_options(const PlanRecord& plan) {
  std::map<std::string, std::size_t> uses;
  for (const auto& [comparison, tolerance] : plan.tolerance) ++uses[tolerance];
  std::string common, options;
  if (!uses.empty() && plan.tolerance.size() == predicate_of(plan).comparisons.size()) {
    common = std::max_element(uses.begin(), uses.end(), [](const auto& x, const auto& y) {
               return x.second < y.second;
             })->first;
    options = " --tolerance " + shell_word(common);
  }
  for (const auto& [comparison, tolerance] : plan.tolerance) {
    if (tolerance != common) options += " --tolerance " + shell_word(comparison + "=" + tolerance);
  }
  return options;
}

std::string require_options(const PlanRecord& plan) {
  std::string options;
  for (const std::string& level : plan.require.levels) options += " --require " + shell_word(level);
  if (!plan.allow_unchecked) return options;
  for (const std::string& level : *plan.allow_unchecked) options += " --allow-unchecked " + shell_word(level);
  return options;
}

std::string joined(const std::vector<Precision>& precisions) {
  std::vector<std::string_view> names;
  for (const Precision precision : precisions) names.push_back(name(precision));
  return fmt::format("{}", fmt::join(names, ", "));
}
std::string joined(const std::vector<Name>& names) { return fmt::format("{}", fmt::join(names, ", ")); }

std::string file_kind(const FileRecord& file) {
  if (file.kind == "mesh") return "mesh";
  if (file.has_queries()) return "query file";
  return file.kind == "plugin" ? "plug-in" : fmt::format("program's {}", file.kind);
}

std::string file_fact(const FileRecord& file) {
  const bool is_mesh = file.kind == "mesh", is_of_kernel = !is_mesh && !file.has_queries();
  if (is_of_kernel && !file.sha256) return file.name + ", which could not be read";
  const auto count = [](std::optional<std::uint64_t> of) { return thousands(of.value_or(0)); };
  std::string contents;
  if (is_mesh) {
    contents = fmt::format(", {} triangles, {} of zero area, {} other primitives skipped", count(file.triangles),
                           count(file.degenerate_triangles), count(file.skipped_primitives));
  } else if (!is_of_kernel) {
    contents = fmt::format(", {} queries", count(file.queries));
  }
  return fmt::format("{}{}; SHA-256 {}", file.name, contents, file.sha256.value_or(""));
}

std::string source_options(const PlanRecord& plan) {
  std::string options;
  for (const std::string& family : plan.families) options += source_option(family);
  if (const auto trials = common_trials(plan)) options += fmt::format(" --trials {}", *trials);
  return options + fmt::format(" --seed {}", plan.seed.value);
}

std::string judge_command(const PlanRecord& plan) {
  const RepliesRecord& replies = *plan.replies;
  std::string command = "axiscert judge";
  if (plan.kernels.front() != "pipe") command += " --as " + shell_word(plan.kernels.front());
  if (replies.conforms_to) command += " --conforms-to " + shell_word(*replies.conforms_to);
  if (replies.formulae) command += " --formulae " + shell_word(*replies.formulae);
  if (replies.touching != TouchingPolicy::contact) command += fmt::format(" --touching {}", name(replies.touching));
  if (replies.sides) command += fmt::format(" --sides {}", name(*replies.sides));
  if (replies.margin) command += fmt::format(" --margin {}", *replies.margin);
  if (replies.may_decline) command += " --may-decline";
  return command;
}

// One stream for each precision; through files where there are two.
std::string pipe_command(const PlanRecord& plan) {
  const bool has_two = plan.precisions.size() == 2;
  const std::string measures = plan.replies->measures ? fmt::format(" --measures {}", *plan.replies->measures) : "";
  std::string command, files;
  for (const Precision each : plan.precisions) {
    const std::string_view precision = name(each);
    command += fmt::format("axiscert generate{} --precision {} --binary{} | PROGRAM", source_options(plan), precision,
                           measures);
    command += has_two ? fmt::format(" > {0}.replies && ", precision) : " | ";
    if (has_two) files += fmt::format(" {}.replies", precision);
  }
  command += judge_command(plan) + files;
  command += require_options(plan);
  return command;
}

// The commands that ask one kernel about the query of an address.
std::string replay(const std::string& address, const std::string& family, const std::string& kernel,
                   Precision precision, const PlanRecord& plan) {
  const std::string query = fmt::format("axiscert query {}{} > witness.jsonl && ", quoted(address),
                                        is_of_a_file(family) ? source_option(family) : "");
  if (!plan.replies) return fmt::format("{}axiscert check witness.jsonl --kernel {}", query, shell_word(kernel));
  return fmt::format("{}axiscert generate --queries witness.jsonl --precision {} --binary | PROGRAM | {} --out witness",
                     query, name(precision), judge_command(plan));
}

}  // namespace

std::string shell_word(const std::string& text) {
  const bool needs_no_quotes = !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || std::string_view("-_./:=,").find(static_cast<char>(c)) != std::string_view::npos;
  });
  return needs_no_quotes ? text : quoted(text);
}

std::string replay_command(const WitnessRecord& witness, const PlanRecord& plan) {
  return replay(witness.address, witness.family, witness.kernel, witness.precision, plan);
}
std::string replay_command(const FindingRecord& finding, const PlanRecord& plan) {
  if (!finding.address) return "";
  return replay(*finding.address, finding.family.value(), finding.kernel, finding.precision.value(), plan);
}

std::string compare_command(const std::string& before, const std::string& after) {
  return fmt::format("axiscert compare {} {}", shell_word(before), shell_word(after));
}

std::string run_command(const PlanRecord& plan) {
  if (plan.units_done) return "";
  if (plan.replies) return pipe_command(plan);
  std::string command = "axiscert run";
  for (const std::string& kernel : plan.kernels) command += " --kernel " + shell_word(kernel);
  command += source_options(plan);
  if (plan.precisions.size() == 1) command += fmt::format(" --precision {}", name(plan.precisions.front()));
  command += tolerance_options(plan);
  command += require_options(plan);
  return command;
}

std::vector<std::pair<std::string, std::string>> plan_facts(const Run& run) {
  const PlanRecord& plan = run.record.plan;
  std::vector<std::pair<std::string, std::string>> facts = {{"axiscert", plan.axiscert},
                                                            {"seed", std::to_string(plan.seed.value)},
                                                            {"kernels", joined(plan.kernels)},
                                                            {"precisions", joined(plan.precisions)}};
  for (const FileRecord& file : plan.files) facts.emplace_back(file_kind(file), file_fact(file));
  if (!run.info) return facts;
  const RunInfo& info = *run.info;
  facts.insert(facts.end(), {{"started", info.started},
                             {"took", fmt::format("{:.1f} s", info.seconds)},
                             {"threads", std::to_string(info.threads)},
                             {"processor", info.machine.cpu},
                             {"target requested", info.target.asked},
                             {"target that ran", info.target.dispatched},
                             {"compiler", info.compiler},
                             {"flags", info.flags},
                             {"revision", info.revision}});
  for (const auto& [part, version] : info.versions) {
    if (part != "axiscert") facts.emplace_back(part, version);
  }
  facts.emplace_back("decided a second time", thousands(info.second_opinions) + " queries, by the second oracle");
  std::uint64_t queries = 0;
  for (const CellSpeed& cell : info.throughput) queries += cell.queries;
  facts.emplace_back("verdicts that CGAL decided itself",
                     fmt::format("{} of {}; the others by certain signs", thousands(info.by_cgal), thousands(queries)));
  return facts;
}

std::vector<std::string> not_checked(const Record& record) {
  const PlanRecord& plan = record.plan;
  std::vector<std::string> open = {"Proofs: a run observes; it proves nothing about a kernel."};
  if (plan.tolerance.empty()) {
    open.push_back("Tolerance: none was given (--tolerance), so no comparison's error failed or passed.");
  } else if (const std::size_t all = predicate_of(plan).comparisons.size(); plan.tolerance.size() < all) {
    open.push_back(fmt::format("Tolerance: given for {} of the {} comparisons.", plan.tolerance.size(), all));
  }
  if (plan.replies) {
    open.push_back("Errors of the sides, and critical radii: replies were judged here, which contain neither.");
  }
  if (plan.require.levels.empty())
    open.push_back("Requirement: none was given (--require), so nothing here failed or passed.");
  for (const std::string& id : not_judged(record)) {
    open.push_back(fmt::format("{}: it could not be loaded, so it was not judged. Its findings say why.", id));
  }
  for (const KernelRecord& kernel : record.kernels) {
    const std::string who = fmt::format("{} in {}", kernel.id, name(kernel.precision));
    if (kernel.exposes == std::vector{Exposure::verdict}) {
      open.push_back(fmt::format("Comparisons and axes of {}: it shows only verdicts.", who));
    }
    std::uint64_t outside = 0;
    for (const auto& [family, result] : kernel.families)
      outside += result.verdict.outside_limits.value_or(OutsideTally()).trials;
    if (outside != 0) {
      open.push_back(
          fmt::format("{} queries outside the limits that {} declares: counted separately, outside of any requirement.",
                      thousands(outside), who));
    }
    if (const std::string broken = broken_margin_text(kernel); !broken.empty())
      open.push_back(fmt::format("{} {}.", who, broken));
    std::vector<std::string_view> missing;
    for (const Name& family : plan.families) {
      if (!kernel.families.contains(family)) missing.push_back(family);
    }
    if (!missing.empty())
      open.push_back(fmt::format("Families of the plan without a query for {}: {}.", who, fmt::join(missing, ", ")));
  }
  open.push_back(
      fmt::format("Queries of other kinds than the plan's families make. These are: {}.", joined(plan.families)));
  return open;
}

}  // namespace axiscert

#include "reports/wording/reproduce.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <set>

#include "kernel/test.h"
#include "kernel/base/utf8.h"
#include "reports/wording/finding.h"
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
  if (family == "corpus") return " --corpus";
  for (const std::string kind : {"mesh", "queries"}) {
    if (family.starts_with(kind + "/"))
      return fmt::format(" --{} {}", kind, shell_word(family.substr(kind.size() + 1)));
  }
  return " --family " + shell_word(family);
}

bool is_file(const std::string& family) { return family.starts_with("mesh/") || family.starts_with("queries/"); }

// The common number of queries of all generated families, if there is one: the value of --trials.
std::optional<std::uint64_t> common_trials(const Json& plan) {
  std::set<std::uint64_t> counts;
  for (const auto& [family, by_precision] : plan["trials"].items()) {
    if (family.starts_with("queries/") || family == "corpus") continue;
    for (const Json& count : by_precision) counts.insert(count.get<std::uint64_t>());
  }
  return counts.size() == 1 ? std::optional(*counts.begin()) : std::nullopt;
}

// Where every comparison has a tolerance, the most frequent one is given for all of them, followed by the exceptions.
std::string tolerance_options(const Json& tolerances, const TestDescription& test) {
  std::map<std::string, std::size_t> uses;
  for (const Json& tolerance : tolerances) ++uses[tolerance];
  std::string common, options;
  if (tolerances.size() == test.comparisons.size()) {
    common = std::max_element(uses.begin(), uses.end(), [](const auto& x, const auto& y) {
               return x.second < y.second;
             })->first;
    options = " --tolerance " + shell_word(common);
  }
  for (const auto& [comparison, tolerance] : tolerances.items()) {
    if (tolerance != common) options += " --tolerance " + shell_word(comparison + "=" + tolerance.get<std::string>());
  }
  return options;
}

std::string require_options(const Json& plan) {
  const Json& given = plan["require"];
  std::string options;
  for (const Json& level : given.is_null() || given.is_array() ? given : Json::array({given}))
    options += " --require " + shell_word(level);
  for (const Json& level : plan.value("allow_unchecked", Json::array()))
    options += " --allow-unchecked " + shell_word(level);
  return options;
}

std::string joined(const Json& names) {
  return fmt::format("{}", fmt::join(names.get<std::vector<std::string>>(), ", "));
}

std::string file_kind(const Json& file) {
  if (file["kind"] == "mesh") return "mesh";
  if (file["kind"] == "queries") return "query file";
  return file["kind"] == "plugin" ? "plug-in" : fmt::format("program's {}", file["kind"].get<std::string>());
}

std::string file_fact(const Json& file) {
  const std::string name = file["name"];
  if (file["kind"] != "mesh" && file["kind"] != "queries") {  // of a kernel
    return file["sha256"].is_null() ? name + ", which could not be read"
                                    : fmt::format("{}; SHA-256 {}", name, file["sha256"].get<std::string>());
  }
  const auto count = [&](const char* member) { return thousands(file[member].get<std::uint64_t>()); };
  const std::string contents =
      file["kind"] == "mesh"
          ? fmt::format("{} triangles, {} of zero area, {} other primitives skipped", count("triangles"),
                        count("degenerate_triangles"), count("skipped_primitives"))
          : fmt::format("{} queries", count("queries"));
  return fmt::format("{}, {}; SHA-256 {}", name, contents, file["sha256"].get<std::string>());
}

std::string source_options(const Json& plan) {
  std::string options;
  for (const Json& family : plan["families"]) options += source_option(family);
  if (const auto trials = common_trials(plan)) options += fmt::format(" --trials {}", *trials);
  return options + fmt::format(" --seed {}", plan["seed"].dump());
}

std::string judge_command(const Json& plan) {
  const Json& replies = plan["replies"];
  std::string command = "axiscert judge";
  if (plan["kernels"][0] != "pipe") command += " --as " + shell_word(plan["kernels"][0]);
  if (!replies["conforms_to"].is_null()) command += " --conforms-to " + shell_word(replies["conforms_to"]);
  if (!replies["formulae"].is_null()) command += " --formulae " + shell_word(replies["formulae"]);
  if (replies["touching"] != "contact") command += " --touching " + shell_word(replies["touching"]);
  if (replies["may_decline"].get<bool>()) command += " --may-decline";
  return command;
}

// One stream for each precision; through files where there are two.
std::string pipe_command(const Json& plan) {
  const bool has_two = plan["precisions"].size() == 2;
  const Json& replies = plan["replies"];
  const std::string measures =
      replies.contains("measures") ? fmt::format(" --measures {}", replies["measures"].get<std::uint64_t>()) : "";
  std::string command, files;
  for (const std::string precision : plan["precisions"]) {
    command += fmt::format("axiscert generate{} --precision {} --binary{} | PROGRAM", source_options(plan), precision,
                           measures);
    command += has_two ? fmt::format(" > {0}.replies && ", precision) : " | ";
    if (has_two) files += fmt::format(" {}.replies", precision);
  }
  command += judge_command(plan) + files;
  command += require_options(plan);
  return command;
}

}  // namespace

std::string shell_word(const std::string& text) {
  const bool is_plain = !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || std::string_view("-_./:=,").find(static_cast<char>(c)) != std::string_view::npos;
  });
  return is_plain ? text : quoted(text);
}

std::string replay_command(const Json& witness, const Json& plan) {
  const std::string family = witness["family"], kernel = witness["kernel"];
  const std::string query = fmt::format("axiscert query {}{} > witness.jsonl && ", quoted(witness["address"]),
                                        is_file(family) ? source_option(family) : "");
  if (!plan.contains("replies"))
    return fmt::format("{}axiscert check witness.jsonl --kernel {}", query, shell_word(kernel));
  return fmt::format("{}axiscert generate --queries witness.jsonl --precision {} --binary | PROGRAM | {} --out witness",
                     query, witness["precision"].get<std::string>(), judge_command(plan));
}

std::string compare_command(const std::string& before, const std::string& after) {
  return fmt::format("axiscert compare {} {}", shell_word(before), shell_word(after));
}

std::string run_command(const Json& plan) {
  if (!plan["units_done"].is_null()) return "";
  if (plan.contains("replies")) return pipe_command(plan);
  std::string command = "axiscert run";
  for (const Json& kernel : plan["kernels"]) command += " --kernel " + shell_word(kernel);
  command += source_options(plan);
  if (plan["precisions"].size() == 1) command += " --precision " + shell_word(plan["precisions"][0]);
  command += tolerance_options(plan["tolerance"], test_of(plan));
  command += require_options(plan);
  return command;
}

std::vector<std::pair<std::string, std::string>> plan_facts(const Run& run) {
  const Json &plan = run.record["plan"], &info = run.info;
  std::vector<std::pair<std::string, std::string>> facts = {{"axiscert", plan["axiscert"]},
                                                            {"seed", plan["seed"].dump()},
                                                            {"kernels", joined(plan["kernels"])},
                                                            {"precisions", joined(plan["precisions"])}};
  for (const Json& file : plan["files"]) facts.emplace_back(file_kind(file), file_fact(file));
  const auto add = [&](const char* label, const Json& from, const char* member, auto&& text) {
    if (from.contains(member)) facts.emplace_back(label, text(from[member]));
  };
  const auto word = [](const Json& value) { return value.get<std::string>(); };
  if (info.is_null()) return facts;
  add("started", info, "started", word);
  add("took", info, "seconds", [](const Json& s) { return fmt::format("{:.1f} s", s.get<double>()); });
  add("threads", info, "threads", [](const Json& n) { return n.dump(); });
  if (info.contains("machine")) add("processor", info["machine"], "cpu", word);
  if (info.contains("target")) {
    add("target requested", info["target"], "asked", word);
    add("target that ran", info["target"], "dispatched", word);
  }
  add("compiler", info, "compiler", word);
  add("flags", info, "flags", word);
  add("revision", info, "revision", word);
  if (info.contains("versions")) {
    for (const auto& [part, version] : info["versions"].items()) {
      if (part != "axiscert") facts.emplace_back(part, version);
    }
  }
  add("decided a second time", info, "second_opinions",
      [](const Json& n) { return thousands(n.get<std::uint64_t>()) + " queries, by the second oracle"; });
  add("verdicts that CGAL decided itself", info, "decided_by_cgal", [&](const Json& n) {
    std::uint64_t queries = 0;
    for (const Json& cell : info.value("throughput", Json::array())) queries += cell["queries"].get<std::uint64_t>();
    return fmt::format("{} of {}; the others by certain signs", thousands(n.get<std::uint64_t>()), thousands(queries));
  });
  return facts;
}

std::vector<std::string> not_checked(const Json& record) {
  const Json& plan = record["plan"];
  std::vector<std::string> open = {"Proofs: a run observes; it proves nothing about a kernel."};
  if (plan["tolerance"].empty()) {
    open.push_back("Tolerance: none was given (--tolerance), so no comparison's error failed or passed.");
  } else if (const std::size_t all = test_of(plan).comparisons.size(); plan["tolerance"].size() < all) {
    open.push_back(fmt::format("Tolerance: given for {} of the {} comparisons.", plan["tolerance"].size(), all));
  }
  if (plan.contains("replies")) {
    open.push_back("Errors of the sides, and critical radii: replies were judged here, which contain neither.");
  }
  if (plan["require"].is_null())
    open.push_back("Requirement: none was given (--require), so nothing here failed or passed.");
  for (const std::string& id : not_judged(record)) {
    open.push_back(fmt::format("{}: it could not be loaded, so it was not judged. Its findings say why.", id));
  }
  for (const Json& kernel : record["kernels"]) {
    const std::string who =
        fmt::format("{} in {}", kernel["id"].get<std::string>(), kernel["precision"].get<std::string>());
    if (kernel["exposes"] == Json::array({"verdict"})) {
      open.push_back(fmt::format("Comparisons and axes of {}: it shows only verdicts.", who));
    }
    std::uint64_t outside = 0;
    for (const Json& family : kernel["families"]) {
      const Json& counted = family["verdict"]["outside_limits"];
      if (!counted.is_null()) outside += counted["trials"].get<std::uint64_t>();
    }
    if (outside != 0) {
      open.push_back(
          fmt::format("{} queries outside the limits that {} declares: counted separately, outside of any requirement.",
                      thousands(outside), who));
    }
    std::vector<std::string> missing;
    for (const Json& family : plan["families"]) {
      if (!kernel["families"].contains(family)) missing.push_back(family);
    }
    if (!missing.empty())
      open.push_back(fmt::format("Families of the plan without a query for {}: {}.", who, fmt::join(missing, ", ")));
  }
  open.push_back(
      fmt::format("Queries of other kinds than the plan's families make. These are: {}.", joined(plan["families"])));
  return open;
}

}  // namespace axiscert

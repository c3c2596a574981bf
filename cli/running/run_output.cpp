#include "cli/running/run_output.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <fstream>
#include <sstream>

#include "cli/commands.h"
#include "cli/running/terminal.h"
#include "fuzz/files/query_file.h"
#include "kernel/base/error.h"
#include "reports/wording/aligned_table.h"
#include "reports/wording/finding.h"
#include "reports/wording/reproduce.h"
#include "reports/wording/summary.h"

namespace axiscert {

OutputFolder::OutputFolder(const std::string& path) : path_(path) {
  std::error_code problem;
  std::filesystem::create_directories(path_, problem);
  const auto probe = path_ / ".writable";
  if (problem || !std::ofstream(probe)) {
    throw Error(fmt::format("--out {}: cannot write there{}; give a folder that can be made or written", path,
                            problem ? ": " + problem.message() : ""));
  }
  std::filesystem::remove(probe);
}

void OutputFolder::write_text(const std::string& file, const std::string& text) const {
  const auto target = path_ / file, part = path_ / (file + ".part");
  std::ofstream out(part, std::ios::binary);
  out << text;
  out.close();
  if (!out) throw Error(fmt::format("{}: cannot write; is the disk full?", part.string()));
  std::filesystem::rename(part, target);
}

void OutputFolder::remove(const std::string& file) const {
  std::error_code problem;
  std::filesystem::remove(path_ / file, problem);
  if (problem) throw Error(fmt::format("{}: cannot be removed: {}", (path_ / file).string(), problem.message()));
}

void OutputFolder::write(const std::string& file, const Json& json) const { write_text(file, json.dump(1) + "\n"); }

std::string OutputFolder::save(const OracleDisagreement& d) const {
  const auto numbers = [&]<class Real>(Real) {
    Numbers<Real> values(d.query.size());
    std::transform(d.query.begin(), d.query.end(), values.begin(), [](double x) { return static_cast<Real>(x); });
    return values;
  };
  StoredQuery stored{"disagreement", d.precision, numbers(double())};
  if (d.precision == Precision::binary32) stored.numbers = numbers(float());
  write_text("disagreement.jsonl", query_line(stored) + "\n");
  return (path_ / "disagreement.jsonl").string();
}

const std::atomic<bool>& watch_for_interrupts() {
  static std::atomic<bool> interrupted = false;
  const auto on_interrupt = [](int) {
    if (interrupted.exchange(true)) _exit(exit_interrupted);
  };
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);
  return interrupted;
}

std::string iso_time(std::chrono::system_clock::time_point time) {
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::chrono::system_clock::to_time_t(time)));
}

namespace {

// Red where a contact is missed or a query has no answer, yellow where the verdict is wrong in another way, otherwise
// green.
std::string kernels_table(const Json& kernels) {
  std::vector<std::string> columns = {
      "kernel",           "precision", "queries",   "missed contacts",    "deepest",
      "phantom contacts", "deepest",   "no answer", "outside its limits", "wrong there"};
  std::vector<std::vector<std::string>> rows;
  std::vector<TextColour> colours;
  bool has_extra = false;
  for (const Json& kernel : kernels) {
    std::uint64_t trials = 0, missed = 0, phantom = 0, unanswered = 0, outside = 0, outside_wrong = 0;
    double deepest_missed = 0, deepest_phantom = 0;
    for (const Json& family : kernel["families"]) {
      const Json& verdict = family["verdict"];
      trials += family["trials"].get<std::uint64_t>();
      missed += verdict["false_separation"].get<std::uint64_t>();
      phantom += verdict["false_contact"].get<std::uint64_t>();
      unanswered += verdict["unanswered"].get<std::uint64_t>();
      if (const Json& apart = verdict["outside_limits"]; !apart.is_null()) {
        outside += apart["trials"].get<std::uint64_t>();
        outside_wrong += apart["false_separation"].get<std::uint64_t>() + apart["false_contact"].get<std::uint64_t>();
      }
      deepest_missed = std::max(deepest_missed, verdict["deepest_false_separation"].get<double>());
      deepest_phantom = std::max(deepest_phantom, verdict["deepest_false_contact"].get<double>());
    }
    has_extra |= unanswered + outside != 0;
    rows.push_back({kernel["id"], kernel["precision"], thousands(trials), thousands(missed), amount(deepest_missed, 3),
                    thousands(phantom), amount(deepest_phantom, 3), thousands(unanswered), thousands(outside),
                    thousands(outside_wrong)});
    colours.push_back(missed + unanswered != 0 ? TextColour::red
                      : phantom != 0           ? TextColour::yellow
                                               : TextColour::green);
  }
  if (rows.empty()) return "";
  if (!has_extra) {
    columns.resize(7);
    for (auto& row : rows) row.resize(7);
  }
  std::istringstream table(aligned_table(columns, rows));
  std::string text, line;
  std::getline(table, text);
  text += "\n";
  for (std::size_t i = 0; std::getline(table, line); ++i) text += coloured(line, colours[i]) + "\n";
  return text;
}

}  // namespace

std::string summary_text(const Json& record, double seconds) {
  std::string text;
  for (const FindingGroup& group : finding_groups(record)) {
    text += finding_text(*group.first) + "\n";
    if (!group.others.empty()) text += fmt::format("  {}\n", group.others_text());
    if (!(*group.first)["address"].is_null())
      text += fmt::format("  {}\n", replay_command(*group.first, record["plan"]));
  }
  for (const std::string& kernel : not_judged(record))
    text += fmt::format("{}: NOT JUDGED: it could not be loaded\n", kernel);
  text += kernels_table(record["kernels"]);
  text += fmt::format("{}{:.1f} s\n", record["complete"].get<bool>() ? "" : "interrupted; ", seconds);
  return text;
}

}  // namespace axiscert

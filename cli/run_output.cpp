#include "cli/run_output.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <fstream>

#include "cli/commands.h"
#include "fuzz/query_file.h"
#include "kernel/error.h"
#include "reports/finding.h"
#include "reports/reproduce.h"

namespace axiscert {

ProgressLine::ProgressLine() : on_terminal_(isatty(STDERR_FILENO) != 0) {}

ProgressLine::~ProgressLine() {
  if (on_terminal_) fmt::print(stderr, "\r\x1b[K");
}

void ProgressLine::show(const Progress& p) {
  if (!on_terminal_ || p.seconds - last_shown_ < 0.2) return;
  last_shown_ = p.seconds;
  const double rate = static_cast<double>(p.queries) / p.seconds;
  std::string left;
  if (p.units != 0) {
    const double remaining =
        p.seconds * static_cast<double>(p.units - p.units_done) / static_cast<double>(p.units_done);
    left = fmt::format(" of {}, about {:.0f} s left", p.units, remaining);
  }
  fmt::print(stderr, "\r\x1b[K{} units{}; {} queries, {:.0f} a second", p.units_done, left, p.queries, rate);
  std::fflush(stderr);
}

RunFolder::RunFolder(const std::string& path) : path_(path) {
  std::error_code problem;
  std::filesystem::create_directories(path_, problem);
  const auto probe = path_ / ".writable";
  if (problem || !std::ofstream(probe)) {
    throw Error(fmt::format("--out {}: cannot write there{}; give a folder that can be made or written", path,
                            problem ? ": " + problem.message() : ""));
  }
  std::filesystem::remove(probe);
}

void RunFolder::write_text(const std::string& file, const std::string& text) const {
  const auto target = path_ / file, part = path_ / (file + ".part");
  std::ofstream out(part, std::ios::binary);
  out << text;
  out.close();
  if (!out) throw Error(fmt::format("{}: cannot write; is the disk full?", part.string()));
  std::filesystem::rename(part, target);
}

void RunFolder::write(const std::string& file, const Json& json) const { write_text(file, json.dump(1) + "\n"); }

std::string RunFolder::save(const OracleDisagreement& d) const {
  StoredQuery stored{"disagreement", d.precision, from_coordinates(d.query), 0};
  if (d.precision == Precision::binary32) {
    std::array<float, coordinate_count> narrow;
    for (std::size_t i = 0; i < coordinate_count; ++i) narrow[i] = static_cast<float>(d.query[i]);
    stored.query = from_coordinates(narrow);
  }
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
  for (const Json& kernel : record["kernels"]) {
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
    text += fmt::format(
        "{} {}: {} queries; {} missed contacts (deepest {:.3g} of the scene), {} phantom contacts (deepest {:.3g})",
        kernel["id"].get<std::string>(), kernel["precision"].get<std::string>(), trials, missed, deepest_missed,
        phantom, deepest_phantom);
    if (unanswered != 0) text += fmt::format("; {} without an answer", unanswered);
    if (outside != 0)
      text += fmt::format("; {} outside its limits, {} of them wrong, counted apart", outside, outside_wrong);
    text += "\n";
  }
  text += fmt::format("{}{:.1f} s\n", record["complete"].get<bool>() ? "" : "interrupted; ", seconds);
  return text;
}

}  // namespace axiscert

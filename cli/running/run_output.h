// What `axiscert run` shows and writes: the progress line, the run folder, the summary.
#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

#include "exact/judge/truth.h"
#include "fuzz/campaign/campaign.h"
#include "fuzz/confirm/record.h"

namespace axiscert {

// One line on a terminal, rewritten, and cleared when it goes out of scope. Elsewhere nothing, or a line every so
// often.
class ProgressLine {
 public:
  explicit ProgressLine(bool quiet = false, std::optional<double> seconds_between_lines = std::nullopt);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  void show(const Progress& progress, const std::string& more = "");

 private:
  bool on_terminal_;
  std::optional<double> between_lines_;
  double last_shown_ = 0;
};

// The folder of a run. Made, and found writable, before anything runs; a file appears in it whole or not at all.
class OutputFolder {
 public:
  explicit OutputFolder(const std::string& path);  // throws Error
  void write(const std::string& file, const Json& json) const;
  void write_text(const std::string& file, const std::string& text) const;  // whole or not at all
  void remove(const std::string& file) const;                               // where it is there
  // Saves the query that the oracles differ on, and returns the file's path.
  std::string save(const OracleDisagreement& disagreement) const;

 private:
  std::filesystem::path path_;
};

// Set by the first Ctrl-C, at which what is under way finishes and is reported; the second one leaves at once.
const std::atomic<bool>& watch_for_interrupts();

std::string iso_time(std::chrono::system_clock::time_point time);
// What `run` prints in the end: findings first, each with the command that shows it again, then a table, a line a
// kernel and precision; in colour on a terminal.
std::string summary_text(const Json& record, double seconds);

}  // namespace axiscert

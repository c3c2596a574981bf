// Progress on standard error: on a terminal one line that is rewritten, and cleared at the end; elsewhere a line a
// minute. What is done soon says nothing.
#pragma once

#include <CLI/CLI.hpp>

#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

#include "fuzz/campaign/progress.h"

namespace axiscert {

// Adds --progress, the seconds between lines where standard error is no terminal; 0: no progress anywhere.
void add_progress(CLI::App& command);

// The text of a line, for example "3 of 96 units, about 120 s left; 3072 queries, 51 a second".
std::string progress_text(const Progress& progress);

// When lines are written, in seconds.
struct ProgressPace {
  double first, between;
  bool rewritten;  // on a terminal: each takes the place of the one before
};

// Shows how far a computation is for as long as it exists, from a thread of its own: a computation that has nothing to
// report is seen to be alive all the same. All functions may be called from any thread.
class ProgressLine {
 public:
  // `what`: the command, or what is done. Nothing is shown where quiet, or after --progress 0.
  explicit ProgressLine(std::string what, bool quiet = false);
  ProgressLine(std::string what, std::optional<ProgressPace> pace, std::FILE* to);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(const Progress& progress, const std::string& more = "");
  // Names what is under way, where that cannot say how far it is.
  void begin_stage(std::string_view name);
  // Takes the line from the terminal until the next, before something else is written there.
  void clear();
  // For computations that report.
  ShowProgress report() {
    return [this](const Progress& progress) { show(progress); };
  }

 private:
  using Clock = std::chrono::steady_clock;
  void write_lines();
  void write();           // under the lock
  void clear_terminal();  // under the lock

  const std::string what_;
  const std::optional<ProgressPace> pace_;
  std::FILE* const to_;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool ended_ = false, is_on_terminal_ = false;
  std::string stage_, more_;
  std::optional<Progress> last_;
  Clock::time_point taken_, began_;
  std::thread writer_;
};

// Does `work`, which takes a ShowProgress, with its progress on standard error.
template <class Work>
auto with_progress(std::string what, Work&& work) {
  ProgressLine line(std::move(what));
  return work(line.report());
}

}  // namespace axiscert

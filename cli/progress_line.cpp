#include "cli/progress_line.h"

#include <fmt/format.h>
#include <unistd.h>

#include "cli/help.h"
#include "cli/usage.h"

namespace axiscert {
namespace {

double seconds_between_lines = 60;  // --progress

// On a terminal, the first line after one second, for what takes two or more to be seen.
std::optional<ProgressPace> pace_here(bool quiet) {
  if (quiet || seconds_between_lines == 0) return std::nullopt;
  if (isatty(STDERR_FILENO) != 0) return ProgressPace{1, 0.2, true};
  return ProgressPace{seconds_between_lines, seconds_between_lines, false};
}

}  // namespace

void add_progress(CLI::App& command) {
  command
      .add_option("--progress", seconds_between_lines,
                  "seconds between lines of progress where standard error is no terminal; 0: no progress at all")
      ->check(number_between(0, 1e6))
      ->capture_default_str()
      ->group(running_group);
}

std::string progress_text(const Progress& p) {
  std::string text = fmt::format("{} units", p.units_done);
  if (p.units != 0) {
    text = fmt::format("{} of {} units", p.units_done, p.units);
    const auto done = static_cast<double>(p.units_done), left = static_cast<double>(p.units - p.units_done);
    if (p.units_done != 0 && p.units_done < p.units)
      text += fmt::format(", about {:.0f} s left", p.seconds * left / done);
  }
  if (p.queries != 0 && p.seconds > 0)
    text += fmt::format("; {} queries, {:.0f} a second", p.queries, static_cast<double>(p.queries) / p.seconds);
  return text;
}

ProgressLine::ProgressLine(std::string what, bool quiet) : ProgressLine(std::move(what), pace_here(quiet), stderr) {}

ProgressLine::ProgressLine(std::string what, std::optional<ProgressPace> pace, std::FILE* to)
    : what_(std::move(what)), pace_(pace), to_(to), taken_(Clock::now()), began_(taken_) {
  if (pace_) writer_ = std::thread([this] { write_lines(); });
}

ProgressLine::~ProgressLine() {
  if (!pace_) return;
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
  }
  changed_.notify_all();
  writer_.join();
  clear_terminal();
}

void ProgressLine::show(const Progress& progress, const std::string& more) {
  if (!pace_) return;
  const std::lock_guard lock(mutex_);
  last_ = progress;
  stage_ = progress.stage;  // a copy: the text may not outlive the computation
  more_ = more;
  taken_ = Clock::now();
}

void ProgressLine::begin_stage(std::string_view name) {
  if (!pace_) return;
  const std::lock_guard lock(mutex_);
  last_.reset();
  stage_ = name;
  more_.clear();
  taken_ = Clock::now();
}

void ProgressLine::clear() {
  if (!pace_) return;
  const std::lock_guard lock(mutex_);
  clear_terminal();
}

void ProgressLine::write_lines() {
  const auto seconds = [](double count) { return std::chrono::duration<double>(count); };
  std::unique_lock lock(mutex_);
  const auto is_ended = [this] { return ended_; };
  if (changed_.wait_for(lock, seconds(pace_->first), is_ended)) return;
  do write();
  while (!changed_.wait_for(lock, seconds(pace_->between), is_ended));
}

void ProgressLine::write() {
  const auto since = [](Clock::time_point then) { return std::chrono::duration<double>(Clock::now() - then).count(); };
  std::string line = what_;
  if (!stage_.empty()) line += ": " + stage_;
  if (last_) {
    Progress now = *last_;
    now.seconds += since(taken_);
    line += ": " + progress_text(now) + more_;
  }
  line += fmt::format(" ({:.0f} s)", since(began_));
  line = pace_->rewritten ? "\r\x1b[K" + line : fmt::format("axiscert: {}\n", line);
  std::fputs(line.c_str(), to_);  // throws nothing where the stream is closed, unlike fmt::print
  is_on_terminal_ = pace_->rewritten;
  std::fflush(to_);
}

void ProgressLine::clear_terminal() {
  if (!is_on_terminal_) return;
  std::fputs("\r\x1b[K", to_);
  std::fflush(to_);
  is_on_terminal_ = false;
}

}  // namespace axiscert

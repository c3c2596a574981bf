#include "cli/ending.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <deque>

#include "cli/commands.h"
#include "fuzz/text/file_bytes.h"
#include "kernel/base/error.h"
#include "reports/wording/reproduce.h"

namespace axiscert {
namespace {

struct Ending {
  std::vector<std::string> words;
  bool has_kept = false, is_silent = false;
  std::string sentence, command;
  pid_t process = 0;
};
Ending& ending() {
  static Ending one;
  return one;
}

// What a signal handler may read: texts that stay where they are.
std::atomic<const std::string*> text_at_once = nullptr;
std::atomic<bool> is_watched = false, is_interrupted = false;
std::atomic<int> signal_given = 0;

constexpr std::string_view first_text =
    "\naxiscert: interrupted: what is under way is finished and reported; a second interrupt ends at once\n";

void tell(std::string_view text) {
  if (ending().is_silent || getpid() != ending().process) return;  // a child says nothing
  if (isatty(STDERR_FILENO) == 0 && text.starts_with('\n')) text.remove_prefix(1);
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, text.data(), text.size());
}

void on_interrupt(int which) {
  const int before = errno;
  signal_given = which;
  if (!is_watched || is_interrupted.exchange(true)) {
    tell(*text_at_once);
    _exit(128 + which);
  }
  tell(first_text);
  errno = before;
}

std::string how_to_go_on() {
  return fmt::format("axiscert: {}; this {}:\n  {}\n", ending().sentence,
                     ending().has_kept ? "goes on" : "begins it again", ending().command);
}

void set_ending(bool has_kept, const std::string& sentence, const std::string& command) {
  static std::deque<std::string> texts;
  Ending& one = ending();
  one.has_kept = has_kept;
  one.sentence = printable_line(sentence);
  one.command = command;
  texts.push_back(fmt::format("\naxiscert: interrupted\n{}", how_to_go_on()));
  text_at_once = &texts.back();
}

}  // namespace

void begin_command(const std::vector<std::string>& words) {
  ending().words = words;
  ending().process = getpid();
  keep_nothing("it keeps nothing to go on from");
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);
}

const std::atomic<bool>& watch_for_interrupts() {
  is_watched = true;
  return is_interrupted;
}

int interrupted_code() { return signal_given == SIGTERM ? exit_terminated : exit_interrupted; }

std::string own_command(std::string_view option) {
  std::vector<std::string> words = ending().words;
  if (!option.empty() && std::ranges::find(words, option) == words.end()) words.emplace_back(option);
  std::string command = "axiscert";
  for (const std::string& word : words) command += " " + shell_word(word);
  return command;
}

void set_own_option(std::string_view option, const std::string& value) {
  std::vector<std::string>& words = ending().words;
  for (auto word = words.begin(); word != words.end();) {
    const bool is_whole = *word == option;
    if (!is_whole && !word->starts_with(std::string(option) + "=")) {
      ++word;
      continue;
    }
    word = words.erase(word, word + (is_whole && word + 1 != words.end() ? 2 : 1));
  }
  if (!value.empty()) words.insert(words.end(), {std::string(option), value});
}

void keep_work(const std::string& kept, const std::string& command) { set_ending(true, kept, command); }
void keep_nothing(const std::string& why) { set_ending(false, why, own_command()); }
void leave_ending_to_another() { ending().is_silent = true; }

void print_how_to_go_on() { fmt::print(stderr, "{}", how_to_go_on()); }
void print_what_is_kept() {
  if (ending().has_kept) print_how_to_go_on();
}

void finish_output() {
  errno = 0;
  // A reader that left had enough, or says itself why not.
  if ((std::fflush(stdout) != 0 || std::ferror(stdout) != 0) && errno != EPIPE)
    throw Unwritable("standard output", errno, std::nullopt);
}

}  // namespace axiscert

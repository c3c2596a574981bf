#include "kernel/plugin/host/program.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>

#include "kernel/plugin/host/child_process.h"
#include "kernel/plugin/pipe_format.h"
#include "kernel/plugin/shared_memory.h"

namespace axiscert::plugin {
namespace {

constexpr std::chrono::milliseconds farewell{500};        // after its input has ended
constexpr std::chrono::milliseconds end_of_line{100};     // for the rest of what it prints in place of a reply
constexpr double look_share = 0.05;                       // of the time goes into looking at processor time
constexpr std::size_t block_size = std::size_t{1} << 16;  // of a pipe

// In the child: nothing of this process's but the three pipes, and signals as a program expects them.
[[noreturn]] void become(const std::string& folder, const std::vector<std::string>& command, pid_t parent,
                         const int (&ends)[3], int report) {
  setsid();
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (int signal = 1; signal < NSIG; ++signal) std::signal(signal, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  for (int fd = 0; fd < 3; ++fd) dup2(ends[fd], fd);
  const int report_fd = dup2(report, 3);
  fcntl(report_fd, F_SETFD, FD_CLOEXEC);
  close_range(4, ~0u, 0);
  std::vector<char*> words;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  if (getppid() == parent && chdir(folder.c_str()) == 0) execvp(words.front(), words.data());
  const int failed = errno;
  static_cast<void>(!write(report_fd, &failed, sizeof failed));
  _exit(127);
}

void set_non_blocking(int fd) { fcntl(fd, F_SETFL, fcntl(fd, F_GETFL) | O_NONBLOCK); }

void close_end(int& fd) {
  if (fd >= 0) close(fd);
  fd = -1;
}

// The interpreter that the first line of a script names, up to a blank; empty where the file is no script. One found in
// PATH is one that was there to be started.
std::string interpreter_of(const std::string& folder, const std::string& word) {
  if (word.find('/') == word.npos) return "";
  const std::string path = word.front() == '/' ? word : folder + "/" + word;
  std::FILE* const file = std::fopen(path.c_str(), "re");
  if (file == nullptr) return "";
  char line[256];
  const bool is_script = std::fgets(line, sizeof line, file) != nullptr && line[0] == '#' && line[1] == '!';
  std::fclose(file);
  if (!is_script) return "";
  std::string name(line + 2);
  name.erase(0, name.find_first_not_of(" \t"));
  return name.substr(0, name.find_first_of(" \t\r\n"));
}

std::string signal_text(int signal) {
  const char* const abbreviation = sigabbrev_np(signal);  // none for real-time signals
  return abbreviation ? fmt::format("SIG{} ({})", abbreviation, strsignal(signal))
                      : fmt::format("signal {} ({})", signal, strsignal(signal));
}

}  // namespace

Program::Program(std::string folder, std::vector<std::string> command, int asker)
    : folder_(std::move(folder)), command_(std::move(command)), asker_(asker) {}

void Program::close_pipes() {
  for (int* const fd : {&input_, &output_, &errors_}) close_end(*fd);
}

std::optional<Program::Stop> Program::start() {
  const auto failed = [&](int error) {
    const std::string interpreter = error == ENOENT ? interpreter_of(folder_, command_.front()) : "";
    const std::string why = interpreter.empty()
                                ? fmt::format("{}: {}", command_.front(), std::strerror(error))
                                : fmt::format(
                                      "{} begins with #!{}, and that program is not there: install it, or write "
                                      "another first line",
                                      command_.front(), interpreter);
    return Stop{FindingKind::load, fmt::format("it cannot be started: {}", why)};
  };
  int pipes[4][2];  // its input, output and errors; and why it could not be started
  for (std::size_t i = 0; i < 4; ++i) {
    if (pipe2(pipes[i], O_CLOEXEC) == 0) continue;
    const int error = errno;
    for (std::size_t opened = 0; opened < i; ++opened) close(pipes[opened][0]), close(pipes[opened][1]);
    return failed(error);
  }
  const pid_t parent = getpid();
  process_ = fork();
  if (process_ == 0) become(folder_, command_, parent, {pipes[0][0], pipes[1][1], pipes[2][1]}, pipes[3][1]);
  const int no_fork = errno;
  close(pipes[0][0]);
  for (std::size_t i = 1; i < 4; ++i) close(pipes[i][1]);
  input_ = pipes[0][1], output_ = pipes[1][0], errors_ = pipes[2][0];
  int error = 0;
  ssize_t got;
  do got = read(pipes[3][0], &error, sizeof error);  // ends when the command runs
  while (got < 0 && errno == EINTR);
  close(pipes[3][0]);
  if (process_ < 0 || got == sizeof error) {
    error = process_ < 0 ? no_fork : error;
    kill();
    return failed(error);
  }
  for (const int fd : {input_, output_, errors_}) set_non_blocking(fd);
  has_answered_ = false;
  early_.clear();
  said_.clear();
  return std::nullopt;
}

void Program::kill() {
  if (is_running()) status_ = kill_tree(process_);
  process_ = -1;
  if (errors_ >= 0) read_errors();  // what it said before
  close_pipes();
}

void Program::end() {
  close_end(input_);
  const auto until = Clock::now() + farewell;
  while (is_running() && !has_ended() && Clock::now() < until) {
    std::array<char, block_size> block;
    for (const int fd : {output_, errors_}) {
      while (fd >= 0 && read(fd, block.data(), block.size()) > 0 && Clock::now() < until) {
      }
    }
    usleep(1000);
  }
  kill();
}

bool Program::has_ended() const {
  siginfo_t ended{};
  return waitid(P_PID, static_cast<id_t>(process_), &ended, WEXITED | WNOHANG | WNOWAIT) == 0 && ended.si_pid != 0;
}

bool Program::has_ended_well() const { return status_ && WIFEXITED(*status_) && WEXITSTATUS(*status_) == 0; }

void Program::read_errors() {
  std::array<char, block_size> block;
  // A block at a time, so that a program that prints without end is looked at between them.
  const ssize_t got = read(errors_, block.data(), block.size());
  if (got > 0) said_.add(std::span(block).first(static_cast<std::size_t>(got)));
  if (got == 0) close_end(errors_);
}

void Program::read_replies(ReplyReader& replies) {
  std::array<std::byte, block_size> block;
  const ssize_t got = read(output_, block.data(), block.size());
  if (got == 0) close_end(output_);
  if (got <= 0) return;
  const auto bytes = std::span(block).first(static_cast<std::size_t>(got));
  const auto more = bytes.subspan(replies.take(bytes));
  // Looked at with the next batch, as is all that comes later: when it comes is chance.
  if (early_.size() < block_size) early_.insert(early_.end(), more.begin(), more.end());
}

bool Program::is_over(Watch& watch) const {
  const auto now = Clock::now();
  if (now < watch.next_look) return false;
  const double processor = tree_seconds();
  const std::chrono::duration<double> look = Clock::now() - now;
  watch.next_look = now + patience + std::chrono::duration_cast<Clock::duration>(look / look_share);
  if (!watch.processor_begin) {
    watch.processor_begin = processor;
    watch.clock_begin = now;
  }
  const double waited = std::chrono::duration<double>(now - watch.clock_begin).count();
  return processor - *watch.processor_begin >= watch.seconds || waited >= clock_to_processor * watch.seconds;
}

Program::Step Program::step(std::span<const std::byte>& unsent, ReplyReader& replies, Watch& watch) {
  pollfd looked_at[] = {
      {unsent.empty() ? -1 : input_, POLLOUT, 0}, {output_, POLLIN, 0}, {errors_, POLLIN, 0}, {asker_, POLLRDHUP, 0}};
  poll(looked_at, std::size(looked_at), static_cast<int>(patience.count()));
  const bool has_died = has_ended();  // before its pipes are read: then they hold all that it wrote
  if (looked_at[3].revents != 0) {
    kill();
    _exit(0);
  }
  if (looked_at[0].revents != 0) {
    const ssize_t sent = write(input_, unsent.data(), unsent.size());
    if (sent > 0) unsent = unsent.subspan(static_cast<std::size_t>(sent));
    else if (sent < 0 && errno == EPIPE) unsent = {};  // it reads no more: the replies say whether that is right
  }
  if (looked_at[2].revents != 0) read_errors();
  if (looked_at[1].revents != 0) read_replies(replies);
  if (has_died) {
    pollfd rest = {output_, POLLIN, 0};
    while (output_ >= 0 && !replies.is_complete() && poll(&rest, 1, 0) > 0) {
      const std::size_t before = early_.size();
      read_replies(replies);
      if (early_.size() != before || output_ < 0) break;
    }
    return Step::ended;
  }
  return is_over(watch) ? Step::too_long : Step::goes_on;
}

std::string Program::after(const ReplyReader& replies) const {
  return queries_ == 1 ? "" : fmt::format(" after {} of {} replies", replies.count(), queries_);
}

Program::Stop Program::how_it_ended(const ReplyReader& replies) {
  status_.reset();
  kill();
  std::string detail;
  if (!status_) detail = fmt::format("it ended{}", after(replies));
  else if (WIFSIGNALED(*status_)) detail = signal_text(WTERMSIG(*status_)) + after(replies);
  else detail = fmt::format("it ended with exit code {}{}", WEXITSTATUS(*status_), after(replies));
  if (const std::string line = said_.last_line(); !line.empty()) detail += "; on standard error: " + line;
  return {FindingKind::crash, detail};
}

std::optional<Program::Stop> Program::ask(std::span<const std::byte> stream, ReplyReader& replies,
                                          const Limits& limits) {
  std::uint64_t count = 0;
  std::memcpy(&count, stream.data() + offsetof(pipe::Head, count), sizeof count);
  queries_ = static_cast<std::size_t>(count);
  for (;;) {
    if (!is_running()) {
      if (auto stop = start()) return stop;
    }
    replies.restart(has_answered_);
    std::span<const std::byte> unsent = stream;
    Watch watch{has_answered_ ? limits.seconds : limits.start_seconds + limits.seconds, !has_answered_};
    replies.take(early_);
    early_.clear();
    Step last = Step::goes_on;
    while (last == Step::goes_on && !replies.is_faulty() && !(replies.is_complete() && unsent.empty())) {
      if (watch.is_start && replies.has_header()) watch = {limits.seconds, false};
      last = step(unsent, replies, watch);
    }
    if (replies.is_faulty()) {
      for (const auto until = Clock::now() + end_of_line; replies.wants_more() && Clock::now() < until;) {
        std::span<const std::byte> nothing;
        Watch patient{limits.seconds, false};
        if (step(nothing, replies, patient) == Step::ended) break;
      }
      kill();
      return Stop{FindingKind::inconsistent, replies.fault()};
    }
    if (replies.is_complete() && (unsent.empty() || last == Step::ended)) {
      has_answered_ = true;
      return std::nullopt;
    }
    if (last == Step::too_long) {
      const bool is_start = watch.is_start;
      kill();
      return Stop{FindingKind::hang,
                  fmt::format("no answer within {} s{}", watch.seconds, is_start ? " of its start" : "")};
    }
    // A program may end after its last batch, of its own will, and well: then it is started again.
    const bool may_end = has_answered_ && replies.has_nothing();
    const Stop stop = how_it_ended(replies);
    if (!may_end || !has_ended_well()) return stop;
    has_answered_ = false;
  }
}

std::optional<Program::Stop> Program::try_out(std::span<const std::byte> stream, ReplyReader& replies,
                                              double start_seconds) {
  queries_ = 1;  // as one is told of
  kill();
  if (auto stop = start()) return stop;
  std::span<const std::byte> unsent = stream;
  Watch watch{start_seconds, true};
  Step last = Step::goes_on;
  const auto until =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(2 * start_seconds));
  while (last == Step::goes_on && replies.has_nothing() && !replies.is_faulty() && Clock::now() < until) {
    last = step(unsent, replies, watch);
    if (unsent.empty()) close_end(input_);
  }
  if (last != Step::ended || !replies.has_nothing() || replies.is_faulty()) {
    kill();
    return std::nullopt;
  }
  Stop stop = how_it_ended(replies);
  return has_ended_well() ? std::nullopt : std::optional(std::move(stop));
}

}  // namespace axiscert::plugin

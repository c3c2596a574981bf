// Somebody's program, started when it is first asked and again after it has ended, and spoken to by the pipe's format.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "kernel/outcome.h"
#include "kernel/plugin/host/child_process.h"
#include "kernel/plugin/host/reply_reader.h"

namespace axiscert::plugin {

class Program {
 public:
  // `command` is run in the folder. `asker` is the socket of whoever asks: where it closes, the program is killed and
  // this process exits.
  Program(std::string folder, std::vector<std::string> command, int asker);
  ~Program() { kill(); }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  struct Limits {
    double seconds, start_seconds;  // of processor time (Request in kernel/plugin/shared_memory.h)
  };
  // Why there are no answers. The program is then dead.
  struct Stop {
    FindingKind kind;
    std::string detail;
  };
  // Writes `stream`, a header and its queries, and reads the replies. A program that had ended after its last batch, as
  // it may, is started again.
  std::optional<Stop> ask(std::span<const std::byte> stream, ReplyReader& replies, const Limits& limits);
  // Starts it with a stream of no queries, and its input ends there. A stop where it cannot be started, or ends without
  // a byte of output and not in success: it would do so for any queries.
  std::optional<Stop> try_out(std::span<const std::byte> stream, ReplyReader& replies, double start_seconds);

  // Closes its input, lets it end for a moment, and kills what is left.
  void end();
  // Kills it and all that it has started.
  void kill();

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds patience{10};  // between two looks at a program that is silent
  // The time that the program may take until it answers.
  struct Watch {
    double seconds;
    bool is_start;
    std::optional<double> processor_begin = {};
    Clock::time_point clock_begin = {}, next_look = Clock::now() + patience;
  };
  enum class Step { goes_on, ended, too_long };

  bool is_running() const { return process_ > 0; }
  std::optional<Stop> start();
  // Waits for something to happen, and moves bytes.
  Step step(std::span<const std::byte>& unsent, ReplyReader& replies, Watch& watch);
  bool is_over(Watch& watch) const;
  void read_replies(ReplyReader& replies);
  void read_errors();
  bool has_ended() const;
  bool has_ended_well() const;  // after how_it_ended(): of its own will, with exit code 0
  Stop how_it_ended(const ReplyReader& replies);
  // As it is told of a batch.
  std::string after(const ReplyReader& replies) const;
  void close_pipes();

  std::string folder_;
  std::vector<std::string> command_;
  int asker_;
  pid_t process_ = -1;
  int input_ = -1, output_ = -1, errors_ = -1;  // this end of its pipes; -1: closed
  bool has_answered_ = false;                   // a batch, since it was started
  std::size_t queries_ = 0;                     // of the batch under way
  std::vector<std::byte> early_;                // what it wrote after its last reply
  ErrorOutput said_;
  std::optional<int> status_;  // of the last one that has ended
};

}  // namespace axiscert::plugin

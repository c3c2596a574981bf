// Distributes tasks to a crew and to other ranks as they have capacity; results arrive in any order.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "fuzz/campaign/ranks.h"
#include "fuzz/record/run_info.h"

namespace axiscert {
// The threads of one process, each of which runs one task at a time.

// A task is a number whose meaning only the caller knows.
using Task = std::uint64_t;
struct TaskResult {
  Task task;
  std::string bytes;
};

class Crew {
 public:
  using Run = std::function<std::string(Task)>;
  Crew(int threads, Run run);
  // Finishes the tasks under way and begins no others.
  ~Crew();
  Crew(const Crew&) = delete;

  int threads() const { return static_cast<int>(threads_.size()); }
  void give(Task task);
  // The tasks finished since the last call; if there are none, waits for one for at most this long. Rethrows an
  // exception thrown by a task.
  std::vector<TaskResult> take(std::chrono::milliseconds patience);

 private:
  void work();

  Run run_;
  std::mutex mutex_;
  std::condition_variable has_task_, has_result_;
  std::deque<Task> tasks_;
  std::vector<TaskResult> results_;
  std::exception_ptr failure_;
  bool is_over_ = false;
  std::vector<std::thread> threads_;
};

// An exception as bytes: sent by the rank that met it to rank 0, which reports it.

std::string fault_message(const std::exception_ptr& fault);
// Throws the exception that the message was made from: Error, HarnessFault, OracleDisagreement with its query, or a
// std::runtime_error.
[[noreturn]] void rethrow_fault(std::string_view message, int rank);

// Used by rank 0, and by a process without other ranks.
class Distributor {
 public:
  // `ranks` may be null. The arguments must outlive the distributor.
  Distributor(Crew& crew, Ranks* ranks);

  // Hands out the tasks that next() returns until it returns none and all of them are done; `left` returns a lower
  // bound on how many are to come. Both are called between results, from this thread. Rethrows an exception thrown by a
  // task in any rank.
  struct Flow {
    std::function<std::optional<Task>()> next;
    std::function<std::uint64_t()> left;
    std::function<void(TaskResult)> done;
  };
  void run(const Flow& flow);

  // Dismisses the other ranks and returns the use of each; rank 0 is the first. Nothing can be run afterwards.
  std::vector<RankUse> finish();

 private:
  struct Worker {
    RankUse use;
    std::uint64_t under_way = 0;
    bool has_left = false;
  };
  void hand_out(const Flow& flow);
  void receive(const Flow* flow);  // null: the run has failed, and results and faults that still arrive are ignored
  void take(int rank, TaskResult result, const Flow& flow);

  Crew& crew_;
  Ranks* ranks_;
  std::vector<Worker> workers_;  // indexed by rank
  std::uint64_t under_way_ = 0;
};

// Runs in the other ranks: performs the tasks that rank 0 sends until it sends a stop.
void serve(Crew& crew, Ranks& ranks);

}  // namespace axiscert

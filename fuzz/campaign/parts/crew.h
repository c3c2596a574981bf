// The threads of one process, each of which runs one task at a time.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace axiscert {

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

}  // namespace axiscert

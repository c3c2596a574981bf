// How far a long computation is, for whoever shows it. No result depends on it.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string_view>

namespace axiscert {

struct Progress {
  std::uint64_t units_done, units, queries;  // units is 0 where it is not known, as under a time limit
  double seconds;                            // since the stage began
  std::string_view stage = {};               // what is under way, where a computation does one thing after another
};

// Takes progress, from one thread at a time. It has to return soon: others wait.
using ShowProgress = std::function<void(const Progress&)>;

// Counts what any number of threads have done in one stage of a computation, and shows it.
class ProgressCount {
 public:
  ProgressCount(const ShowProgress& show, std::uint64_t units, std::string_view stage = {});
  // Queries of a unit that is still under way. Shown at most ten times a second.
  void add_queries(std::uint64_t queries);
  // A unit, and those of its queries that were not counted by add_queries(). Always shown.
  void finish_unit(std::uint64_t queries = 0);

 private:
  double seconds() const;
  void show();  // under the lock

  const ShowProgress& show_;
  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::mutex mutex_;
  std::uint64_t units_done_ = 0;
  const std::uint64_t units_;
  const std::string_view stage_;
  std::atomic<std::uint64_t> queries_ = 0;
  std::atomic<double> shown_at_ = 0;
};

}  // namespace axiscert

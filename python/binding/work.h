// Work that takes long, done without the interpreter's lock, with progress and interrupts as Python has them.
#pragma once

#include <atomic>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "fuzz/campaign/progress.h"
#include "python/binding/callables.h"
#include "python/binding/common.h"

namespace axiscert::python {

struct Stopped {};

// Where the work is under way, and how it is told to stop.
class Watch {
 public:
  const std::atomic<bool>& interrupted() const { return interrupted_; }
  ShowProgress show() {
    return [this](const Progress& progress) { take(progress); };
  }
  // For work that looks at no flag: the next progress ends it, by an exception that only do_watched() sees.
  ShowProgress show_or_stop() {
    return [this](const Progress& progress) {
      if (interrupted_) throw Stopped();
      take(progress);
    };
  }
  void interrupt() { interrupted_ = true; }
  void begin_stage(std::string_view name);
  void take(const Progress& progress);

 private:
  friend class WatchedThread;
  std::atomic<bool> interrupted_ = false, is_done_ = false;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<Progress> last_;
  std::string stage_;
  bool is_new_ = false;
};

// Gives back what MPFR keeps for this thread, at the end of one that may have computed.
struct ThreadCaches {
  ~ThreadCaches();
};

// Does `work` in a thread of its own. Meanwhile this one, which holds the lock on entry and on return, looks for
// signals, and calls `shown.progress` (units done, units, queries, seconds, stage) unless it or `shown` is None. After
// one that raises, as KeyboardInterrupt, the work is told to stop and ends as it does then; what was raised is
// returned. After a second one `shown.callables` fail until the work has ended. Rethrows what the work threw, and what
// was raised where that stopped it.
std::optional<py::error_already_set> do_watched(const py::object& shown, const std::function<void(Watch&)>& work);

// Interrupts all work that is under way, and waits until it has ended; none begins after it. For the end of the
// interpreter: a thread of work in C++ that comes back to it later, as a daemon thread does, would end the process.
void end_all_work();

// What the work makes, and what was raised.
template <class Made, class Work>
std::pair<Made, std::optional<py::error_already_set>> watched(const py::object& shown, Work&& work) {
  std::optional<Made> made;
  auto raised = do_watched(shown, [&](Watch& watch) { made.emplace(work(watch)); });
  return {std::move(*made), std::move(raised)};
}
// As Python has it: the exception, or None.
inline py::object value_of(const std::optional<py::error_already_set>& raised) {
  return raised ? raised->value() : py::none();
}

// Calls part(first, size) for each block of `size` queries on so many threads (0: all cores), without the lock; stops
// early and raises where a signal does.
void for_each_block(std::size_t size, int threads,
                    const std::function<void(std::size_t first, std::size_t size)>& part);

}  // namespace axiscert::python

#include "python/binding/work.h"

#include <mpfr.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <vector>

#include "kernel/base/error.h"
#include "plans/run_plan.h"

namespace axiscert::python {
namespace {

constexpr auto look_every = std::chrono::milliseconds(50);
constexpr std::size_t block_size = 1024;  // queries

// The work that is under way in any thread.
struct UnderWay {
  std::mutex mutex;
  std::condition_variable changed;
  std::vector<Watch*> watches;
  bool is_ending = false;
  const pid_t process = getpid();  // a fork has none of its threads
};
UnderWay& under_way() {
  static UnderWay all;
  return all;
}

class Counted {
 public:
  explicit Counted(Watch& watch) : watch_(watch) {
    const std::lock_guard lock(under_way().mutex);
    if (under_way().is_ending) throw Error(ending);
    under_way().watches.push_back(&watch_);
  }
  ~Counted() {
    {
      const std::lock_guard lock(under_way().mutex);
      std::erase(under_way().watches, &watch_);
    }
    under_way().changed.notify_all();
  }
  static constexpr const char* ending =
      "the interpreter is ending; wait for the threads that work before the script ends";

 private:
  Watch& watch_;
};

}  // namespace

// Each thread takes the lock once more, to end as after a Ctrl-C: that is only possible before the interpreter ends.
void end_all_work() {
  if (under_way().process != getpid()) return;
  const Unlocked unlocked;
  std::unique_lock lock(under_way().mutex);
  under_way().is_ending = true;
  for (Watch* const watch : under_way().watches) watch->interrupt();
  under_way().changed.wait(lock, [] { return under_way().watches.empty(); });
  is_ended = true;
}

ThreadCaches::~ThreadCaches() { mpfr_free_cache2(MPFR_FREE_LOCAL_CACHE); }

void Watch::begin_stage(std::string_view name) {
  const std::lock_guard lock(mutex_);
  stage_ = name;
  is_new_ = true;
}

void Watch::take(const Progress& progress) {
  const std::lock_guard lock(mutex_);
  last_ = progress;
  if (!progress.stage.empty()) stage_ = progress.stage;
  is_new_ = true;
}

class WatchedThread {
 public:
  WatchedThread(const std::function<void(Watch&)>& work, Watch& watch) : watch_(watch) {
    thread_ = std::jthread([this, &work] {
      const ThreadCaches given_back;
      try {
        work(watch_);
      } catch (const Stopped&) {
        is_stopped_ = true;
      } catch (...) {
        thrown_ = std::current_exception();
      }
      {
        const std::lock_guard lock(watch_.mutex_);
        watch_.is_done_ = true;
      }
      watch_.changed_.notify_all();
    });
  }

  // Without the lock, which the work may wait for.
  ~WatchedThread() {
    if (!thread_.joinable()) return;
    watch_.interrupted_ = true;
    const Unlocked unlocked;
    thread_.join();
  }

  std::optional<py::error_already_set> wait(const py::object& shown) {
    const py::object progress = shown.is_none() ? shown : shown.attr("progress");
    std::vector<std::shared_ptr<Callable>> callables;
    if (!shown.is_none()) callables = shown.attr("callables").cast<std::vector<std::shared_ptr<Callable>>>();
    bool has_given_up = false;
    const auto set_abandoned = [&](bool is_abandoned) {
      for (const auto& callable : callables) callable->is_abandoned() = is_abandoned;
    };
    std::optional<py::error_already_set> raised;
    while (!watch_.is_done_) {
      std::optional<Progress> news;
      std::string stage;
      {
        const Unlocked unlocked;
        std::unique_lock lock(watch_.mutex_);
        watch_.changed_.wait_for(lock, look_every, [&] { return watch_.is_done_.load(); });
        if (watch_.is_new_) news = watch_.last_.value_or(Progress{0, 0, 0, 0});
        stage = watch_.stage_;
        watch_.is_new_ = false;
      }
      try {
        if (PyErr_CheckSignals() != 0) throw py::error_already_set();
        if (news && !progress.is_none() && !raised)
          progress(news->units_done, news->units, news->queries, news->seconds, stage);
      } catch (py::error_already_set& error) {
        if (raised) set_abandoned(has_given_up = true);
        else raised.emplace(error);
        watch_.interrupted_ = true;
      }
    }
    {
      const Unlocked unlocked;
      thread_.join();
    }
    if (has_given_up) set_abandoned(false);
    if (raised && (is_stopped_ || (thrown_ && has_given_up))) throw py::error_already_set(*raised);
    if (thrown_) std::rethrow_exception(thrown_);
    if (is_stopped_) throw Error(Counted::ending);
    return raised;
  }

 private:
  Watch& watch_;
  std::exception_ptr thrown_;
  bool is_stopped_ = false;
  std::jthread thread_;
};

std::optional<py::error_already_set> do_watched(const py::object& shown, const std::function<void(Watch&)>& work) {
  Watch watch;
  const Counted counted(watch);
  WatchedThread thread(work, watch);
  return thread.wait(shown);
}

void for_each_block(std::size_t size, int threads,
                    const std::function<void(std::size_t first, std::size_t size)>& part) {
  const std::size_t blocks = (size + block_size - 1) / block_size;
  const std::size_t workers = std::min<std::size_t>(static_cast<std::size_t>(threads_of(threads)), blocks);
  const auto raised = do_watched(py::none(), [&](Watch& watch) {
    std::atomic<std::size_t> next = 0;
    std::mutex mutex;
    std::exception_ptr thrown;
    const auto do_blocks = [&] {
      try {
        for (std::size_t b = next++; b < blocks && !watch.interrupted(); b = next++)
          part(b * block_size, std::min(block_size, size - b * block_size));
      } catch (...) {
        next = blocks;
        const std::lock_guard lock(mutex);
        if (!thrown) thrown = std::current_exception();
      }
    };
    std::vector<std::jthread> others;
    for (std::size_t w = 1; w < workers; ++w) {
      others.emplace_back([&] {
        const ThreadCaches given_back;
        do_blocks();
      });
    }
    do_blocks();
    others.clear();  // which waits for them
    if (thrown) std::rethrow_exception(thrown);
  });
  if (raised) throw py::error_already_set(*raised);
}

}  // namespace axiscert::python

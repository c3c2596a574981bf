#include "fuzz/campaign/parts/crew.h"

#include <mpfr.h>

#include <utility>

namespace axiscert {
namespace {

// Frees the numbers that MPFR keeps for a thread, which it does not do by itself where the thread ends.
struct ThreadsMpfr {
  ~ThreadsMpfr() { mpfr_free_cache2(MPFR_FREE_LOCAL_CACHE); }
};

}  // namespace

Crew::Crew(int threads, Run run) : run_(std::move(run)) {
  for (int i = 0; i < threads; ++i) threads_.emplace_back([this] { work(); });
}

Crew::~Crew() {
  {
    const std::lock_guard lock(mutex_);
    is_over_ = true;
  }
  has_task_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void Crew::give(Task task) {
  {
    const std::lock_guard lock(mutex_);
    tasks_.push_back(task);
  }
  has_task_.notify_one();
}

std::vector<TaskResult> Crew::take(std::chrono::milliseconds patience) {
  std::unique_lock lock(mutex_);
  has_result_.wait_for(lock, patience, [this] { return failure_ || !results_.empty(); });
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
  return std::exchange(results_, {});
}

void Crew::work() {
  const ThreadsMpfr mpfr;
  std::unique_lock lock(mutex_);
  while (true) {
    has_task_.wait(lock, [this] { return is_over_ || !tasks_.empty(); });
    if (is_over_) return;
    const Task task = tasks_.front();
    tasks_.pop_front();
    lock.unlock();
    TaskResult result{task, {}};
    std::exception_ptr failure;
    try {
      result.bytes = run_(task);
    } catch (...) {
      failure = std::current_exception();
    }
    lock.lock();
    if (failure) failure_ = failure;
    else results_.push_back(std::move(result));
    has_result_.notify_one();
  }
}

}  // namespace axiscert

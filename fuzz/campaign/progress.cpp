#include "fuzz/campaign/progress.h"

namespace axiscert {
namespace {

constexpr double seconds_between_parts = 0.1;

}  // namespace

ProgressCount::ProgressCount(const ShowProgress& show, std::uint64_t units, std::string_view stage)
    : show_(show), units_(units), stage_(stage) {
  const std::lock_guard lock(mutex_);
  this->show();
}

double ProgressCount::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

void ProgressCount::add_queries(std::uint64_t queries) {
  queries_.fetch_add(queries, std::memory_order_relaxed);
  if (seconds() - shown_at_.load(std::memory_order_relaxed) < seconds_between_parts) return;
  const std::unique_lock lock(mutex_, std::try_to_lock);
  if (lock) show();
}

void ProgressCount::finish_unit(std::uint64_t queries) {
  queries_.fetch_add(queries, std::memory_order_relaxed);
  const std::lock_guard lock(mutex_);
  ++units_done_;
  show();
}

void ProgressCount::show() {
  const double now = seconds();
  shown_at_.store(now, std::memory_order_relaxed);
  if (show_) show_({units_done_, units_, queries_.load(std::memory_order_relaxed), now, stage_});
}

}  // namespace axiscert

// Work on a number of threads that the user chooses.
#pragma once

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <optional>

namespace axiscert {

// Calls `work`, whose parallel loops use this many threads; 0: one per core.
template <class Work>
void run_on_threads(int threads, Work&& work) {
  std::optional<tbb::global_control> limit;
  if (threads > 0) limit.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  tbb::task_arena arena(threads > 0 ? threads : tbb::task_arena::automatic);
  arena.execute(work);
}

}  // namespace axiscert

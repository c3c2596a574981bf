// Distributes tasks to a crew and to other ranks as they have capacity; results arrive in any order.
#pragma once

#include <atomic>
#include <optional>

#include "fuzz/campaign/parts/crew.h"
#include "fuzz/campaign/parts/ranks.h"
#include "fuzz/record/run_info.h"

namespace axiscert {

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

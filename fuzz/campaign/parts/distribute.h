// Tasks handed out to a crew and to other ranks, as they have room for them; results in whatever order they come.
#pragma once

#include <atomic>
#include <optional>

#include "fuzz/campaign/parts/crew.h"
#include "fuzz/campaign/parts/ranks.h"

namespace axiscert {

// What one rank did and needed.
struct RankUse {
  int threads = 0;
  std::uint64_t tasks = 0, peak_memory = 0;  // done; bytes
};

// At rank 0, and where there are no others.
class Distributor {
 public:
  // `ranks` may be null. What is borrowed has to outlive it.
  Distributor(Crew& crew, Ranks* ranks);

  // Hands out what next() gives, until that is nothing and all of it is done; `left` says how many are to come, at
  // least. Both are called between results, from this thread. Throws what a task threw, in whatever rank.
  struct Flow {
    std::function<std::optional<Task>()> next;
    std::function<std::uint64_t()> left;
    std::function<void(TaskResult)> done;
  };
  void run(const Flow& flow);

  // Sends the other ranks home, and says what each did; rank 0 is the first. Nothing can be run after it.
  std::vector<RankUse> finish();

 private:
  struct Worker {
    RankUse use;
    std::uint64_t under_way = 0;
    bool has_left = false;
  };
  void hand_out(const Flow& flow);
  void receive(const Flow* flow);  // null: nothing is to come, results and faults are of a run that failed
  void take(int rank, TaskResult result, const Flow& flow);

  Crew& crew_;
  Ranks* ranks_;
  std::vector<Worker> workers_;  // by rank
  std::uint64_t under_way_ = 0;
};

// At the other ranks: does what rank 0 sends, until it says to stop.
void serve(Crew& crew, Ranks& ranks);

}  // namespace axiscert

// The loop of every measurement, and what it judges: batches of queries, the answers of kernels to them, and their
// truths.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_reduce.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "exact/judge/oracles.h"
#include "fuzz/campaign/progress.h"
#include "fuzz/queries/source.h"
#include "kernel/ask.h"
#include "kernel/kernel.h"

namespace axiscert {
// The queries at positions first to first + size - 1 of a source.
struct QueryBlock {
  std::size_t source;
  std::uint64_t first, size;
};

enum class BlockOrder : std::uint8_t {
  by_source,    // all blocks of the first source, then those of the next
  by_position,  // the first block of each source, then the second of each
};

struct JudgedPlan {
  std::vector<SourcePtr> sources;
  std::vector<std::uint64_t> trials;  // of each source
  std::uint64_t seed = 1;
  // One thread does one block, in batches. Each block begins its own kernels: the behaviour of foreign code in one
  // block does not influence another.
  std::uint64_t block_size = 1024, batch_size = 1024;
  BlockOrder order = BlockOrder::by_source;
  std::vector<const Kernel*> kernels = {};
  std::string target = std::string(scalar_target);
  // Whether the word of filters is taken for a truth. The oracles' own is repeated by a second oracle at every position
  // that this divides; 0: at none.
  bool by_filters = false;
  std::uint64_t second_opinion_stride = 1;
  int threads = 0;                                 // 0: one per core
  const std::atomic<bool>* interrupted = nullptr;  // polled between blocks

  std::vector<QueryBlock> blocks() const;
};

// One thread's. What is asked for is found when it is first needed.
template <class Real>
class JudgedBatch {
 public:
  // The block is one of the plan, which has to outlive this.
  JudgedBatch(const JudgedPlan& plan, const QueryBlock& block, ProgressCount& progress);
  // Fills the next batch of the block; false: there is none.
  bool next();

  std::size_t source_index() const { return block_.source; }
  const Source& source() const { return *plan_.sources[block_.source]; }
  const Oracles& oracles() const { return oracles_; }
  const QueryBatch<Real>& queries() const { return queries_; }
  std::size_t size() const { return queries_.size(); }
  Numbers<Real> operator[](std::size_t i) const { return queries_[i]; }
  std::uint64_t position(std::size_t i) const { return first_ + i; }

  const Implementation<Real>& kernel(std::size_t k) const { return kernels_[k].implementation; }
  // The answers of kernel `k`.
  const Reply<Real>& reply(std::size_t k);
  // Throws OracleDisagreement.
  const Truth& truth(std::size_t i);
  Opinion opinion(std::size_t i) const;

  // A query is done: for whoever watches a block of which each takes long.
  void count_progress();
  // Those of the block that were not counted.
  std::uint64_t not_counted() const { return block_.size - counted_; }

 private:
  struct AnsweringKernel {
    Implementation<Real> implementation;
    Reply<Real> reply = {};
    bool has_replied = false;
  };

  const JudgedPlan& plan_;
  const QueryBlock block_;
  ProgressCount& progress_;
  const Oracles& oracles_;
  std::vector<AnsweringKernel> kernels_;
  QueryBatch<Real> queries_;
  std::uint64_t first_, counted_ = 0;
  std::unique_ptr<BatchOracle<Real>> filters_;
  bool is_decided_ = false;
  std::vector<std::optional<Truth>> truths_;
};

// Work on a number of threads that the user chooses.

// Calls `work`, whose parallel loops use this many threads; 0: one per core.
template <class Work>
void run_on_threads(int threads, Work&& work) {
  std::optional<tbb::global_control> limit;
  if (threads > 0) limit.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  tbb::task_arena arena(threads > 0 ? threads : tbb::task_arena::automatic);
  arena.execute(work);
}

// The loop makes a plan's queries, asks kernels, finds truths, and merges what a visitor counts, on threads.

template <class Counts>
struct JudgedCounts {
  Counts counts;
  bool complete = true;  // false: interrupted, and some blocks were left out
};

// Calls visit(batch, counts) for each batch of the plan; `batch` is a JudgedBatch<Real>&. The counts are `none` at
// first, those of several threads, and merge(counts, later) adds those of the blocks that follow at once. So the result
// depends on the plan alone if the counts of two stretches, merged, are those of one visit after the other.
template <class Real, class Counts, class Visit, class Merge>
JudgedCounts<Counts> for_each_judged(const JudgedPlan& plan, const Counts& none, const ShowProgress& report,
                                     std::string_view stage, const Visit& visit, const Merge& merge) {
  const std::vector<QueryBlock> blocks = plan.blocks();
  ProgressCount progress(report, blocks.size(), stage);
  const auto judge = [&](const QueryBlock& block, JudgedCounts<Counts>& found) {
    if (plan.interrupted != nullptr && *plan.interrupted) {
      found.complete = false;
      return progress.finish_unit(block.size);
    }
    JudgedBatch<Real> batch(plan, block, progress);
    while (batch.next()) visit(batch, found.counts);
    progress.finish_unit(batch.not_counted());
  };

  using FoundCounts = std::shared_ptr<JudgedCounts<Counts>>;  // of neighbouring blocks; null: of none
  const auto judge_stretch = [&](const tbb::blocked_range<std::size_t>& range, FoundCounts found) {
    if (!found) found = std::make_shared<JudgedCounts<Counts>>(JudgedCounts<Counts>{none});
    for (std::size_t i = range.begin(); i < range.end(); ++i) judge(blocks[i], *found);
    return found;
  };
  const auto join = [&](FoundCounts found, const FoundCounts& later) {
    if (!found || !later) return found ? found : later;
    merge(found->counts, std::move(later->counts));
    found->complete &= later->complete;
    return found;
  };
  FoundCounts all;
  run_on_threads(plan.threads, [&] {
    const tbb::blocked_range<std::size_t> range(0, blocks.size());
    all = tbb::parallel_reduce(range, FoundCounts(), judge_stretch, join);
  });
  return all ? std::move(*all) : JudgedCounts<Counts>{none};
}

// The same number of trials of each source.
inline JudgedPlan judged_plan(std::vector<SourcePtr> sources, std::uint64_t trials, std::uint64_t seed,
                              std::uint64_t block_size, int threads) {
  JudgedPlan plan;
  plan.trials.assign(sources.size(), trials);
  plan.sources = std::move(sources);
  plan.seed = seed;
  plan.block_size = plan.batch_size = block_size;
  plan.threads = threads;
  return plan;
}

}  // namespace axiscert

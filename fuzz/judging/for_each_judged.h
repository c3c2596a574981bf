// The loop of every measurement: it makes a plan's queries, asks kernels, finds truths, and merges what a visitor
// counts, on threads.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <memory>
#include <string_view>
#include <utility>

#include "fuzz/judging/judged_batch.h"
#include "fuzz/judging/on_threads.h"

namespace axiscert {

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

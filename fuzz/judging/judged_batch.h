// What is judged, and a batch of it: queries, the answers of kernels to them, and their truths.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "exact/trait/oracles.h"
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
  // Of a block of the plan, which has to outlive this.
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

}  // namespace axiscert

#include "fuzz/instruments/for_each_judged.h"

#include <algorithm>

namespace axiscert {

std::vector<QueryBlock> JudgedPlan::blocks() const {
  std::vector<QueryBlock> blocks;
  for (std::size_t source = 0; source < sources.size(); ++source) {
    for (std::uint64_t first = 0; first < trials[source]; first += block_size)
      blocks.push_back({source, first, std::min(block_size, trials[source] - first)});
  }
  if (order == BlockOrder::by_position) std::ranges::stable_sort(blocks, {}, &QueryBlock::first);
  return blocks;
}

template <class Real>
JudgedBatch<Real>::JudgedBatch(const JudgedPlan& plan, const QueryBlock& block, ProgressCount& progress)
    : plan_(plan),
      block_(block),
      progress_(progress),
      oracles_(oracles_of(source().predicate(), source().entry())),
      queries_(static_cast<std::size_t>(std::min(plan.batch_size, block.size)), source().columns().size()),
      first_(block.first) {
  for (const Kernel* kernel : plan.kernels) kernels_.push_back({kernel->on<Real>(plan.target)});
}

template <class Real>
bool JudgedBatch<Real>::next() {
  first_ += queries_.size();
  const std::uint64_t left = block_.first + block_.size - first_;
  if (left == 0) return false;
  source().fill(plan_.seed, first_, static_cast<std::size_t>(std::min(left, plan_.batch_size)), queries_);
  for (AnsweringKernel& kernel : kernels_) kernel.has_replied = false;
  is_decided_ = false;
  truths_.assign(queries_.size(), std::nullopt);
  return true;
}

template <class Real>
const Reply<Real>& JudgedBatch<Real>::reply(std::size_t k) {
  AnsweringKernel& kernel = kernels_[k];
  if (!kernel.has_replied) ask(kernel.implementation, queries_.columns(), kernel.reply);
  kernel.has_replied = true;
  return kernel.reply;
}

template <class Real>
const Truth& JudgedBatch<Real>::truth(std::size_t i) {
  if (truths_[i]) return *truths_[i];
  if (plan_.by_filters) {
    if (!filters_) filters_ = batches_of<Real>(oracles_, plan_.target);
    if (!is_decided_) filters_->decide(queries_);
    is_decided_ = true;
    truths_[i] = filters_->known(i);
  }
  if (!truths_[i]) truths_[i] = oracles_.about(queries_[i], opinion(i))->truth();
  return *truths_[i];
}

template <class Real>
Opinion JudgedBatch<Real>::opinion(std::size_t i) const {
  const std::uint64_t stride = plan_.second_opinion_stride;
  return stride != 0 && position(i) % stride == 0 ? Opinion::second : Opinion::first;
}

template <class Real>
void JudgedBatch<Real>::count_progress() {
  progress_.add_queries(1);
  ++counted_;
}

template class JudgedBatch<float>;
template class JudgedBatch<double>;

}  // namespace axiscert

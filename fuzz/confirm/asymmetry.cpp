#include "fuzz/confirm/asymmetry.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>

#include "exact/trait/oracles.h"
#include "kernel/ask.h"

namespace axiscert {
namespace {

constexpr std::uint64_t batch_bases = 16;  // bases that are asked about at once

template <class Real>
class AsymmetryBlock {
 public:
  AsymmetryBlock(const SeededSource& of, const Kernel& kernel, const StoredReplies* replies, const std::string& target,
                 const ImageGroup& group)
      : of_(of),
        kernel_(kernel),
        replies_(replies),
        group_(group),
        batch_(batch_bases * group.size, of.source.columns().size()) {
    for (std::size_t i = 0; i < group.size; ++i) {
      const bool are_others = i != 0 && has_own_comparisons(group.kind(i));
      of_base_.push_back(are_others ? std::nullopt
                                    : std::optional(ComparisonsOfBase(group.predicate(), group.order(i))));
    }
    if (!replies) implementation_ = kernel.on<Real>(target);
  }

  Asymmetry count(std::uint64_t first_base, std::uint64_t last_base) {
    for (std::uint64_t base = first_base; base < last_base; base += batch_bases) {
      const std::uint64_t bases = std::min(batch_bases, last_base - base);
      of_.source.fill(of_.seed, base * group_.size, static_cast<std::size_t>(bases * group_.size), batch_);
      if (!replies_) ask(implementation_, batch_.columns(), reply_);
      for (std::uint64_t i = 0; i < bases; ++i) count_group((base + i) * group_.size, i * group_.size);
    }
    return found_;
  }

 private:
  std::optional<Outcome> answer(std::uint64_t position, std::size_t in_batch) const {
    const Outcome said = replies_ ? replies_->at(of_.source, precision_of<Real>, position) : reply_.outcome(in_batch);
    if (said.verdict == Verdict::unanswered) return std::nullopt;
    const Numbers<Real> numbers = batch_[in_batch];
    // Numbers that are no query have no motion to promise anything of.
    if (kernel_.motion != MotionPolicy{} && oracles_of(kernel_).truth(numbers).verdict == Verdict::invalid)
      return std::nullopt;
    return is_promised(kernel_, numbers) ? std::optional(said) : std::nullopt;
  }

  void count_group(std::uint64_t position, std::size_t in_batch) {
    queries_.clear();
    verdicts_.clear();
    std::optional<Outcome> base;
    for (std::size_t i = 0; i < group_.size; i += i == 0 ? 1 : group_.parts) {
      const auto image = i == 0 ? answer(position, in_batch) : answer_of_parts(position, in_batch, i);
      if (i == 0) base = image;
      else if (base && image) count_image(*base, *image, {position, position + i}, i);
      const std::size_t parts = i == 0 ? 1 : group_.parts;
      for (std::size_t part = 0; part < parts; ++part) {
        queries_.push_back(batch_[in_batch + i + part]);
        verdicts_.push_back(image && part == 0 ? std::optional(image->verdict) : std::nullopt);
      }
    }
    count_invariance<Real>(found_.invariance, {group_, position, queries_, verdicts_});
  }

  // The verdict of image i: separated where every part is, and in contact where any is.
  std::optional<Outcome> answer_of_parts(std::uint64_t position, std::size_t in_batch, std::size_t i) const {
    std::optional<Outcome> all;
    for (std::size_t part = i; part < i + group_.parts; ++part) {
      const std::optional<Outcome> one = answer(position + part, in_batch + part);
      if (!one) return std::nullopt;
      const bool decides = one->verdict == Verdict::contact ||
                           (one->verdict != Verdict::separated && all && all->verdict == Verdict::separated);
      if (!all || decides) all = one;
    }
    return all;
  }

  void count_image(const Outcome& base, const Outcome& image, const ImagePair& pair, std::size_t i) {
    if (!decides_image(group_.kind(i), base.verdict)) return;
    ++found_.images;
    if (image.verdict != base.verdict) {
      ++found_.verdicts;
      if (!found_.first_verdict) found_.first_verdict = pair;
    }
    if (image.bits && base.bits && of_base_[i] && (*of_base_[i])(*image.bits) != *base.bits) {
      ++found_.comparisons;
      if (!found_.first_comparison) found_.first_comparison = pair;
    }
  }

  const SeededSource& of_;
  const Kernel& kernel_;
  const StoredReplies* replies_;  // null: the kernel is asked
  const ImageGroup& group_;
  Implementation<Real> implementation_;
  QueryBatch<Real> batch_;
  Reply<Real> reply_;
  std::vector<std::optional<ComparisonsOfBase>> of_base_;  // by image; empty where comparisons are not compared
  std::vector<Numbers<Real>> queries_;                     // of the group at hand
  std::vector<std::optional<Verdict>> verdicts_;
  Asymmetry found_;
};

}  // namespace

std::optional<Asymmetry> asymmetry_of(const SeededSource& of, std::uint64_t queries, const Kernel& kernel,
                                      const StoredReplies* replies, const RunningOptions& running) {
  const ImageGroup* group = image_group(of.source.name());
  if (!group || !kernel.has(of.precision)) return std::nullopt;
  const std::uint64_t bases = std::min(queries, asymmetry_queries) / group->size;
  // Blocks as long as a unit of a run: foreign code is begun anew for each, and may hang in each.
  const std::uint64_t block_bases = unit_size / group->size;
  std::vector<Asymmetry> blocks((bases + block_bases - 1) / block_bases);
  const auto count = [&](std::size_t block) {
    const std::uint64_t first = block * block_bases, last = std::min(bases, first + block_bases);
    blocks[block] = of.precision == Precision::binary32
                        ? AsymmetryBlock<float>(of, kernel, replies, running.target, *group).count(first, last)
                        : AsymmetryBlock<double>(of, kernel, replies, running.target, *group).count(first, last);
  };
  tbb::task_arena arena(running.threads);
  arena.execute([&] { tbb::parallel_for(std::size_t{0}, blocks.size(), count); });
  Asymmetry all;
  for (const Asymmetry& block : blocks) {
    all.images += block.images;
    all.verdicts += block.verdicts;
    all.comparisons += block.comparisons;
    if (!all.first_verdict) all.first_verdict = block.first_verdict;
    if (!all.first_comparison) all.first_comparison = block.first_comparison;
    all.invariance.merge(block.invariance);
  }
  if (replies) return all;
  for (auto* flips : {&all.invariance.units.small, &all.invariance.units.large}) {
    narrow(of, kernel, running.target, *flips);
  }
  return all;
}

}  // namespace axiscert

// One kernel at work on the batches of one unit.
#pragma once

#include <deque>

#include "fuzz/campaign/campaign.h"
#include "fuzz/campaign/stages/close_look.h"
#include "fuzz/campaign/stages/stages.h"
#include "kernel/ask.h"

namespace axiscert {

// A plug-in is a process, begun with the unit: what it does depends on the unit alone, and not on what the thread did
// before. The arguments of the constructor have to outlive the object, which does not move.
template <class Real>
class KernelRun {
 public:
  KernelRun(const Kernel& kernel, const Plan& plan, const Source& source, const Standing& standing, Tally& tally);
  KernelRun(const KernelRun&) = delete;

  const Kernel& kernel() const { return kernel_; }
  const Implementation<Real>& implementation() const { return implementation_; }
  const Standing& standing() const { return standing_; }
  Tally& tally() const { return tally_; }
  bool is_in_another_process() const { return implementation_.supervised != nullptr; }
  bool has_replies() const { return replies_ != nullptr; }

  // Asks the kernel; where the plan has stored replies, they are its answers.
  void ask_about(const MadeBatch<Real>& batch);

  // These are about the batch asked last.
  std::uint64_t position(std::size_t i) const { return position_ + i; }
  const Reply<Real>& reply() const { return reply_; }
  Answer answer(std::size_t i) const;
  bool is_answered(std::size_t i) const { return reply_.verdicts[i] != Verdict::unanswered; }
  bool shows_sides() const { return kernel_.exposes == Exposure::sides && reply_.has_bits; }

  // Judges the answer to query `i` by its oracles and counts it, but for the errors of its sides.
  struct Judged {
    bool is_counted = false;  // false: outside the kernel's limits
    std::optional<Reference> chain = {};
    Judgement judgement = {};
  };
  Judged judge(std::size_t i, CloseLook<Real>& look);

 private:
  const Kernel& kernel_;
  const Source& source_;
  const StoredReplies* replies_;  // null: the kernel itself is asked
  const Standing& standing_;
  Tally& tally_;
  Implementation<Real> implementation_;
  std::uint64_t position_ = 0;  // of the batch's first query
  Reply<Real> reply_;
};

template <class Real>
using KernelRuns = std::deque<KernelRun<Real>>;

}  // namespace axiscert

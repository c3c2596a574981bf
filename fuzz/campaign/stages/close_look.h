// One query of a batch, looked at closely: what its oracles say, for all kernels of the unit.
#pragma once

#include <memory>
#include <span>

#include "exact/trait/oracles.h"
#include "fuzz/campaign/counts/motion_tally.h"

namespace axiscert {

template <class Real>
class CloseLook {
 public:
  // `asked` is about `numbers`; all have to outlive this.
  CloseLook(const Oracles& oracles, const Numbers<Real>& numbers, AskedQuery& asked)
      : oracles_(oracles), numbers_(numbers), asked_(asked), truth_(asked.truth()) {}

  const Truth& truth() const { return truth_; }
  bool is_valid() const { return truth_.verdict != Verdict::invalid; }
  DepthOf& depth() { return asked_.depth(); }
  // Empty without a claim or a truth.
  std::optional<Reference> chain(const Kernel& kernel) { return is_valid() ? asked_.chain(kernel) : std::nullopt; }
  bool is_promised_by(const Kernel& kernel) const {
    return !is_valid() || is_promised(oracles_, kernel.limits, kernel.motion, numbers_);
  }

  // Counts what the answer says of a motion, where the query has contact and touching is contact for the kernel.
  void count_motion(const Kernel& kernel, std::uint64_t position, Verdict said, std::span<const double> measures,
                    MotionTally& tally) {
    const bool is_contact = right_verdict(truth_, kernel.touching) == Verdict::contact;
    const bool is_hit = said == Verdict::contact;
    if (!is_contact || (!is_hit && said != Verdict::separated)) return;
    if (!motion_judge_) motion_judge_ = oracles_.motion_judge(numbers_);
    if (is_hit) count_hit(tally, position, motion_judge_->hit(measures));
    else count_missed(tally, position, motion_judge_->missed());
  }

 private:
  const Oracles& oracles_;
  const Numbers<Real>& numbers_;
  AskedQuery& asked_;
  Truth truth_;
  std::unique_ptr<MotionJudge> motion_judge_;
};

}  // namespace axiscert

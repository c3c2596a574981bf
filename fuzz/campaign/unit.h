// The parts of a unit: a kernel at work on its batches, a query looked at closely for it, and the screen between.
#pragma once

#include <deque>
#include <memory>
#include <span>
#include <vector>

#include "exact/judge/oracles.h"
#include "fuzz/campaign/campaign.h"
#include "fuzz/record/contact_tally.h"
#include "kernel/ask.h"

namespace axiscert {

// Queries as their source made them.
template <class Real>
struct MadeBatch {
  const QueryBatch<Real>& queries;
  std::uint64_t position;  // of the first one, in its source

  std::size_t size() const { return queries.size(); }
};

// A query of a batch: what its oracles say, for all kernels of the unit.
template <class Real>
class CloseLook {
 public:
  // `asked` is about `numbers`; all have to outlive this.
  CloseLook(const Oracles& oracles, const Numbers<Real>& numbers, AskedQuery& asked)
      : oracles_(oracles), numbers_(numbers), asked_(asked) {}

  Truth truth() { return asked_.truth(); }
  bool is_valid() { return truth().verdict != Verdict::invalid; }
  DepthOf& depth() { return asked_.depth(); }
  // Empty without a claim or a truth.
  std::optional<Reference> chain(const Kernel& kernel) { return is_valid() ? asked_.chain(kernel) : std::nullopt; }
  bool is_promised_by(const Kernel& kernel) {
    return !is_valid() || is_promised(oracles_, kernel.limits, kernel.motion, numbers_);
  }

 private:
  const Oracles& oracles_;
  const Numbers<Real>& numbers_;
  AskedQuery& asked_;
};

// A valid query of a batch, of which what kernels say beside their verdicts is judged: the judge is made once for all.
template <class Real>
class ContactLook {
 public:
  // All have to outlive this.
  ContactLook(const Oracles& oracles, const Numbers<Real>& numbers) : oracles_(oracles), numbers_(numbers) {}

  // Counts what the answer says beside its verdict, where that is judged; `truth` as has_judged_contact() asks it.
  template <class TruthOf>
  void count(const Kernel& kernel, std::uint64_t position, Verdict said, std::span<const double> measures,
             TruthOf&& truth, ContactTally& tally) {
    if (!has_judged_contact(kernel, said, truth)) return;
    if (!judge_) judge_ = oracles_.contact_judge(numbers_);
    if (!judge_) return;
    judge_->declare_margin(kernel.limits.margin);
    const ContactJudgement judgement = judge_->judge(said, measures);
    count_contact(tally, position, judgement);
    if (!judgement.missed) count_given(tally, position, *kernel.predicate, said, measures);
  }

 private:
  const Oracles& oracles_;
  const Numbers<Real>& numbers_;
  std::unique_ptr<ContactJudge> judge_;
};

// A plug-in is a process, begun with the unit: what it does depends on the unit alone, and not on what the thread did
// before. The arguments of the constructor have to outlive the object, which does not move.
template <class Real>
class KernelRun {
 public:
  // The kernel on a target; where there are stored replies, they are its answers, and it is not asked.
  KernelRun(const Kernel& kernel, const std::string& target, const StoredReplies* replies, const Source& source,
            const StandingLeaders& standing, Tally& tally);
  KernelRun(const KernelRun&) = delete;

  const Kernel& kernel() const { return kernel_; }
  const Implementation<Real>& implementation() const { return implementation_; }
  const StandingLeaders& standing() const { return standing_; }
  Tally& tally() const { return tally_; }
  bool is_in_another_process() const { return implementation_.supervised != nullptr; }
  bool has_replies() const { return replies_ != nullptr; }

  void ask_about(const MadeBatch<Real>& batch);

  // These are about the batch asked last.
  std::uint64_t position(std::size_t i) const { return position_ + i; }
  const Reply<Real>& reply() const { return reply_; }
  Answer answer(std::size_t i) const {
    return replies_ ? replies_->at(source_, precision_of<Real>, position_ + i) : reply_.outcome(i);
  }
  bool is_answered(std::size_t i) const { return reply_.verdicts[i] != Verdict::unanswered; }
  bool shows_sides() const { return kernel_.exposes == Exposure::sides && reply_.has_bits; }

  // Judges the answer to query `i` by its oracles and counts it, but for the errors of its sides.
  struct JudgedAnswer {
    bool is_counted = false;  // false: outside the kernel's limits
    std::optional<Reference> chain = {};
    Judgement judgement = {};
  };
  JudgedAnswer judge(std::size_t i, CloseLook<Real>& look);

  // Whether what it says beside its verdicts is judged.
  bool has_contacts() const { return has_contacts_; }
  // Counts that of query `i`, a valid one within its promises; `truth` as has_judged_contact() asks it.
  template <class TruthOf>
  void count_contact_of(std::size_t i, ContactLook<Real>& look, TruthOf&& truth) {
    look.count(kernel_, position(i), answer(i).verdict, measures(i), truth, tally_.contacts);
  }

  // After the last batch: counts what all of the unit's verdicts show of a kernel that is not built in.
  void finish();

 private:
  const Kernel& kernel_;
  const Source& source_;
  const StoredReplies* replies_;  // null: the kernel itself is asked
  const StandingLeaders& standing_;
  Tally& tally_;
  Implementation<Real> implementation_;
  // The measures with the answer to query `i`.
  std::vector<double> measures(std::size_t i) const;

  bool has_contacts_;
  std::uint64_t position_ = 0;  // of the batch's first query
  Reply<Real> reply_;
};

template <class Real>
using KernelRuns = std::deque<KernelRun<Real>>;

// Screens stand between the kernels' answers to a batch and the oracles. A predicate with filters has a screen that
// judges nearly every answer itself (fuzz/sphere_triangle/screen.h); for all others the oracles are asked about every
// query.

// It is asked about one unit: the batches in the order of their positions, each by these calls in order. Kernel `k` is
// number k of the unit's runs, query `i` of the batch. Throws OracleDisagreement where the oracles contradict a filter.
template <class Real>
class Screen {
 public:
  virtual ~Screen() = default;
  // The queries are made and the kernels asked. Counts the steps that decide; takes its own time.
  virtual void decide(const MadeBatch<Real>& batch) = 0;
  // Counts answers with nothing to see in bulk. The queries of which some kernel's answer is left: the open ones, good
  // until the next batch.
  virtual const std::vector<std::size_t>& count_in_bulk() = 0;
  virtual void look_at_errors() {}
  // Whether kernel k's answer to an open query is judged and counted, now or before; else the oracles judge it.
  virtual bool try_judge(std::size_t, std::size_t) { return false; }
  // Open query `i`, for the oracles. Good until another is asked for.
  virtual AskedQuery& about(std::size_t i) = 0;
  // The oracles have judged kernel k's answer to that query. Counts what is to be seen in its sides.
  virtual void look_at_answer(std::size_t k, std::size_t i, const typename KernelRun<Real>::JudgedAnswer& found) = 0;
  // All of the batch is judged: measures what is measured of a sample alone.
  virtual void sample() {}
  // After the last batch: counts what was put off.
  virtual void finish() {}
};

// What a screen works on; all has to outlive it.
template <class Real>
struct ScreenedRuns {
  const JudgingOptions& judging;
  const std::string& target;  // of the filters
  const Oracles& oracles;
  KernelRuns<Real>& runs;        // not empty
  std::uint64_t first_position;  // of the unit
  StepCounts& steps;
  std::uint64_t& second_opinions;
};

// A capability of a predicate: its screens.
class Screens {
 public:
  virtual std::unique_ptr<Screen<float>> screen(const ScreenedRuns<float>& of) const = 0;
  virtual std::unique_ptr<Screen<double>> screen(const ScreenedRuns<double>& of) const = 0;

 protected:
  ~Screens() = default;
};

// The look at clear queries, of kernels whose wrong verdicts have no links to tell the cause.

// Counts the answers to the clear queries of a batch that the runs were asked last; those of kernels with a reference
// are not counted. Asks no oracle.
template <class Real>
void look_at_clear(const Oracles& oracles, const MadeBatch<Real>& batch, KernelRuns<Real>& runs);

}  // namespace axiscert

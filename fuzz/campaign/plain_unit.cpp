#include "fuzz/campaign/plain_unit.h"

#include <algorithm>
#include <deque>
#include <limits>

#include "exact/trait/oracles.h"
#include "fuzz/campaign/stages/stages.h"
#include "kernel/ask.h"
#include "kernel/base/stopwatch.h"

namespace axiscert {
namespace {

// One query and what its oracles say of it. A claim that several kernels make is evaluated once.
template <class Real>
class ExactQuery final : public DepthOf {
 public:
  // `kernels` are those whose claims will be asked.
  ExactQuery(const Oracles& oracles, const Numbers<Real>& numbers, const std::vector<const Kernel*>& kernels)
      : oracles_(oracles), numbers_(numbers), asked_(oracles.about(numbers)) {
    for (const Kernel* kernel : kernels) asked_->expect(*kernel);
    truth_ = asked_->truth();
  }

  const Truth& truth() const { return truth_; }
  // Null without a claim or a truth.
  const Claimed* claimed(const Kernel& kernel) {
    if (kernel.claims.empty() || truth_.verdict == Verdict::invalid) return nullptr;
    for (const Known& known : known_) {
      if (known.kernel->claims == kernel.claims && known.kernel->is_reference == kernel.is_reference) {
        return &known.claim;
      }
    }
    return &known_.emplace_back(Known{&kernel, *asked_->claimed(kernel)}).claim;
  }

  double at_least() override { return exactly(); }
  double at_most() override { return exactly(); }
  bool is_touching() override { return truth_.touching; }
  // Engine-like is defined of the numbers of a sphere and a triangle.
  double engine_threshold() override { return std::numeric_limits<double>::infinity(); }
  double exactly() override {
    if (truth_.touching) return 0;
    if (!depth_) depth_ = oracles_.depth(numbers_).value_or(0);
    return *depth_;
  }

  bool is_promised_by(const Kernel& kernel) const {
    return truth_.verdict == Verdict::invalid || is_promised(kernel, numbers_);
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
  struct Known {
    const Kernel* kernel;
    Claimed claim;
  };
  const Oracles& oracles_;
  const Numbers<Real> numbers_;
  const std::unique_ptr<AskedQuery> asked_;
  Truth truth_;
  std::deque<Known> known_;
  std::optional<double> depth_;
  std::unique_ptr<MotionJudge> motion_judge_;
};

// One kernel at work on the batches of one unit.
template <class Real>
class PlainRun {
 public:
  PlainRun(const Kernel& kernel, const Plan& plan, const Source& source, const Standing& standing, Tally& tally)
      : kernel_(kernel),
        source_(source),
        replies_(plan.replies.get()),
        tolerances_(plan.tolerances),
        standing_(standing),
        tally_(tally),
        implementation_(kernel.on<Real>(plan.target)) {}

  bool is_in_another_process() const { return implementation_.supervised != nullptr; }

  void ask_about(const MadeBatch<Real>& batch) {
    position_ = batch.position;
    if (replies_) return;
    ask(implementation_, batch.queries.columns(), reply_);
    for (const Finding& finding : reply_.findings) {
      count_finding(tally_, finding.kind, position_ + finding.index, finding.detail);
    }
  }

  void judge(std::size_t i, ExactQuery<Real>& query) {
    const Answer said = replies_ ? replies_->at(source_, precision_of<Real>, position_ + i) : reply_.outcome(i);
    const Claimed* claim = query.claimed(kernel_);
    std::optional<Reference> chain;
    if (claim) chain = claim->chain;
    const Judgement judgement = axiscert::judge(*kernel_.test, query.truth(), chain, said, kernel_.touching);
    if (!query.is_promised_by(kernel_)) return count_outside(tally_, query.truth(), said, judgement, query);
    count(tally_, position_ + i, query.truth(), chain ? chain->ties : ComparisonBits{0}, said, judgement, query,
          standing_);
    if (!kernel_.test->measures.empty()) {
      const std::vector<double> measures =
          replies_ ? replies_->measures(source_, precision_of<Real>, position_ + i) : reply_.measures(i);
      query.count_motion(kernel_, position_ + i, said.verdict, measures, tally_.motion);
    }
    const bool has_sides = !replies_ && kernel_.exposes == Exposure::sides && reply_.has_bits;
    if (!has_sides || said.verdict == Verdict::unanswered || !claim || !claim->sides) return;
    count_errors(tally_, position_ + i, *kernel_.test, *claim->sides, reply_.answers, i, tolerances_);
  }

 private:
  const Kernel& kernel_;
  const Source& source_;
  const StoredReplies* replies_;  // null: the kernel itself is asked
  const Tolerances& tolerances_;
  const Standing& standing_;
  Tally& tally_;
  Implementation<Real> implementation_;
  std::uint64_t position_ = 0;  // of the batch's first query
  Reply<Real> reply_;
};

template <class Real>
void run_plain(const Plan& plan, const Source& source, std::uint64_t first, std::uint64_t size,
               const std::vector<Standing>& standing, UnitResult& out) {
  static const Standing nothing;
  std::deque<PlainRun<Real>> runs;
  std::vector<const Kernel*> kernels;
  for (std::size_t k = 0; k < plan.kernels.size(); ++k) {
    const Kernel& kernel = *plan.kernels[k];
    if (!kernel.has(precision_of<Real>) || kernel.entry != source.entry()) continue;
    kernels.push_back(&kernel);
    runs.emplace_back(kernel, plan, source, standing.empty() ? nothing : standing[k], out.tallies[k]);
  }
  if (runs.empty()) return;
  const Oracles& oracles = oracles_of(*plan.test, source.entry());
  const bool any_process = std::any_of(runs.begin(), runs.end(), [](auto& run) { return run.is_in_another_process(); });
  const std::size_t most = any_process ? batch_size_for_processes : batch_size;
  QueryBatch<Real> queries(most, source.columns().size());
  StepCounts& steps = out.steps;
  for (std::uint64_t done = 0; done < size; done += queries.size()) {
    Stopwatch watch;
    source.fill(plan.seed, first + done, static_cast<std::size_t>(std::min<std::uint64_t>(most, size - done)), queries);
    const MadeBatch<Real> made{queries, first + done};
    steps.generation += watch.lap();
    for (PlainRun<Real>& run : runs) run.ask_about(made);
    steps.kernels += watch.lap();
    for (std::size_t i = 0; i < queries.size(); ++i) {
      ExactQuery<Real> query(oracles, queries[i], kernels);
      for (PlainRun<Real>& run : runs) run.judge(i, query);
    }
    steps.queries[Step::exact] += queries.size();
    steps.judging += watch.lap();
  }
}

}  // namespace

void run_plain_unit(const Plan& plan, const Source& source, Precision precision, std::uint64_t first,
                    std::uint64_t size, const std::vector<Standing>& standing, UnitResult& out) {
  if (precision == Precision::binary32) run_plain<float>(plan, source, first, size, standing, out);
  else run_plain<double>(plan, source, first, size, standing, out);
}

}  // namespace axiscert

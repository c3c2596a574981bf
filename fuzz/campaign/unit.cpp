#include "fuzz/campaign/unit.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

#include <cfenv>

#include <algorithm>
#include <deque>

#include "exact/sphere_triangle/oracles/exact_truth.h"
#include "exact/sphere_triangle/filters/decided_check.h"
#include "kernel/base/stopwatch.h"
#include "fuzz/campaign/runner.h"
#include "fuzz/campaign/thread_seconds.h"

namespace axiscert {
namespace {

// Another process is asked seldom.
constexpr std::size_t batch_size_for_processes = 1024;

// The fault that is planted in the mode and not in the filter.
class StaleRounding {
 public:
  explicit StaleRounding(bool is_planted) : before_(std::fegetround()) {
    if (is_planted) std::fesetround(FE_UPWARD);
  }
  ~StaleRounding() { std::fesetround(before_); }

 private:
  int before_;
};

void require_ieee_modes() {
#if defined(__x86_64__)
  // The vector unit's own register: rounding in bits 13 and 14, flush to zero 15, denormals are zero 6.
  const bool is_ieee = (_mm_getcsr() & 0xe040u) == 0;
#else
  const bool is_ieee = true;
#endif
  if (is_ieee && std::fegetround() == FE_TONEAREST) return;
  throw HarnessFault(
      "the rounding mode is not to nearest, or subnormals are flushed: something left it so, and no filter "
      "is certain");
}

// One unit in one precision: batch by batch generated, asked of every kernel, its signs decided, and judged.
template <class Real>
class UnitRun {
 public:
  UnitRun(const Plan& plan, const Source& source, std::uint64_t first, const std::vector<Standing>& standing,
          UnitResult& out)
      : plan_(plan),
        source_(source),
        out_(out),
        filter_(filter_on<Real>(plan.target, plan.planted)),
        cascade_(filter_) {
    static const Standing nothing;
    for (std::size_t k = 0; k < plan.kernels.size(); ++k) {
      if (!plan.kernels[k]->has(precision_of<Real>)) continue;
      runners_.emplace_back(*plan.kernels[k], plan, filter_, standing.empty() ? nothing : standing[k], first,
                            out.tallies[k]);
      if (runners_.back().is_in_another_process()) batch_size_ = batch_size_for_processes;
    }
  }

  void run(std::uint64_t first, std::uint64_t size) {
    if (runners_.empty()) return;
    for (std::uint64_t done = 0; done < size; done += batch_.size()) {
      first_ = first + done;
      run_batch(static_cast<std::size_t>(std::min<std::uint64_t>(batch_size_, size - done)));
    }
    for (Runner<Real>& runner : runners_) runner.finish();
    for (const Step step : {Step::lanes, Step::grid, Step::wide, Step::integers}) {
      out_.steps.steps[static_cast<std::size_t>(step)] = cascade_.nanoseconds(step);
    }
  }

 private:
  void run_batch(std::size_t size) {
    Stopwatch watch;
    source_.fill(plan_.seed, first_, size, batch_);
    out_.steps.generation += watch.lap();
    for (Runner<Real>& runner : runners_) {
      runner.begin_batch(first_);
      if (!plan_.replies) runner.ask_about(batch_);
    }
    out_.steps.kernels += watch.lap();
    choose_what_is_exact();
    watch.lap();
    for (Runner<Real>& runner : runners_) {
      if (runner.is_judged_by_signs()) runner.look_at_sides(batch_, attention_, *decided_);
    }
    out_.steps.errors += watch.lap();
    count_plain();
    const Real* radii = batch_.columns().column[coordinate_count - 1];
    for (std::size_t i = 0; i < size; ++i) {
      if (open_[i]) judge_query(i, radii[i] == 0);
    }
    if (!plan_.replies) sample_critical_radii();
    if (has_margins(first_)) measure_margins();
    out_.steps.judging += watch.lap();
  }

  bool is_filtered(std::size_t i) const { return !plan_.exact_only && (*decided_)[i].step != Step::exact; }

  // Exact arithmetic decides what the filters leave, a sample of the rest, and the close calls that they tell of.
  void choose_what_is_exact() {
    const std::size_t size = batch_.size();
    exactly_.assign(size, true);
    attention_.assign(size, Attention::none);
    if (plan_.exact_only) {
      out_.steps.queries[static_cast<std::size_t>(Step::exact)] += size;
      return;
    }
    require_ieee_modes();
    decided_ = &cascade_.decide(batch_);
    std::uint64_t in_lanes = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const DecidedSigns& found = (*decided_)[i];
      if (found.step == Step::lanes) ++in_lanes;
      else count_step(found);
      if (found.step == Step::exact) continue;
      const std::uint64_t stride = found.step == Step::integers ? integer_check_stride : second_opinion_stride;
      const bool is_checked = (first_ + i) % stride == 0 || found.is_close;
      out_.steps.checked += is_checked;
      exactly_[i] = is_checked;
      attention_[i] = is_checked ? Attention::checked : Attention::counted;
    }
    out_.steps.queries[static_cast<std::size_t>(Step::lanes)] += in_lanes;
    for (auto& signs : out_.steps.signs) signs[static_cast<std::size_t>(Step::lanes)] += in_lanes;
  }

  void count_step(const DecidedSigns& found) {
    ++out_.steps.queries[static_cast<std::size_t>(found.step)];
    for (std::size_t k = 0; k < comparison_count; ++k) {
      const bool in_lanes = ((found.certain_in_lanes >> k) & 1u) != 0;
      ++out_.steps.signs[k][static_cast<std::size_t>(in_lanes ? Step::lanes : found.step)];
    }
  }

  // Most queries are counted here and go no further.
  void count_plain() {
    open_.assign(batch_.size(), plan_.exact_only || plan_.replies != nullptr);
    if (open_[0]) return;
    for (Runner<Real>& runner : runners_) {
      if (runner.is_judged_by_signs()) {
        runner.count_plain(batch_.columns(), *decided_, exactly_);
        for (std::size_t i = 0; i < open_.size(); ++i) open_[i] |= static_cast<char>(!runner.has_counted(i));
      } else {
        open_.assign(batch_.size(), true);
      }
    }
  }

  void judge_query(std::size_t i, bool radius_is_zero) {
    for (Runner<Real>& runner : runners_) {
      if (runner.has_counted(i)) continue;
      const Answer answer = answer_of(runner, i);
      const bool by_signs = !exactly_[i] && runner.is_judged_by_signs();
      if (by_signs && runner.count_if_clean(i, (*decided_)[i].signs, radius_is_zero, answer)) continue;
      judge_closely(runner, i, by_signs, answer);
    }
    if (at_hand_) at_hand_.reset();
  }

  Answer answer_of(const Runner<Real>& runner, std::size_t i) const {
    return plan_.replies ? plan_.replies->at(source_, precision_of<Real>, first_ + i) : runner.answer(i);
  }

  [[gnu::noinline]] void judge_closely(Runner<Real>& runner, std::size_t i, bool by_signs, const Answer& answer) {
    if (!at_hand_) at_hand_.emplace(batch_[i], plan_.exact_only);
    auto& [q, distance, truth, claims] = *at_hand_;
    if (by_signs) {
      runner.judge_by_signs(i, q, (*decided_)[i].signs, answer, distance);
      return;
    }
    if (!truth) {
      truth = decide_exactly(i, q);
      if (truth->formula) claims.emplace(q, *truth->formula, plan_.exact_only);
    }
    runner.judge_exactly(i, q, *truth, claims ? &*claims : nullptr, answer, is_filtered(i) && exactly_[i], distance);
  }

  // A query that is looked at closely. What is not asked for is not computed.
  struct AtHand {
    Query<Real> q;
    LazyDistance<Real> distance;
    std::optional<ExactTruth> truth;
    std::optional<Claims<Real>> claims;  // of the truth
    AtHand(const Query<Real>& query, bool exact_only) : q(query), distance(q, exact_only) {}
    AtHand(const AtHand&) = delete;
  };

  ExactTruth decide_exactly(std::size_t i, const Query<Real>& q) {
    const bool second_opinion = (first_ + i) % second_opinion_stride == 0 || plan_.exact_only;
    ExactTruth truth = exact_truth(q, second_opinion);
    if (!truth.formula) return truth;
    out_.second_opinions += second_opinion;
    ++out_.steps.by_cgal;
    if (!is_filtered(i)) return truth;
    require_same((*decided_)[i], truth, q);
    return truth;
  }

  void measure_margins() {
    const auto shows = [](const Runner<Real>& runner) { return runner.shows_comparisons(); };
    if (std::none_of(runners_.begin(), runners_.end(), shows)) return;
    for (std::size_t i = 0; i < batch_.size() && has_margins(first_ + i); ++i) {
      const Query<Real> q = batch_[i];
      if (!is_valid(q)) continue;
      const FormulaTruth published = formula_truth(q);
      Claims<Real> claims(q, published);
      for (Runner<Real>& runner : runners_) runner.measure_margins(q, claims, answer_of(runner, i));
    }
  }

  void sample_critical_radii() {
    for (std::size_t i = 0; i < batch_.size(); ++i) {
      if (!has_critical_radius(first_ + i)) continue;
      const Query<Real> q = batch_[i];
      if (!is_valid(q)) continue;
      LazyDistance<Real> distance(q, plan_.exact_only);
      for (Runner<Real>& runner : runners_) runner.sample(q, i, distance);
    }
  }

  const Plan& plan_;
  const Source& source_;
  UnitResult& out_;
  Filter<Real> filter_;
  Cascade<Real> cascade_;
  std::deque<Runner<Real>> runners_;
  std::size_t batch_size_ = batch_size;
  QueryBatch<Real> batch_{batch_size_for_processes};
  std::uint64_t first_ = 0;  // position of the batch's first query
  const std::vector<DecidedSigns>* decided_ = nullptr;
  std::optional<AtHand> at_hand_;
  std::vector<char> exactly_;         // by query: judged by exact arithmetic
  std::vector<char> open_;            // by query: a kernel's answer is not counted yet
  std::vector<Attention> attention_;  // by query, of the error watches
};

template <class Real>
void run(const Plan& plan, const Source& source, std::uint64_t first, std::uint64_t size,
         const std::vector<Standing>& standing, UnitResult& out) {
  const StaleRounding mode(plan.planted == FilterFault::rounding_mode);
  UnitRun<Real>(plan, source, first, standing, out).run(first, size);
}

}  // namespace

UnitResult run_unit(const Plan& plan, const Source& source, Precision precision, std::uint64_t number,
                    std::uint64_t size, const std::vector<Standing>& standing) {
  UnitResult result{std::vector<Tally>(plan.kernels.size()), 0, 0, {}};
  const double start = thread_seconds();
  const std::uint64_t first = number * unit_size;
  if (precision == Precision::binary32) run<float>(plan, source, first, size, standing, result);
  else run<double>(plan, source, first, size, standing, result);
  result.core_seconds = thread_seconds() - start;
  return result;
}

}  // namespace axiscert

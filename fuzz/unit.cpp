#include "fuzz/unit.h"

#include <ctime>

#include <cmath>

#include "exact/claim.h"
#include "exact/critical_radius.h"
#include "exact/depth.h"
#include "exact/geometric_oracle.h"
#include "exact/limits.h"
#include "kernel/ask.h"

namespace axiscert {
namespace {

constexpr std::size_t batch_size = 1024;

double thread_seconds() {
  std::timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

// A kernel at work on batches of one precision. Somebody else's code is a process, begun with the unit: so what it does
// depends on the unit alone, and not on what the thread did before.
template <class Real>
struct Runner {
  const Kernel& kernel;
  std::size_t place;  // in the plan
  Implementation<Real> implementation;
  RadiusRange<Real> radii;
  Reply<Real> reply;
  // Every 256th query, for its critical radius, and its exact distance.
  std::vector<Query<Real>> sampled;
  std::vector<Real> distances;

  Runner(const Kernel& k, std::size_t place_in_plan, std::string_view target)
      : kernel(k), place(place_in_plan), implementation(k.on<Real>(target)), radii(radii_within<Real>(k.limits)) {}
};

// The exact squared distance of one query, computed when first asked for: few queries need it.
template <class Real>
class LazyDistance {
 public:
  explicit LazyDistance(const Query<Real>& q) : query_(q) {}
  const Rational& squared() {
    if (!squared_) squared_ = squared_distance(query_);
    return *squared_;
  }
  double depth() {
    if (!depth_) depth_ = axiscert::depth(query_, squared());
    return *depth_;
  }
  // Correctly rounded; seldom needs the square.
  Real rounded() {
    if (!rounded_) rounded_ = rounded_distance(query_);
    return *rounded_;
  }

 private:
  const Query<Real>& query_;
  std::optional<Rational> squared_;
  std::optional<double> depth_;
  std::optional<Real> rounded_;
};

// Of a unit's sample at once: a kernel in another process takes longer to ask than to answer.
template <class Real>
void measure_critical_radii(const Runner<Real>& runner, CriticalRadiusTally& tally) {
  const auto critical = critical_radii(runner.implementation, runner.sampled, runner.radii);
  for (std::size_t i = 0; i < critical.size(); ++i) {
    const CriticalRadiusError error = critical_radius_error(critical[i], runner.distances[i]);
    if (!error.answered) ++tally.unanswered;
    else if (std::isfinite(*error.ulps)) tally.errors_ulps.push_back(*error.ulps);
    else ++tally.unbounded;
  }
}

template <class Real>
void judge_query(const Plan& plan, const Source& source, std::vector<Runner<Real>>& runners, std::size_t i,
                 std::uint64_t position, const Query<Real>& q, UnitResult& out) {
  const bool second_opinion = position % second_opinion_stride == 0;
  const Truth truth = exact_truth(q, second_opinion);
  out.second_opinions += second_opinion && truth.formula;
  LazyDistance<Real> distance(q);
  std::optional<Claims<Real>> claims;
  if (truth.formula) claims.emplace(q, *truth.formula);
  for (Runner<Real>& runner : runners) {
    const Kernel& kernel = runner.kernel;
    Tally& tally = out.tallies[runner.place];
    const Answer answer =
        plan.replies ? plan.replies->at(source, precision_of<Real>, position) : runner.reply.outcome(i);
    std::optional<Reference> chain;
    const FormulaTruth* sides = nullptr;
    if (claims) {
      chain = claims->chain(kernel);
      sides = claims->sides(kernel.formulae);
    }
    const Judgement judgement = judge(truth, chain, answer, kernel.touching);
    std::optional<double> depth;
    if (judgement.verdict_flip) depth = distance.depth();
    if (truth.formula && kernel.limits.any() && !is_within(kernel.limits, q)) {
      count_outside(tally, truth, answer, judgement, depth);
      continue;
    }
    count(tally, position, truth, sides, answer, judgement, depth);
    if (!truth.formula || answer.verdict == Verdict::unanswered) continue;
    if (sides && kernel.exposes == Exposure::sides) {
      count_errors(tally, position, *sides, runner.reply.sides(i), plan.tolerances);
    }
    if (position % critical_radius_stride != 0 || plan.replies) continue;
    if (const auto within = rounded_distance_within(distance.rounded(), runner.radii)) {
      runner.sampled.push_back(q);
      runner.distances.push_back(*within);
    }
  }
}

template <class Real>
void run(const Plan& plan, const Source& source, std::uint64_t first, std::uint64_t size, UnitResult& out) {
  std::vector<Runner<Real>> runners;
  for (std::size_t k = 0; k < plan.kernels.size(); ++k) {
    if (plan.kernels[k]->has(precision_of<Real>)) runners.emplace_back(*plan.kernels[k], k, plan.target);
  }
  if (runners.empty()) return;
  QueryBatch<Real> batch(batch_size);
  for (std::uint64_t done = 0; done < size; done += batch.size()) {
    batch.clear();
    while (batch.size() < batch_size && done + batch.size() < size) {
      Query<Real> q;
      source.make(plan.seed, first + done + batch.size(), q);
      batch.push_back(q);
    }
    for (Runner<Real>& runner : runners) {
      if (plan.replies) break;
      ask(runner.implementation, batch.columns(), runner.reply);
      for (const Finding& finding : runner.reply.findings) {
        count_finding(out.tallies[runner.place], finding.kind, first + done + finding.index, finding.detail);
      }
    }
    for (std::size_t i = 0; i < batch.size(); ++i)
      judge_query(plan, source, runners, i, first + done + i, batch[i], out);
  }
  for (const Runner<Real>& runner : runners) {
    measure_critical_radii(runner, out.tallies[runner.place].critical_radius);
  }
}

}  // namespace

UnitResult run_unit(const Plan& plan, const Source& source, Precision precision, std::uint64_t number,
                    std::uint64_t size) {
  UnitResult result{std::vector<Tally>(plan.kernels.size()), 0, 0};
  const double start = thread_seconds();
  if (precision == Precision::binary32) run<float>(plan, source, number * unit_size, size, result);
  else run<double>(plan, source, number * unit_size, size, result);
  result.core_seconds = thread_seconds() - start;
  return result;
}

}  // namespace axiscert

#include "fuzz/unit.h"

#include <ctime>

#include <cmath>

#include "exact/claim.h"
#include "exact/critical_radius.h"
#include "exact/depth.h"
#include "exact/geometric_oracle.h"

namespace axiscert {
namespace {

constexpr std::size_t batch_size = 1024;

double thread_seconds() {
  std::timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

// A kernel at work on batches of one precision.
template <class Real>
struct Runner {
  const Kernel& kernel;
  std::size_t place;  // in the plan
  Implementation<Real> implementation;
  std::vector<Verdict> verdicts;
  Answers<Real> answers;

  Runner(const Kernel& k, std::size_t place_in_plan, std::string_view target)
      : kernel(k), place(place_in_plan), implementation(k.on<Real>(target)), verdicts(batch_size) {
    answers.resize(batch_size);
  }
  void run(const QueryColumns<Real>& batch) {
    implementation.verdicts(batch, verdicts.data());
    if (implementation.explain) implementation.explain(batch, answers);
  }
  Answer answer(std::size_t i) const {
    Answer a{verdicts[i], std::nullopt};
    if (implementation.explain) a.bits = answers.bits[i];
    return a;
  }
  Sides<Real> sides(std::size_t i) const {
    Sides<Real> s;
    for (std::size_t k = 0; k < comparison_count; ++k) {
      s.lhs[k] = answers.lhs[k][i];
      s.rhs[k] = answers.rhs[k][i];
    }
    return s;
  }
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

 private:
  const Query<Real>& query_;
  std::optional<Rational> squared_;
  std::optional<double> depth_;
};

template <class Real>
void judge_query(const Plan& plan, const Source& source, const std::vector<Runner<Real>>& runners, std::size_t i,
                 std::uint64_t position, const Query<Real>& q, UnitResult& out) {
  const bool second_opinion = position % second_opinion_stride == 0;
  const Truth truth = exact_truth(q, second_opinion);
  out.second_opinions += second_opinion && truth.formula;
  LazyDistance<Real> distance(q);
  std::optional<Claims<Real>> claims;
  if (truth.formula) claims.emplace(q, *truth.formula);
  for (const Runner<Real>& runner : runners) {
    const Answer answer = plan.replies ? plan.replies->at(source, precision_of<Real>, position) : runner.answer(i);
    std::optional<Reference> chain;
    const FormulaTruth* sides = nullptr;
    if (claims) {
      chain = claims->chain(runner.kernel);
      sides = claims->sides(runner.kernel.formulae);
    }
    const Judgement judgement = judge(truth, chain, answer);
    std::optional<double> depth;
    if (judgement.verdict_flip) depth = distance.depth();
    count(out.tallies[runner.place], position, truth, sides, answer, judgement, depth);
    if (!truth.formula) continue;
    if (sides && runner.kernel.exposes == Exposure::sides) {
      count_errors(out.tallies[runner.place], position, *sides, runner.sides(i), plan.tolerances);
    }
    if (position % critical_radius_stride == 0 && !plan.replies) {
      const auto error = critical_radius_error(runner.implementation, q, distance.squared());
      CriticalRadiusTally& tally = out.tallies[runner.place].critical_radius;
      if (error && std::isfinite(*error)) tally.errors_ulps.push_back(*error);
      else if (error) ++tally.unbounded;
    }
  }
}

template <class Real>
void run(const Plan& plan, const Source& source, std::uint64_t first, std::uint64_t size, UnitResult& out) {
  std::vector<Runner<Real>> runners;
  for (std::size_t k = 0; k < plan.kernels.size(); ++k) {
    if (plan.kernels[k]->has(precision_of<Real>)) runners.emplace_back(*plan.kernels[k], k, plan.target);
  }
  QueryBatch<Real> batch(batch_size);
  for (std::uint64_t done = 0; done < size; done += batch.size()) {
    batch.clear();
    while (batch.size() < batch_size && done + batch.size() < size) {
      Query<Real> q;
      source.make(plan.seed, first + done + batch.size(), q);
      batch.push_back(q);
    }
    for (Runner<Real>& runner : runners) {
      if (!plan.replies) runner.run(batch.columns());
    }
    for (std::size_t i = 0; i < batch.size(); ++i)
      judge_query(plan, source, runners, i, first + done + i, batch[i], out);
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

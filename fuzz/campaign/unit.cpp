#include "fuzz/campaign/unit.h"

#include <algorithm>
#include <cfenv>

#include "fuzz/campaign/stages/kernel_runs.h"
#include "fuzz/campaign/plain_unit.h"
#include "fuzz/campaign/thread_seconds.h"
#include "kernel/base/stopwatch.h"
#include "kernel/sphere_triangle/description.h"

namespace axiscert {
namespace {

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

// One unit in one precision, batch by batch: made, asked of every kernel, decided, judged.
template <class Real>
void run(const Plan& plan, const Source& source, std::uint64_t first, std::uint64_t size,
         const std::vector<Standing>& standing, const BatchDone& asked, UnitResult& out) {
  const StaleRounding mode(plan.planted == FilterFault::rounding_mode);
  Decider<Real> decider(plan, out.steps, out.second_opinions);
  KernelRuns<Real> kernels(plan, source, decider, standing, first, out.tallies);
  if (kernels.empty()) return;
  const std::size_t most = kernels.any_in_another_process() ? batch_size_for_processes : batch_size;
  QueryBatch<Real> queries(most, source.columns().size());
  StepCounts& steps = out.steps;
  for (std::uint64_t done = 0; done < size; done += queries.size()) {
    Stopwatch watch;
    source.fill(plan.seed, first + done, static_cast<std::size_t>(std::min<std::uint64_t>(most, size - done)), queries);
    const MadeBatch<Real> made{queries, first + done};
    steps.generation += watch.lap();
    AnsweredBatch<Real> answered = kernels.ask(made);
    steps.kernels += watch.lap();
    const DecidedBatch<Real> decided = decider.decide(made);
    watch.lap();  // the filters keep their own time
    WatchedBatch<Real> watched = std::move(answered).look_at_errors(decided);
    steps.errors += watch.lap();
    std::move(watched).judge();
    steps.judging += watch.lap();
    if (asked) asked(queries.size());
  }
  kernels.finish();
  decider.count_times();
}

}  // namespace

UnitResult run_unit(const Plan& plan, const Source& source, Precision precision, std::uint64_t number,
                    std::uint64_t size, const std::vector<Standing>& standing, const BatchDone& asked) {
  UnitResult result{std::vector<Tally>(plan.kernels.size(), Tally(*plan.test)), 0, 0, {}};
  const double start = thread_seconds();
  const std::uint64_t first = number * unit_size;
  if (plan.test != &sphere_triangle_test()) {
    run_plain_unit(plan, source, precision, first, size, standing, result);
    if (asked) asked(size);
  } else if (precision == Precision::binary32) {
    run<float>(plan, source, first, size, standing, asked, result);
  } else {
    run<double>(plan, source, first, size, standing, asked, result);
  }
  result.core_seconds = thread_seconds() - start;
  return result;
}

}  // namespace axiscert

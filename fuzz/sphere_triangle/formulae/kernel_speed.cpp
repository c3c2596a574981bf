#include "fuzz/sphere_triangle/formulae/kernel_speed.h"

#include <algorithm>
#include <chrono>

#include "fuzz/queries/family.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

template <class Real>
struct TimedKernel {
  Implementation<Real> implementation;
  std::vector<double> ns;  // per query, one for each repetition

  void sort() { std::sort(ns.begin(), ns.end()); }
  double median() const { return ns[(ns.size() - 1) / 2]; }
};

template <class Real>
double nanoseconds(const Implementation<Real>& kernel, const QueryColumns<Real>& batch, Verdict* out) {
  if (kernel.timed) return kernel.timed(batch, out);  // excludes the cost of communication with another process
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  kernel.verdicts(batch, out);
  return std::chrono::duration<double, std::nano>(Clock::now() - start).count();
}

}  // namespace

template <class Real>
std::vector<KernelSpeed> measure_speed(const std::vector<const Kernel*>& kernels, int repetitions,
                                       const ShowProgress& report) {
  const std::string best = available_targets().front();
  std::vector<TimedKernel<Real>> scalar, simd;
  for (const Kernel* kernel : kernels) {
    scalar.push_back({kernel->on<Real>(scalar_target), {}});
    simd.push_back({kernel->has_simd && best != scalar_target ? kernel->on<Real>(best) : Implementation<Real>{}, {}});
  }

  const Family& general = find_family("general");
  QueryBatch<Real> batch(speed_queries, coordinate_count);
  for (std::uint64_t position = 0; position < speed_queries; ++position)
    batch.push_back(general.make<Real>(1, position));
  std::vector<Verdict> verdicts(speed_queries);
  const auto time = [&](TimedKernel<Real>& timed) {
    if (!timed.implementation.verdicts) return;
    timed.ns.push_back(nanoseconds(timed.implementation, batch.columns(), verdicts.data()) /
                       static_cast<double>(speed_queries));
  };
  ProgressCount progress(report, static_cast<std::uint64_t>(repetitions) + 1, "times");
  for (int repetition = -1; repetition < repetitions; ++repetition) {
    for (std::size_t k = 0; k < kernels.size(); ++k) {
      time(scalar[k]);
      time(simd[k]);
    }
    progress.finish_unit();
    if (repetition >= 0) continue;
    for (auto* all : {&scalar, &simd}) {  // the first round only loads code and data into the caches
      for (TimedKernel<Real>& timed : *all) timed.ns.clear();
    }
  }

  for (auto* all : {&scalar, &simd}) {
    for (TimedKernel<Real>& timed : *all) timed.sort();
  }
  std::vector<KernelSpeed> speeds;
  for (std::size_t k = 0; k < kernels.size(); ++k) {
    KernelSpeed& speed = speeds.emplace_back(KernelSpeed{scalar[k].median(), scalar[k].ns.front(), std::nullopt});
    if (!simd[k].ns.empty()) speed.best_target = {best, simd[k].median()};
  }
  return speeds;
}
template std::vector<KernelSpeed> measure_speed<float>(const std::vector<const Kernel*>&, int, const ShowProgress&);
template std::vector<KernelSpeed> measure_speed<double>(const std::vector<const Kernel*>&, int, const ShowProgress&);

}  // namespace axiscert

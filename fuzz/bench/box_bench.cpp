// The kernels of two boxes on each target, verdict only, in binary32: nanoseconds per query, and of the same queries
// the contacts that they miss and invent. 4,096 queries of each family, again and again.
#include <benchmark/benchmark.h>

#include <map>

#include "exact/judge/oracles.h"
#include "fuzz/queries/family.h"
#include "kernel/boxes/boxes.h"
#include "kernel/kernel.h"

namespace axiscert {
namespace {

constexpr std::size_t box_queries = std::size_t{1} << 12;

struct JudgedBoxes {
  QueryBatch<float> batch{box_queries, 30};
  std::vector<Verdict> truth;
};
const JudgedBoxes& judged(const std::string& family) {
  static std::map<std::string, JudgedBoxes> known;
  JudgedBoxes& all = known[family];
  if (!all.truth.empty()) return all;
  const Oracles& oracles = oracles_of(box_box_predicate());
  for (std::size_t i = 0; i < box_queries; ++i) {
    const Numbers<float> q = find_family("box-box/" + family).make<float>(1, i);
    all.batch.push_back(q);
    all.truth.push_back(oracles.truth(q).verdict);
  }
  return all;
}

void time_boxes(benchmark::State& state, const std::string& family,
                const std::function<void(const QueryColumns<float>&, Verdict*)>& verdicts) {
  const JudgedBoxes& all = judged(family);
  const auto columns = all.batch.columns();
  std::vector<Verdict> out(box_queries);
  for (auto _ : state) {
    verdicts(columns, out.data());
    benchmark::DoNotOptimize(out.data());
    benchmark::ClobberMemory();
  }
  int missed = 0, phantom = 0;
  for (std::size_t i = 0; i < box_queries; ++i) {
    missed += out[i] == Verdict::separated && all.truth[i] == Verdict::contact;
    phantom += out[i] == Verdict::contact && all.truth[i] == Verdict::separated;
  }
  state.counters["missed"] = missed;
  state.counters["phantom"] = phantom;
  state.counters["per_query"] = benchmark::Counter(
      static_cast<double>(box_queries), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

const bool added_boxes = [] {
  for (const char* family : {"general", "resting", "crossed"}) {
    for (const std::string& target : available_targets()) {
      for (const char* name : {"projected", "textbook", "textbook-early", "gottschalk", "cofactor"}) {
        const Kernel& kernel = find_kernel(std::string("box-box/") + name);
        if (target != scalar_target && !kernel.has_simd) continue;
        benchmark::RegisterBenchmark((kernel.id + "/" + target + "/" + family).c_str(), time_boxes, family,
                                     kernel.on<float>(target).verdicts);
      }
    }
  }
  return true;
}();

}  // namespace
}  // namespace axiscert

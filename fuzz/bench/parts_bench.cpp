// The cost that the journal adds to a unit: compare `unit` with `entry`.
#include <benchmark/benchmark.h>

#include "fuzz/campaign/gathered.h"
#include "fuzz/campaign/journal.h"
#include "fuzz/campaign/stretch_testing.h"
#include "kernel/base/folders.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

const Plan& plan() {
  static const Plan made = [] {
    Plan plan = small_plan({"published"}, {"general"}, unit_size);
    plan.questions.precisions = {Precision::binary32};
    return plan;
  }();
  return made;
}

// 2^16 queries of the cheapest family and precision, begun without knowledge of other units, as in a stretch.
void unit(benchmark::State& state) {
  for (auto _ : state)
    benchmark::DoNotOptimize(run_unit(plan(), *plan().questions.sources[0], Precision::binary32, 0, unit_size));
}
BENCHMARK(unit)->Unit(benchmark::kMicrosecond);

// The same with the findings of another unit known, as in a run without a plan.
void unit_with_standing(benchmark::State& state) {
  const UnitResult other = run_unit(plan(), *plan().questions.sources[0], Precision::binary32, 1, unit_size);
  const std::vector<StandingLeaders> standing = {standing_of(other.tallies[0])};
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        run_unit(plan(), *plan().questions.sources[0], Precision::binary32, 0, unit_size, standing));
  }
}
BENCHMARK(unit_with_standing)->Unit(benchmark::kMicrosecond);

// All that is done with a finished stretch: encoded, decoded and merged at rank 0, and appended with the note before
// it.
void entry(benchmark::State& state) {
  const Stretches stretches(plan().questions, 1);
  const Entry made = run_stretch(plan(), stretches, 0);
  const Tally tally = decode_tally(made.tallies[0], sphere_triangle_predicate());
  const Costs costs = decode_costs(made.costs);
  const TemporaryFolder folder;
  Journal journal((folder.path() / "journal").string(), std::string(64, 'a'), [](std::string_view) {});
  const std::uint64_t start = journal.bytes();
  for (auto _ : state) {
    journal.append(begun_note(0));
    const std::string bytes = encode(Entry{0, {encode(tally)}, encode(costs)});
    GatheredStretches gathered(plan().questions, 1, stretches);
    gathered.add(decode_entry(bytes));
    journal.append(bytes);
  }
  state.counters["bytes"] = static_cast<double>(journal.bytes() - start) / static_cast<double>(state.iterations());
}
BENCHMARK(entry)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace axiscert

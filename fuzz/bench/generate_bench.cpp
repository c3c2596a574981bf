// Nanoseconds per query to fill batches of 1024, as a run does, for each family and precision on the best instruction
// set; and per random number.
#include <benchmark/benchmark.h>

#include <filesystem>
#include <string>

#include "fuzz/queries/random.h"
#include "fuzz/queries/source.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

constexpr std::size_t batch_size = 1024;

void per_item(benchmark::State& state, double items) {
  state.counters["each"] =
      benchmark::Counter(items, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

template <class Real>
void time_fill(benchmark::State& state, const SourcePtr& source) {
  QueryBatch<Real> batch(batch_size, source->columns().size());
  std::uint64_t first = 0;
  for (auto _ : state) {
    source->fill(1, first, batch_size, batch);
    first += batch_size;
    benchmark::DoNotOptimize(batch);
    benchmark::ClobberMemory();
  }
  per_item(state, batch_size);
}

void time_words(benchmark::State& state) {
  Stream random(1, 2, 3, Precision::binary32, 4);
  for (auto _ : state) {
    for (int i = 0; i < 1024; ++i) benchmark::DoNotOptimize(random.word());
  }
  per_item(state, 1024);
}

void add(const SourcePtr& source) {
  benchmark::RegisterBenchmark((source->name() + "/binary32").c_str(), time_fill<float>, source);
  benchmark::RegisterBenchmark((source->name() + "/binary64").c_str(), time_fill<double>, source);
}

const bool added = [] {
  benchmark::RegisterBenchmark("one word of a Stream", time_words);
  for (const Family* family : families()) add(family_source(*family));
  const std::string model = "/usr/share/assimp/models/OBJ/spider.obj";  // from the package assimp-testmodels
  if (std::filesystem::exists(model)) add(mesh_source(model, sphere_triangle_predicate()));
  return true;
}();

}  // namespace
}  // namespace axiscert

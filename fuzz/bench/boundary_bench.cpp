// Nanoseconds per query of each family: values on a boundary by filter (with exact arithmetic where that is silent) and
// by exact arithmetic alone, and bounds of the depth. `silent` is the share that the filter does not decide.
#include <benchmark/benchmark.h>

#include <string>

#include "exact/sphere_triangle/measures/depth.h"
#include "exact/sphere_triangle/measures/nearest_root.h"
#include "fuzz/sphere_triangle/families/parts/boundary.h"
#include "fuzz/queries/family.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

constexpr std::size_t query_count = 4096;

template <class Real>
std::vector<Query<Real>> queries(const Family& family) {
  std::vector<Query<Real>> all;
  for (std::uint64_t position = 0; all.size() < query_count; ++position) {
    const Query<Real> q = family.make<Real>(1, position);
    if (is_valid(q)) all.push_back(q);
  }
  return all;
}

// The seven radius comparisons in turn, and the nine side comparisons.
Comparison radius_of(std::size_t i) { return radius_comparison(static_cast<Axis>(i % axis_count)); }
Comparison side_of(std::size_t i) {
  std::size_t left = i % 9, k = 0;
  while (comparisons[k].is_radius || left-- > 0) ++k;
  return static_cast<Comparison>(k);
}

template <class Real, class Measure>
void measure(const std::string& what, const Family& family, Measure measured) {
  const std::string name =
      what + "/" + std::string(family.name) + "/" + std::string(axiscert::name(precision_of<Real>));
  benchmark::RegisterBenchmark(name.c_str(), [&family, measured](benchmark::State& state) {
    const auto all = queries<Real>(family);
    std::size_t i = 0, silent = 0;
    for (auto _ : state) {
      const auto result = measured(all[i], i);
      if constexpr (requires { result.has_value(); }) silent += !result.has_value();
      benchmark::DoNotOptimize(result);
      i = (i + 1) % query_count;
    }
    if constexpr (requires { measured(all[0], 0).has_value(); }) {
      state.counters["silent"] = static_cast<double>(silent) / static_cast<double>(state.iterations());
    }
  });
}

template <class Real>
void measure_all(const Family& family) {
  using Q = const Query<Real>&;
  measure<Real>("distance/filter", family, [](Q q, std::size_t) { return nearest_distance(q); });
  measure<Real>("distance/exact", family, [](Q q, std::size_t) { return exact_radius_at_distance(q); });
  measure<Real>("radius/filter", family, [](Q q, std::size_t i) { return nearest_tie_radius(q, radius_of(i)); });
  measure<Real>("radius/exact", family, [](Q q, std::size_t i) { return exact_radius_on_boundary(q, radius_of(i)); });
  measure<Real>("coordinate/filter", family,
                [](Q q, std::size_t i) { return nearest_tie_coordinate(q, side_of(i), static_cast<int>(i / 9 % 3)); });
  measure<Real>("coordinate/exact", family, [](Q q, std::size_t i) {
    return exact_coordinate_on_boundary(q, side_of(i), static_cast<int>(i / 9 % 3));
  });
  measure<Real>("depth/range", family, [](Q q, std::size_t) { return depth_range(q); });
}

const bool registered = [] {
  for (const Family* family : families_of(sphere_triangle_predicate())) {
    measure_all<float>(*family);
    measure_all<double>(*family);
  }
  return true;
}();

}  // namespace
}  // namespace axiscert

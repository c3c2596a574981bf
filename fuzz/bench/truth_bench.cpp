// The cost of truth: the loop that a user would write, a judge by intervals, and axiscert's own unit, which also makes
// the queries, runs the kernel, judges all sixteen comparisons and tallies. All three have the same queries.
//
//     truth_bench [--queries N] [FAMILY...]
//
// Without names: all families and a mesh. N is the greatest number of queries of each, for a quick look (default: eight
// units).
#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include "exact/sphere_triangle/oracles/cgal_distance.h"
#include "exact/sphere_triangle/oracles/exact_truth.h"
#include "fuzz/bench/bench_table.h"
#include "fuzz/bench/naive_judges.h"
#include "fuzz/campaign/campaign.h"
#include "fuzz/campaign/machine.h"

namespace axiscert {
template <class Real>
std::uint64_t separated_by_distance(const std::vector<Query<Real>>& queries) {
  std::uint64_t separated = 0;
  for (const Query<Real>& q : queries) {
    if (is_valid(q)) separated += cgal_squared_distance(q) > cgal_squared_radius(q);
  }
  return separated;
}
template std::uint64_t separated_by_distance<float>(const std::vector<Query<float>>&);
template std::uint64_t separated_by_distance<double>(const std::vector<Query<double>>&);

}  // namespace axiscert

namespace axiscert {
namespace {

constexpr int repetitions = 5;
constexpr std::uint64_t default_queries = 8 * unit_size, least_queries = unit_size / 16;
constexpr double slow_naive_ns = 1e5;  // per query; if the naive loop is slower, there are fewer queries, for the same
                                       // total time

Plan plan_of(std::vector<SourcePtr> sources) {
  Plan plan;
  plan.answerers.kernels = {&find_kernel("published")};
  plan.questions.sources = std::move(sources);
  plan.questions.precisions = {Precision::binary32};
  plan.running.target = resolve_target("auto");
  return plan;
}

// The rate that the harness is to reach, as a multiple of the naive loop's; 0 if no goal is set.
double goal(std::string_view source, Precision precision) {
  const auto is_one_of = [&](std::initializer_list<std::string_view> names) {
    return std::find(names.begin(), names.end(), source) != names.end();
  };
  if (is_one_of({"general", "far", "ratio"}) || source.starts_with("mesh/")) return 40;
  if (is_one_of({"tangent", "seam", "sliver"})) return 25;
  if (is_one_of({"tie", "lattice", "collinear", "repeated"})) return 4;
  if (is_one_of({"scale", "subnormal", "bits"}) && precision == Precision::binary32) return 2;
  return 0;
}

// Processor time in nanoseconds.
template <class Work>
double nanoseconds(Work&& work) {
  const double start = thread_seconds();
  work();
  return (thread_seconds() - start) * 1e9;
}

struct BenchFault : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// The timed results have to be right: all three count the same, and on a sample every sign is that of exact arithmetic.
template <class Real>
void check(const std::vector<Query<Real>>& queries, const std::vector<Signs>& signs, std::uint64_t naive,
           std::uint64_t harness) {
  const auto interval = static_cast<std::uint64_t>(
      std::count_if(signs.begin(), signs.end(), [](const Signs& s) { return verdict_of(s) == Verdict::separated; }));
  if (naive != harness || interval != harness) {
    throw BenchFault(
        fmt::format("separated: {} by the naive loop, {} by intervals, {} by axiscert", naive, interval, harness));
  }
  constexpr std::size_t stride = 61;
  for (std::size_t i = 0; i < queries.size(); i += stride) {
    if (!is_valid(queries[i])) continue;
    const ExactSides exact = exact_sides(queries[i]);
    if (signs[i].strict != exact.strict || signs[i].ties != exact.ties)
      throw BenchFault(fmt::format("the signs of query {} by intervals are wrong", i));
  }
}

template <class Real>
void measure(const Plan& plan, const Source& source, std::uint64_t most_queries) {
  const auto queries_of = [&](std::uint64_t count) {
    std::vector<Query<Real>> queries(count);
    for (std::uint64_t i = 0; i < count; ++i) queries[i] = source.make<Real>(plan.questions.seed, i);
    return queries;
  };
  const auto probe = queries_of(512);
  separated_by_distance(probe);
  const double probed_ns = nanoseconds([&] { separated_by_distance(probe); }) / 512;
  std::uint64_t count = most_queries;
  while (count > least_queries && probed_ns * static_cast<double>(count) > slow_naive_ns * default_queries) count /= 2;

  const auto queries = queries_of(count);
  std::vector<Signs> signs;
  std::vector<double> naive, interval, harness;
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    std::uint64_t by_naive = 0, by_harness = 0;
    naive.push_back(nanoseconds([&] { by_naive = separated_by_distance(queries); }));
    interval.push_back(nanoseconds([&] { signs_by_intervals(queries, signs); }));
    harness.push_back(nanoseconds([&] {
      Tally all = empty_tally(source.predicate());  // as in a campaign, whose units know the findings of others
      for (std::uint64_t first = 0; first < count; first += unit_size) {
        const std::uint64_t size = std::min(unit_size, count - first);
        all.merge(run_unit(plan, source, precision_of<Real>, first / unit_size, size, {standing_of(all)}).tallies[0]);
      }
      by_harness = all.truth.separated;
    }));
    if (repetition == 0) check(queries, signs, by_naive, by_harness);
  }
  const double n = static_cast<double>(count), naive_ns = median(naive) / n, interval_ns = median(interval) / n,
               harness_ns = median(harness) / n, ratio = naive_ns / harness_ns;
  const double wanted = goal(source.name(), precision_of<Real>);
  fmt::print("| {} | {} | {} | {:.0f} | {:.0f} | {:.1f} | {:.1f} | {:.1f} | {} |\n", source.name(),
             name(precision_of<Real>), count, naive_ns, interval_ns, harness_ns, ratio, interval_ns / harness_ns,
             wanted == 0 ? "" : fmt::format("{:.0f}, {}", wanted, ratio >= wanted ? "met" : "missed"));
  std::fflush(stdout);
}

// Wall-clock seconds, which other programs do affect.
double campaign_seconds(Plan plan, int threads, std::uint64_t units) {
  plan.running.threads = threads;
  plan.questions.trials = [units](const Source&, Precision) { return units * unit_size; };
  static const std::atomic<bool> never = false;
  const auto start = std::chrono::steady_clock::now();
  run_campaign(plan, never, [](const Progress&) {});
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double peak_mebibytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;  // Linux counts in KiB
}

// Two lines about whole campaigns of family `general`, binary32. They come before the table, whose queries would add to
// the peak.
std::string campaign_lines() {
  const Plan plan = plan_of({family_source(find_family("general"))});
  const double unit_seconds = campaign_seconds(plan, 1, 1);
  // Enough units for a second and a half of one thread, and for two threads to share evenly.
  const auto units = static_cast<std::uint64_t>(std::clamp(std::ceil(0.75 / unit_seconds) * 2, 8.0, 4096.0));
  campaign_seconds(plan, 2, units);
  const double peak = peak_mebibytes();
  std::vector<double> one, two;
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    one.push_back(campaign_seconds(plan, 1, units));
    two.push_back(campaign_seconds(plan, 2, units));
  }
  campaign_seconds(plan, 2, 4 * units);
  const double n = static_cast<double>(units * unit_size);
  return fmt::format(
      "Two threads against one, by the clock, general in binary32: {:.1f} ns a query against {:.1f}, {:.2f} times the "
      "rate (1.8 wanted).\n"
      "Peak memory: {:.1f} MiB after {} queries, {:.1f} MiB after {}.\n",
      median(two) * 1e9 / n, median(one) * 1e9 / n, median(one) / median(two), peak, units * unit_size,
      peak_mebibytes(), 4 * units * unit_size);
}

void run(std::vector<std::string_view> names) {
  std::uint64_t most_queries = default_queries;
  if (names.size() >= 2 && names[0] == "--queries") {
    most_queries = std::max<std::uint64_t>(least_queries, std::stoull(std::string(names[1])));
    names.erase(names.begin(), names.begin() + 2);
  }
  const std::vector<SourcePtr> sources = sources_named(names);
  const std::string campaigns = campaign_lines();
  const Plan plan = plan_of(sources);
  fmt::print(
      "{}; {}, {} -frounding-math; instruction set {}. One thread, processor time, ns a query, medians of {} "
      "interleaved repetitions.\n\n"
      "- naive: CGAL::Exact_predicates_exact_constructions_kernel, squared_distance(p, t) > r r, on queries in memory; "
      "the "
      "verdict alone\n"
      "- interval: the sixteen comparisons over CGAL::Interval_nt, those of a query left open in exact arithmetic; on "
      "queries in memory\n"
      "- harness: axiscert makes the queries, runs `published`, judges all sixteen comparisons and tallies; its rate "
      "over "
      "theirs, and the goal for its rate over the naive loop's\n\n"
      "| family | precision | queries | naive | interval | harness | rate / naive | rate / interval | goal |\n"
      "|---|---|---:|---:|---:|---:|---:|---:|---|\n",
      processor_name(), compiler_name(), compiler_flags(), plan.running.target, repetitions);
  for (const SourcePtr& source : sources) {
    measure<float>(plan, *source, most_queries);
    measure<double>(plan, *source, most_queries);
  }
  fmt::print("\n{}", campaigns);
}

}  // namespace
}  // namespace axiscert

int main(int argc, char** argv) { return axiscert::bench_main("truth_bench", argc, argv, axiscert::run); }

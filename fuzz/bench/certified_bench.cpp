// The cost of exactness: `certified` and `conservative` beside the raw tests and CGAL, on the same queries.
//
//     certified_bench [--target T] [FAMILY...]
//
// Without names: all families and a mesh, and the cost of a large mesh. T is an instruction set from `axiscert
// kernels`, by default the best one; one pair always uses the best.
#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "fuzz/bench/bench_table.h"
#include "fuzz/campaign/build_info.h"
#include "fuzz/bench/certified_stream.h"
#include "fuzz/bench/naive_judges.h"
#include "fuzz/queries/source.h"
#include "fuzz/campaign/thread_seconds.h"
#include "kernel/include/axiscert/certified.hpp"
#include "kernel/kernel.h"

namespace axiscert {
namespace {

constexpr std::size_t query_count = std::size_t{1} << 17;  // 6.5 MiB of binary32
constexpr int repetitions = 9;
constexpr double least_seconds = 2e-3;  // least time of one repetition
constexpr double enough_seconds = 4;    // time for all repetitions; slow kernels have fewer, but at least one

// A timed function, interleaved with the others.
struct TimedFunction {
  std::string name;
  std::function<void()> pass;  // one pass over query_count queries
  std::size_t passes = 1;
  std::vector<double> seconds = {};

  double once() const {
    const double start = thread_seconds();
    for (std::size_t i = 0; i < passes; ++i) pass();
    return thread_seconds() - start;
  }
  void find_passes() {
    while (once() < least_seconds) passes *= 2;
  }
  double spent() const { return std::accumulate(seconds.begin(), seconds.end(), 0.0); }
  double nanoseconds() const { return median(seconds) / static_cast<double>(passes * query_count) * 1e9; }
};

// Prints the row of a family, and returns its row of the second table.
template <class Real>
std::string measure(const Source& source, const std::string& target) {
  QueryBatch<Real> batch(query_count, coordinate_count);
  source.fill(1, 0, query_count, batch);
  const QueryColumns<Real> columns = batch.columns();
  std::vector<Query<Real>> queries;
  for (std::size_t i = 0; i < query_count; ++i) queries.push_back(batch[i]);
  std::vector<Verdict> verdicts(query_count);
  std::vector<std::array<Real, coordinate_count>> flat;
  for (const Query<Real>& q : queries) flat.push_back(coordinates(q));
  int contacts = 0;

  std::vector<TimedFunction> all;
  for (const char* id : {"published", "reduced-nonstrict", "certified", "conservative"}) {
    all.push_back({id, [&, run = find_kernel(id).on<Real>(target).verdicts] { run(columns, verdicts.data()); }});
  }
  all.push_back({"scalar published", [&, run = find_kernel("published").on<Real>(scalar_target).verdicts] {
                   run(columns, verdicts.data());
                 }});
  all.push_back({"one pair", [&] {
                   for (const auto& v : flat) contacts += certified::pair(v.data(), v.data() + 9) == AXISCERT_CONTACT;
                 }});
  std::array<const Real*, coordinate_count> pointers;
  std::copy_n(columns.column.begin(), coordinate_count, pointers.begin());
  all.push_back({"exact only", [&] {
                   const axiscert_results to{reinterpret_cast<std::uint8_t*>(verdicts.data()), nullptr, nullptr};
                   certified::pairs(pointers, query_count, AXISCERT_EXACT_ONLY, to);
                 }});
  for (TimedFunction& timed : all) timed.find_passes();
  for (int i = 0; i < repetitions; ++i) {
    for (TimedFunction& timed : all) {
      if (timed.spent() < enough_seconds) timed.seconds.push_back(timed.once());
    }
  }
  // It is slow, and steady enough with one pass.
  TimedFunction epick{"CGAL EPICK", [&] { contacts += static_cast<int>(contacts_by_epick(queries)); }};
  epick.seconds.push_back(epick.once());

  const double raw = std::min(all[0].nanoseconds(), all[1].nanoseconds());
  const auto of = [&](std::size_t i, double to) {
    return fmt::format("{:.1f} ({:.2f})", all[i].nanoseconds(), all[i].nanoseconds() / to);
  };
  fmt::print("| {} | {} | {:.1f} | {:.1f} | {} | {} | {:.1f} | {} | {:.0f} ({:.0f}) |\n", source.name(),
             name(precision_of<Real>), all[0].nanoseconds(), all[1].nanoseconds(), of(2, raw), of(3, raw),
             all[4].nanoseconds(), of(5, all[4].nanoseconds()), epick.nanoseconds(),
             epick.nanoseconds() / all[2].nanoseconds());
  std::fflush(stdout);
  return fmt::format("| {} | {} | {:.1f} | {} |\n", source.name(), name(precision_of<Real>), all[2].nanoseconds(),
                     of(6, all[2].nanoseconds()));
}

void run(std::vector<std::string_view> names) {
  std::string wanted = "auto";
  if (!names.empty() && names[0] == "--target") {
    if (names.size() == 1)
      throw std::invalid_argument("--target: name an instruction set, as listed by `axiscert kernels`");
    wanted = names[1];
    names.erase(names.begin(), names.begin() + 2);
  }
  const std::vector<SourcePtr> sources = sources_named(names);
  const std::string target = resolve_target(wanted);
  fmt::print(
      "{}; {}, {}; instruction set {}. One thread, processor time, ns a query, medians of {} "
      "interleaved repetitions (of what is slow, fewer) over {} queries.\n\n"
      "- certified, conservative: (times the faster of the two raw tests)\n"
      "- one pair: axiscert_pair, (times the scalar published test)\n"
      "- CGAL EPICK: compare_squared_distance_3, (times certified)\n\n"
      "| family | precision | published | reduced-nonstrict | certified | conservative | scalar published | one pair | "
      "CGAL EPICK |\n"
      "|---|---|---:|---:|---:|---:|---:|---:|---:|\n",
      processor_name(), compiler_name(), compiler_flags(), target, repetitions, query_count);
  std::string exact_only;
  for (const SourcePtr& source : sources) {
    exact_only += measure<float>(*source, target);
    exact_only += measure<double>(*source, target);
  }
  fmt::print(
      "\nAXISCERT_EXACT_ONLY, straight to the exact step: (times certified)\n\n"
      "| family | precision | certified | exact only |\n"
      "|---|---|---:|---:|\n{}",
      exact_only);
  if (names.empty()) print_certified_streams();
}

}  // namespace
}  // namespace axiscert

int main(int argc, char** argv) { return axiscert::bench_main("certified_bench", argc, argv, axiscert::run); }

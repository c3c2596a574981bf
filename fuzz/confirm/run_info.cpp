#include <CGAL/version.h>
#include <assimp/version.h>
#include <fmt/format.h>
#include <gmp.h>
#include <hwy/highway.h>
#include <mpfr.h>

#include <cmath>

#include "fuzz/campaign/machine.h"
#include "fuzz/confirm/record.h"
#include "kernel/base/version.h"

namespace axiscert {
namespace {

// The steps by which the queries of a cell were decided, and the time of each.
CellSteps steps_of(const Source& source, const CellResult& cell, bool exact_only) {
  const StepCounts& steps = cell.steps;
  NamedValues<StepQueries> signs;
  for (std::size_t k = 0; k < steps.signs.size() && !exact_only; ++k)
    signs.put(source.predicate().comparisons[k].name) = steps.signs[k];
  const auto each = [&](double nanoseconds) { return nanoseconds / static_cast<double>(cell.queries); };
  return {source.name(),
          cell.precision,
          steps.queries,
          signs,
          steps.checked,
          steps.by_cgal,
          {each(steps.generation), each(steps.kernels), each(steps.steps[Step::lanes]), each(steps.steps[Step::grid]),
           each(steps.steps[Step::wide]), each(steps.steps[Step::integers]), each(steps.errors), each(steps.judging)}};
}

}  // namespace

RunInfo run_info(const Plan& plan, const CampaignResult& result, const std::string& target_asked,
                 const std::string& started, double seconds) {
  RunInfo info;
  info.started = started;
  info.seconds = seconds;
  info.threads = plan.running.threads;
  info.machine.cpu = processor_name();
  info.compiler = compiler_name();
  info.flags = compiler_flags();
  info.revision = axiscert_revision;
  info.target = {target_asked, plan.running.target};
  info.versions.put("axiscert") = axiscert_version;
  info.versions.put("cgal") = CGAL_STR(CGAL_VERSION);
  // assimp determines which triangles a mesh file contains.
  info.versions.put("assimp") = fmt::format("{}.{}.{}", aiGetVersionMajor(), aiGetVersionMinor(), aiGetVersionPatch());
  info.versions.put("gmp") = gmp_version;
  info.versions.put("mpfr") = mpfr_get_version();
  info.versions.put("highway") = fmt::format("{}.{}.{}", HWY_MAJOR, HWY_MINOR, HWY_PATCH);
  info.second_opinions = result.second_opinions;
  info.exact_only = plan.judging.exact_only;
  for (const CellResult& cell : result.cells) {
    info.by_cgal += cell.steps.by_cgal;
    if (cell.queries == 0) continue;
    const Source& source = *plan.questions.sources[cell.source];
    const double rate = static_cast<double>(cell.queries) / cell.core_seconds;
    info.throughput.push_back({source.name(), cell.precision, cell.queries, cell.core_seconds,
                               std::isfinite(rate) ? std::optional(rate) : std::nullopt});
    info.steps.push_back(steps_of(source, cell, plan.judging.exact_only));
  }
  return info;
}

}  // namespace axiscert

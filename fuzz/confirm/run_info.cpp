#include <CGAL/version.h>
#include <assimp/version.h>
#include <fmt/format.h>
#include <gmp.h>
#include <hwy/highway.h>
#include <mpfr.h>

#include "fuzz/campaign/build_info.h"
#include "fuzz/confirm/record.h"
#include "kernel/base/version.h"

namespace axiscert {
namespace {

// The steps by which the queries of a cell were decided, and the time of each. The time of a step is divided by all
// queries, including those that it never saw or passed on.
Json steps_json(const Source& source, const CellResult& cell, bool exact_only) {
  const StepCounts& steps = cell.steps;
  const auto by_step = [](const EnumArray<Step, std::uint64_t>& counts) {
    Json json = Json::object();
    for (const Step step : enumerators<Step>) json[std::string(step_names[step])] = counts[step];
    return json;
  };
  Json signs = Json::object();
  for (std::size_t k = 0; k < steps.signs.size() && !exact_only; ++k) {
    signs[std::string(source.test().comparisons[k].name)] = by_step(steps.signs[k]);
  }
  const auto each = [&](double nanoseconds) { return nanoseconds / static_cast<double>(cell.queries); };
  return {{"family", source.name()},
          {"precision", name(cell.precision)},
          {"queries", by_step(steps.queries)},
          {"signs", signs},
          {"checked", steps.checked},
          {"decided_by_cgal", steps.by_cgal},
          {"nanoseconds_per_query",
           {{"generation", each(steps.generation)},
            {"kernels", each(steps.kernels)},
            {"lanes", each(steps.steps[Step::lanes])},
            {"grid", each(steps.steps[Step::grid])},
            {"wide", each(steps.steps[Step::wide])},
            {"integers", each(steps.steps[Step::integers])},
            {"sides", each(steps.errors)},
            {"judging", each(steps.judging)}}}};
}

}  // namespace

Json run_info(const Plan& plan, const CampaignResult& result, const std::string& target_asked,
              const std::string& started, double seconds) {
  Json json = {{"schema", "axiscert-run/1"},
               {"started", started},
               {"seconds", seconds},
               {"threads", plan.running.threads},
               {"machine", {{"cpu", processor_name()}}},
               {"compiler", compiler_name()},
               {"flags", compiler_flags()},
               {"revision", axiscert_revision},
               {"target", {{"asked", target_asked}, {"dispatched", plan.running.target}}},
               {"versions",
                {{"axiscert", axiscert_version},
                 {"cgal", CGAL_STR(CGAL_VERSION)},
                 // assimp determines which triangles a mesh file contains.
                 {"assimp", fmt::format("{}.{}.{}", aiGetVersionMajor(), aiGetVersionMinor(), aiGetVersionPatch())},
                 {"gmp", gmp_version},
                 {"mpfr", mpfr_get_version()},
                 {"highway", fmt::format("{}.{}.{}", HWY_MAJOR, HWY_MINOR, HWY_PATCH)}}},
               {"throughput", Json::array()},
               {"second_opinions", result.second_opinions}};
  for (const CellResult& cell : result.cells) {
    const std::uint64_t queries = cell.queries;
    if (queries == 0) continue;
    json["throughput"].push_back({{"family", plan.questions.sources[cell.source]->name()},
                                  {"precision", name(cell.precision)},
                                  {"queries", queries},
                                  {"seconds_of_core", cell.core_seconds},
                                  {"queries_per_second_and_core", static_cast<double>(queries) / cell.core_seconds}});
  }
  json["exact_only"] = plan.judging.exact_only;
  json["steps"] = Json::array();
  std::uint64_t by_cgal = 0;
  for (const CellResult& cell : result.cells) {
    by_cgal += cell.steps.by_cgal;
    if (cell.queries == 0) continue;
    const Source& source = *plan.questions.sources[cell.source];
    json["steps"].push_back(steps_json(source, cell, plan.judging.exact_only));
  }
  json["decided_by_cgal"] = by_cgal;
  return json;
}

}  // namespace axiscert

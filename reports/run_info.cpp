#include <CGAL/version.h>
#include <assimp/version.h>
#include <fmt/format.h>
#include <gmp.h>
#include <hwy/highway.h>
#include <mpfr.h>

#include "fuzz/build_info.h"
#include "reports/record.h"

namespace axiscert {

Json run_info(const Plan& plan, const CampaignResult& result, const std::string& target_asked,
              const std::string& started, double seconds) {
  Json json = {{"schema", "axiscert-run/1"},
               {"started", started},
               {"seconds", seconds},
               {"threads", plan.threads},
               {"machine", {{"cpu", processor_name()}}},
               {"compiler", compiler_name()},
               {"flags", compiler_flags()},
               {"target", {{"asked", target_asked}, {"dispatched", plan.target}}},
               {"versions",
                {{"axiscert", AXISCERT_VERSION},
                 {"cgal", CGAL_STR(CGAL_VERSION)},
                 // Which triangles a mesh file holds is for assimp to say.
                 {"assimp", fmt::format("{}.{}.{}", aiGetVersionMajor(), aiGetVersionMinor(), aiGetVersionPatch())},
                 {"gmp", gmp_version},
                 {"mpfr", mpfr_get_version()},
                 {"highway", fmt::format("{}.{}.{}", HWY_MAJOR, HWY_MINOR, HWY_PATCH)}}},
               {"throughput", Json::array()},
               {"second_opinions", result.second_opinions}};
  for (const CellResult& cell : result.cells) {
    const std::uint64_t queries = cell.queries;
    if (queries == 0) continue;
    json["throughput"].push_back({{"family", plan.sources[cell.source]->name()},
                                  {"precision", name(cell.precision)},
                                  {"queries", queries},
                                  {"seconds_of_core", cell.core_seconds},
                                  {"queries_per_second_and_core", static_cast<double>(queries) / cell.core_seconds}});
  }
  return json;
}

}  // namespace axiscert

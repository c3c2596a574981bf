#include "cli/running/stated_entries.h"

#include <fmt/format.h>

#include "fuzz/campaign/parts/stretch.h"
#include "fuzz/confirm/record.h"
#include "fuzz/text/number_text.h"
#include "reports/certificate/statement/canonical.h"
#include "reports/certificate/statement/statement.h"

namespace axiscert {

std::vector<std::string> declared_differences(const Json& stated, const std::vector<FileInfo>& plugins,
                                              const Kernel& kernel, Precision precision) {
  std::vector<std::string> differences;
  const Json entry = without_fractions(json_of(kernel_record(plugins, kernel, precision)));
  for (const auto& [member, here] : entry.items()) {
    const bool is_elsewhere = member == "id" || member == "families" || member == "critical_radius";
    const Json said = stated.value(member, Json());
    if (is_elsewhere || canonical_json(said) == canonical_json(here)) continue;
    differences.push_back(fmt::format("{} in {} is stated with another {}: here {}, in it {}", kernel.id,
                                      name(precision), member, here.dump(), axiscert::shown(said.dump())));
  }
  return differences;
}

std::vector<std::string> triangle_differences(const Json& predicate, const Questions& questions) {
  std::vector<std::string> differences;
  const CampaignResult all = planned(questions);
  for (const CellResult& cell : all.cells) {
    const Source& source = *questions.sources[cell.source];
    const std::uint64_t triangles = source.base_triangles(cell.precision, cell.queries);
    for (const Json& entry : predicate["materials"]["kernels"]) {
      const auto family = entry["families"].find(source.name());
      if (entry["precision"] != name(cell.precision) || family == entry["families"].end()) continue;
      if ((*family)["base_triangles"] == triangles) continue;
      const bool is_its = entry["id"] == predicate["materials"]["plan"]["plan"]["kernels"][0];
      const std::string id = (is_its ? predicate["kernel"] : entry)["id"];
      differences.push_back(fmt::format("{} in {} on {} is stated with another base_triangles: here {}",
                                        axiscert::shown(id), name(cell.precision), source.name(), triangles));
    }
  }
  return differences;
}

}  // namespace axiscert

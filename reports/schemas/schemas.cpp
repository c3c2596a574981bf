#include "reports/schemas/schemas.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <vector>

#include "fuzz/files/corpus.h"
#include "fuzz/record/record.h"
#include "kernel/base/alike.h"
#include "kernel/base/error.h"
#include "reports/certificate/statement/certificate_data.h"
#include "reports/comparison/comparison_data.h"
#include "reports/gates/requirement.h"
#include "reports/instrument/diagnosis_report.h"
#include "reports/instrument/lists.h"
#include "reports/instrument/map.h"
#include "reports/instrument/mutation/mutation_data.h"
#include "reports/instrument/precision/condition_data.h"
#include "reports/instrument/precision/critical_radius_data.h"
#include "reports/instrument/precision/ladder_data.h"
#include "reports/instrument/precision/precision_data.h"
#include "reports/instrument/proofs_data.h"
#include "reports/instrument/query_lines.h"
#include "reports/instrument/query_row.h"
#include "reports/instrument/search_data.h"
#include "reports/league/league_data.h"
#include "reports/run_folder/ratchet_outcome.h"

namespace axiscert {
namespace {

template <class File>
Json file_schema(const Json& schema) {
  Json whole = {{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", File::title}};
  whole.update(schema);
  return whole;
}
template <class File>
Json schema_of() {
  return file_schema<File>(json_schema_of<File>());
}

}  // namespace

std::span<const SchemaEntry> schemas() {
  static constexpr std::array all = {
      SchemaEntry{"certificate", schema_of<CertificateStatement>},
      SchemaEntry{"check", schema_of<CheckLine>},
      SchemaEntry{"comparison", schema_of<ComparisonData>},
      SchemaEntry{"condition", schema_of<ConditionData>},
      SchemaEntry{"corpus", schema_of<CorpusLine>},
      SchemaEntry{"critical-radius", schema_of<CriticalRadiusData>},
      SchemaEntry{"diagnosis", [] { return file_schema<DiagnosisData>(diagnosis_data_schema()); }},
      SchemaEntry{"families", schema_of<FamiliesData>},
      SchemaEntry{"kernels", schema_of<KernelsData>},
      SchemaEntry{"ladder", schema_of<LadderData>},
      SchemaEntry{"league", schema_of<LeagueData>},
      SchemaEntry{"maps", schema_of<MapsData>},
      SchemaEntry{"mutation", schema_of<MutationData>},
      SchemaEntry{"mutation-by-verdict", schema_of<MutationByVerdictData>},
      SchemaEntry{"mutation-of-certified", schema_of<MutationOfCertifiedData>},
      SchemaEntry{"precision", schema_of<PrecisionData>},
      SchemaEntry{"proofs", schema_of<ProofsData>},
      SchemaEntry{"ratchet", schema_of<RatchetOutcome>},
      SchemaEntry{"record", schema_of<Record>},
      SchemaEntry{"row", schema_of<QueryRow>},
      SchemaEntry{"run", schema_of<RunFile>},
      SchemaEntry{"search", schema_of<SearchData>},
      SchemaEntry{"shrink", schema_of<ShrinkLine>},
      SchemaEntry{"predicates", schema_of<PredicatesData>},
  };
  return all;
}

Json schema_named(std::string_view name) {
  std::vector<std::string_view> names;
  for (const SchemaEntry& entry : schemas()) {
    if (entry.name == name) return entry.schema();
    names.push_back(entry.name);
  }
  throw Error(fmt::format("--schema {}: unknown{} schemas: {}", name, did_you_mean(name, names),
                          fmt::join(most_alike_first(name, names), ", ")));
}

}  // namespace axiscert

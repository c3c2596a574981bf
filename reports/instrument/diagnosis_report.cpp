// `axiscert diagnose`: what a kernel is like, property by property.
#include "reports/instrument/diagnosis_report.h"

#include <fmt/format.h>

#include "fuzz/text/json_form.h"
#include "reports/instrument/figures.h"

namespace axiscert {
namespace {

InstrumentTable diagnosis_property_table(const Diagnosis& diagnosis) {
  InstrumentTable table{"Properties", {"property", "value", "answers", "what was asked"}, {}};
  for (const PropertyKind& kind : property_kinds()) {
    const Property* property = diagnosis.find(kind.name);
    if (!property) continue;
    table.rows.push_back({property->name, property->value, thousands(property->queries), std::string(kind.asks)});
  }
  return table;
}

InstrumentTable diagnosis_witness_table(const Diagnosis& diagnosis) {
  InstrumentTable table{"Witnesses", {"property", "answered", "truth", "how"}, {}};
  for (const Property& property : diagnosis.properties) {
    for (const DiagnosisWitness& witness : property.witnesses) {
      table.rows.push_back({property.name, witness.answered, witness.truth, witness.shows});
    }
  }
  return table;
}

}  // namespace

Json diagnosis_data_schema() {
  Json schema = json_schema_of<DiagnosisData>(), names = Json::array(), values = Json::array();
  const auto add = [&](Json of_kind) { values.push_back(Json{{"properties", std::move(of_kind)}}); };
  add({{"value", {{"enum", Json::array({not_known, not_asked})}}}});
  for (const PropertyKind& kind : property_kinds()) {
    names.push_back(kind.name);
    Json of_kind = {{"name", {{"const", kind.name}}}};
    if (!kind.values.empty()) of_kind["value"] = {{"enum", kind.values}};
    add(std::move(of_kind));
  }
  Json& property = schema["properties"]["properties"]["items"];
  property["properties"]["name"]["enum"] = std::move(names);
  property["anyOf"] = std::move(values);
  return schema;
}

InstrumentReport diagnosis_report(const Diagnosis& diagnosis, const std::string& command) {
  InstrumentReport report;
  report.name = "diagnosis";
  const LookedAt looked_at = diagnosis.looked_at();
  report.title =
      fmt::format("What {} is like, {}, seed {}{}: {}", diagnosis.kernel, name(diagnosis.precision), diagnosis.seed,
                  diagnosis.complete ? "" : ", interrupted", looked_at_text(looked_at, diagnosis.may_decline));
  if (looked_at.decided == 0) report.title = "Nothing was looked at. " + report.title;
  if (std::string faults = faults_text(looked_at, diagnosis.may_decline); !faults.empty()) {
    report.notes.push_back(std::move(faults));
  }
  report.command = command;
  for (const Property* property : diagnosis.most_important_first()) {
    report.notes.push_back(fmt::format("{}: {}. {}", property->name, property->value, property->sentence));
  }
  report.notes.push_back(
      "Only answers were looked at. A value is given where the answers decide it; not_known: they "
      "do not; not_asked: the probe does not apply. Nothing is said of queries that were not asked.");
  report.tables = {diagnosis_property_table(diagnosis)};
  report.add(diagnosis_witness_table(diagnosis));
  DiagnosisData data;
  data.command = command;
  data.diagnosis = diagnosis;
  report.data = json_of(data);
  return report;
}

std::string diagnosis_witnesses(const Diagnosis& diagnosis) {
  std::string text;
  for (const Property& property : diagnosis.properties) {
    for (const DiagnosisWitness& witness : property.witnesses) {
      Json line = Json::parse(witness.query);
      line["id"] = property.name;
      text += line.dump() + "\n";
    }
  }
  return text;
}

}  // namespace axiscert

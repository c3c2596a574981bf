// `axiscert diagnose`: what a kernel is like, property by property.
#include "reports/instrument/diagnosis_report.h"

#include <fmt/format.h>

#include "reports/instrument/data.h"
#include "reports/instrument/figures.h"
#include "reports/instrument/looked_at.h"

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
  for (const Property& property : diagnosis.properties) {
    report.notes.push_back(fmt::format("{}: {}. {}", property.name, property.value, property.sentence));
  }
  report.notes.push_back(
      "Only verdicts were looked at. A value is given where the answers decide it; not_known: they "
      "do not; not_asked: the probe does not apply. Nothing is said of queries that were not asked.");
  report.tables = {diagnosis_property_table(diagnosis)};
  if (InstrumentTable witnesses = diagnosis_witness_table(diagnosis); !witnesses.rows.empty()) {
    report.tables.push_back(std::move(witnesses));
  }
  Json members = {{"command", command}};
  members.update(diagnosis_json(diagnosis));
  report.data = headed(diagnosis_schema, members);
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

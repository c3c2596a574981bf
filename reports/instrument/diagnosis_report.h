// The report of `axiscert diagnose`.
#pragma once

#include "fuzz/diagnosis/diagnosis.h"
#include "reports/instrument/data.h"
#include "reports/instrument/instrument.h"

namespace axiscert {

struct DiagnosisData : CommandData<DiagnosisData> {
  static constexpr std::string_view format = "axiscert-diagnosis/2", title = "What a kernel is like";
  Diagnosis diagnosis;

  static constexpr std::string_view about =
      "diagnosis.json, which `axiscert diagnose` writes. It depends on the kernel, the precision and the seed alone. "
      "docs/diagnosis.md says what decides each value.";
  AXISCERT_FIELDS(DiagnosisData, base<DiagnosisData, CommandData<DiagnosisData>>(), inlined(&DiagnosisData::diagnosis))
};
// Its schema, with the values of each property.
Json diagnosis_data_schema();

InstrumentReport diagnosis_report(const Diagnosis& diagnosis, const std::string& command);
// The witnesses as a query file, in the order of the properties; the id of each names its property.
std::string diagnosis_witnesses(const Diagnosis& diagnosis);

}  // namespace axiscert

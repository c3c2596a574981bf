// The report of `axiscert diagnose`.
#pragma once

#include "fuzz/diagnosis/diagnosis.h"
#include "reports/instrument/instrument.h"

namespace axiscert {

inline constexpr const char* diagnosis_schema = "axiscert-diagnosis/1";

InstrumentReport diagnosis_report(const Diagnosis& diagnosis, const std::string& command);
// The witnesses as a query file, in the order of the properties; the id of each names its property.
std::string diagnosis_witnesses(const Diagnosis& diagnosis);

}  // namespace axiscert

// The fault of a kernel that matters first, and what to do about it; and the witnesses to paste.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fuzz/record/record.h"
#include "reports/certificate/statement/certificate_data.h"

namespace axiscert {

// The worst of a record about a kernel: a finding, else the cause of its missed contacts that goes deepest, else that
// of its phantom contacts; of a kernel of another predicate that shows its verdict alone the situation that breaks
// first.
std::optional<BreakStatement> what_breaks_first(const Record& record, const std::string& kernel);

// The situations in which it is wrong.
std::vector<SituationStatement> where_it_is_wrong(const Record& record, const std::string& kernel);

// The sections of the documents to which the advice of causes points.
std::vector<std::string_view> advised_sections();

// At most three wrong verdicts, the deepest of different families first.
std::vector<CertificateWitness> worst_of_certificate(const Record& record, const std::string& kernel);

}  // namespace axiscert

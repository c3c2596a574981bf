// The fault of a kernel that matters first, and what to do about it; and the witnesses to paste.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fuzz/record/record.h"

namespace axiscert {

// The worst of a record about a kernel: a finding, else the cause of its missed contacts that goes deepest, else that
// of its phantom contacts; of a kernel of another test that shows its verdict alone the situation that breaks first. An
// object with precision, what, cause, count, deepest, advice and section, the part of the documents that says more;
// null where nothing is wrong.
Json what_breaks_first(const Record& record, const std::string& kernel);

// The situations in which it is wrong (situations_json), with depths as decimal texts.
Json where_it_is_wrong(const Record& record, const std::string& kernel);

// The sections of the documents to which the advice of causes points.
std::vector<std::string_view> advised_sections();

// At most three wrong verdicts, the deepest of different families first: title, sentence, command and query.
Json worst_of_certificate(const Record& record, const std::string& kernel);

}  // namespace axiscert

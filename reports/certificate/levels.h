// The levels of a certificate: what the gates say of a record, what a search found against it, what is proved.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "fuzz/record/record.h"
#include "reports/certificate/certificate_data.h"
#include "reports/gates/level.h"

namespace axiscert {

// The levels that a certificate asks: every level of --require, with an argument where it takes one.
std::vector<std::string> levels_asked(const std::vector<std::string>& yardsticks);

// An entry for each level and precision, in the order of levels_asked(), with at most five failures. The kernel is one
// of the record's, and the others are its yardsticks. `searches` has, by precision, what certify's search found, and
// `diagnosed` what the kernel is like: a level that either contradicts is not met.
std::vector<LevelStatement> levels_of(const Record& record, const std::string& kernel,
                                      const NamedValues<SearchedStatement>& searches,
                                      std::span<const DiagnosedStatement> diagnosed = {});

// The sentence that says what is proved of a built-in kernel at a level; empty where nothing is.
std::string proved_at(const std::string& kernel, const AskedLevel& asked);

}  // namespace axiscert

// A certificate for people: a page and a text of the same content, and a badge.
#pragma once

#include <string>

#include "fuzz/text/json.h"
#include "reports/instrument/instrument.h"

namespace axiscert {

// The statement conforms to certificate.schema.json. `command` is what made it.
InstrumentReport certificate_report(const Json& statement, const std::string& command);

// The same for a terminal: sentences are wrapped at 110 columns.
std::string certificate_words(const InstrumentReport& report);

// The state of a level in all precisions together: "not met" where it is not met in one, "not asked" where it was asked
// in none, else "met".
std::string state_of_level(const Json& statement, const std::string& level);

// An SVG: the strongest of exact, conservative and logic that is met, or that none is.
std::string certificate_badge(const Json& statement);

}  // namespace axiscert

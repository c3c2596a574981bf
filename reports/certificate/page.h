// A certificate for people: a page and a text of the same content, and a badge.
#pragma once

#include <string>

#include "reports/certificate/statement/certificate_data.h"
#include "reports/instrument/instrument.h"

namespace axiscert {

// `command` is what made it.
InstrumentReport certificate_report(const CertificateStatement& statement, const std::string& command);

// The same for a terminal: sentences are wrapped at 110 columns.
std::string certificate_words(const InstrumentReport& report);

// An SVG: the strongest of exact, conservative and logic that is met, or that none is, and how much was asked; its
// title has the first lines of the page.
std::string certificate_badge(const CertificateStatement& statement);

}  // namespace axiscert

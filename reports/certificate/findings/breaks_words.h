// The faults of a kernel and what to do about them, for the page.
#pragma once

#include <string>

#include "reports/certificate/statement/certificate_data.h"
#include "reports/instrument/instrument.h"

namespace axiscert {

// A sentence on what breaks first, and what to do.
std::string breaks_note(const CertificatePredicate& predicate);

// Findings of the diagnosis that somebody who uses the kernel has to know; empty where there are none.
std::string peculiarities_note(const CertificatePredicate& predicate);

// The situations in which it is wrong, with what to do in each; no rows for a predicate whose wrong verdicts have
// classes.
InstrumentTable situations_table(const CertificatePredicate& predicate);

}  // namespace axiscert

// The faults of a kernel and what to do about them, for the page.
#pragma once

#include <string>

#include "fuzz/text/json.h"
#include "reports/instrument/instrument.h"

namespace axiscert {

// All of them take a certificate's predicate. A sentence on what breaks first, and what to do.
std::string breaks_note(const Json& predicate);

// Findings of the diagnosis that somebody who uses the kernel has to know; empty where there are none.
std::string peculiarities_note(const Json& predicate);

// The situations in which it is wrong, with what to do in each; no rows for a test whose wrong verdicts have classes.
InstrumentTable situations_table(const Json& predicate);

}  // namespace axiscert

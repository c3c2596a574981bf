// The safe margin of a kernel as a certificate states it, and its sentences on the page.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fuzz/instruments/safe_margin.h"
#include "fuzz/record/kernel_record.h"
#include "reports/certificate/certificate_data.h"
#include "reports/instrument/instrument.h"

namespace axiscert {
// Figures have six digits, rounded up.
MarginStatement margin_statement(const SafeMargin& margin);

// The sentences of a certificate's page about the safe margin.

// The sentences that an engine's programmer needs about one precision: first what r has to grow by in scenes of
// everyday sizes on triangles that have an area, then all else.
std::vector<std::string> margin_notes(const MarginStatement& margin);

// Every size of scene in which a contact was missed.
InstrumentTable margin_table(const SafeMarginStatement& safe_margin);

// A safe margin follows in part from other numbers of the certificate.

// How the reason begins where a kernel has no safe margin since it is not the same kernel twice.
inline constexpr std::string_view margin_answered_otherwise =
    "the kernel answered otherwise when it was asked the same again: ";

// `entry` is the kernel's entry of the reduced record in the margin's precision. Says what does not agree, "it missed
// 12 contacts of the run, and its counts say 13"; empty where all does.
//
// Held to the counts: the run's queries, phantoms and contacts, by what the kernel answered to each. Held to itself:
// parts add up to the whole, the greatest of the parts is the one stated, and factor and amount are those of r and the
// radius from which the kernel says contact. Not derived: that radius, and how many phantoms a growth makes.
std::string margin_fault(const MarginStatement& margin, const KernelRecord& entry);

}  // namespace axiscert

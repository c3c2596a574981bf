// The sentences of a certificate's page about the safe margin.
#pragma once

#include <string>
#include <vector>

#include "reports/certificate/statement/certificate_data.h"
#include "reports/instrument/instrument.h"

namespace axiscert {

// The sentences that an engine's programmer needs about one precision: first what r has to grow by in scenes of
// everyday sizes on triangles that have an area, then all else.
std::vector<std::string> margin_notes(const MarginStatement& margin);

// Every size of scene in which a contact was missed.
InstrumentTable margin_table(const SafeMarginStatement& safe_margin);

}  // namespace axiscert

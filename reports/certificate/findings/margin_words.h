// The sentences of a certificate's page about the safe margin.
#pragma once

#include <string>
#include <vector>

#include "reports/instrument/instrument.h"

namespace axiscert {

// The sentences that an engine's programmer needs about one precision: first what r has to grow by in scenes of
// everyday sizes on triangles that have an area, then all else. `margin`: a member of the predicate's
// safe_margin.precisions.
std::vector<std::string> margin_notes(const Json& margin);

// Every size of scene in which a contact was missed. `safe_margin`: of the predicate.
InstrumentTable margin_table(const Json& safe_margin);

}  // namespace axiscert

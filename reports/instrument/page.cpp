// An instrument's page.
#include "reports/instrument/instrument.h"

namespace axiscert {

std::string instrument_page(const InstrumentReport& report) { return instrument_text(report); }

}  // namespace axiscert

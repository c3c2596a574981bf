// The safe margin of a kernel as a certificate states it.
#pragma once

#include "fuzz/certify/safe_margin.h"
#include "reports/certificate/statement/certificate_data.h"

namespace axiscert {

// Figures have six digits, rounded up.
MarginStatement margin_statement(const SafeMargin& margin);

}  // namespace axiscert

// The safe margin of a kernel as a certificate states it.
#pragma once

#include "fuzz/certify/safe_margin.h"
#include "fuzz/text/json.h"

namespace axiscert {

// Without fractions: figures of six digits, rounded up, as decimal text.
Json margin_json(const SafeMargin& margin);

}  // namespace axiscert

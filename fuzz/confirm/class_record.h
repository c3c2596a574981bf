// The members of the record about the classes of input on which a kernel is wrong.
#pragma once

#include <optional>

#include "fuzz/campaign/counts/class_tally.h"
#include "fuzz/confirm/nearest_kernel.h"
#include "fuzz/queries/address.h"
#include "fuzz/text/json.h"

namespace axiscert {

// By class the wrong verdicts of one family and the deepest of them; a class without any is left out.
Json classes_json(const ClassTally& tally, const AddressOf& address);

// Null where there is none.
Json nearest_json(const std::optional<NearestKernel>& nearest);

}  // namespace axiscert

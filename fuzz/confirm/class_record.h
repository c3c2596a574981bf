// The members of the record about the classes of input on which a kernel is wrong.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "fuzz/campaign/counts/class_tally.h"
#include "fuzz/confirm/nearest_kernel.h"
#include "fuzz/text/json.h"

namespace axiscert {

// By class the wrong verdicts of one family and the deepest of them; a class without any is left out. `address` makes
// the text of a position's address.
Json classes_json(const ClassTally& tally, const std::function<std::string(std::uint64_t)>& address);

// Null where there is none.
Json nearest_json(const std::optional<NearestKernel>& nearest);

}  // namespace axiscert

// A level of --require as the gate of a mutation score (fuzz/mutation/black_box.h).
#pragma once

#include <string>

#include "fuzz/mutation/black_box.h"

namespace axiscert {

// The failures of a record at the level. Throws Error, when it is asked, for a level that does not exist.
Gate gate_at(const std::string& level);

}  // namespace axiscert

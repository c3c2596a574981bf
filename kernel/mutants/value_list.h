// The mutants with a fault of a value, by name.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "kernel/mutants/mutant.h"

namespace axiscert::mutants {

// The names of the faults, "clamp" and "clamp-relative" and so on.
std::vector<std::string> value_fault_names();
// The mutant of an id as "nonstrict~clamp:r:0.01", which is made when it is first asked for and kept; null where the id
// is none of these.
const Mutant* find_value_mutant(std::string_view id);

}  // namespace axiscert::mutants

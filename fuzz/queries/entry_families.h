// The families of a predicate whose numbers are given in one of its entries.
#pragma once

#include "fuzz/queries/family.h"

namespace axiscert {

// In the order of families_of(predicate).
std::vector<const Family*> families_of(const Predicate& predicate, std::size_t entry);

}  // namespace axiscert

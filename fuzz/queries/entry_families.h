// The families of a test whose numbers are given in one of its entries.
#pragma once

#include "fuzz/queries/family.h"

namespace axiscert {

// In the order of families_of(test).
std::vector<const Family*> families_of(const TestDescription& test, std::size_t entry);

}  // namespace axiscert

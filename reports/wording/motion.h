// The first contacts that kernels report, as rows of a table: how late, how early, and how deep that lets the sphere
// in.
#pragma once

#include <string>
#include <vector>

#include "fuzz/record/family_record.h"

namespace axiscert {

const std::vector<std::string>& motion_columns();
// A cell for each column, of the results of a family or of all; "-" where the kernel does not give what it is about.
// Empty in a predicate without measures, and where the kernel gives no time and misses nothing by more than touching.
std::vector<std::string> motion_cells(const FamilyRecord& family);
// The meaning of the columns.
extern const char* const motion_note;

}  // namespace axiscert

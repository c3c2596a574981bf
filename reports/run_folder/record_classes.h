// Conditions on a record's classes of input, and on its decades of depth, that its fields cannot express.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "fuzz/record/kernel_record.h"

namespace axiscert {

// Says what contradicts the family's other counts; empty if nothing does, or the family has no classes.
std::optional<std::string> fault_of_classes(const KernelRecord& kernel, const FamilyRecord& family);
// The same of the depths of a family of `valid` queries, and of those on engine-like queries.
std::optional<std::string> fault_of_depths(const VerdictTally& verdict, std::uint64_t valid);

}  // namespace axiscert

// The cause of a kernel's wrong verdicts, in the words in which every report says it first.
#pragma once

#include <string>

#include "fuzz/record/record.h"

namespace axiscert {

// Why the kernel is wrong: its slack, where it has one, and the class of queries in which it is wrong. Empty where
// neither was found.
std::string cause_sentence(const KernelRecord& kernel);
// "ID binary32: wrong on 206 of 212 spheres nearest to vertex a; right elsewhere (0 of 3,100)". Empty where the entry
// has no cause.
std::string cause_line(const KernelRecord& kernel);
// "shortest witness: it says contact, and is wrong: ax 0, ay 0, ... (ADDRESS)". Empty where there is none.
std::string cause_witness_line(const KernelRecord& kernel, const PlanRecord& plan);

}  // namespace axiscert

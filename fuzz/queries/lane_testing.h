// Runs the same test on each instruction set.
#pragma once

#include <string>

#include "fuzz/sphere_triangle/families/parts/lanes.h"

#include "hwy/targets.h"

namespace axiscert {

// Calls body(name) with Highway's choice set to each of the compiled instruction sets that this machine has, including
// HWY_SCALAR, and restores the choice. Must not run while other threads generate.
template <class Body>
void for_each_instruction_set(Body&& body) {
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    body(std::string(hwy::TargetName(target)));
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

}  // namespace axiscert

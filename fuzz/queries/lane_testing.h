// Asking for the same thing on each instruction set.
#pragma once

#include <string>

#include "fuzz/queries/lanes.h"

#include "hwy/targets.h"

namespace axiscert {

// Calls body(name) with each of the compiled instruction sets that this machine has as Highway's choice, HWY_SCALAR
// among them, and leaves the choice as it was. Not while other threads generate.
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

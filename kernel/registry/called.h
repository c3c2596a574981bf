// A kernel called in a way that the plan does not decide: always on one instruction set, or with floating-point modes
// set.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/kernel.h"

namespace axiscert {

// The floating-point modes that a call can name.
struct CallMode {
  std::string_view name, summary;
  Rounding rounding;
  bool flush;
};
const std::vector<CallMode>& call_modes();

// The kernel of the id KERNEL@WORD[,WORD...], where each word is one of available_targets() or call_modes(), in any
// case. The id of the result has the instruction set first, then the direction of rounding. In a mode the kernel does
// not claim the reference's bits. Throws Error with what is wrong.
Kernel called(const Kernel& kernel, std::string_view words);

// Position of the '@' in the id of a called kernel; empty for any other id. The path of a plug-in may contain an '@'.
std::optional<std::size_t> call_in(std::string_view id);

}  // namespace axiscert

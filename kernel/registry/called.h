// A kernel as somebody calls it: on one instruction set whatever a plan says, or with floating-point modes set.
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

// The kernel of the id KERNEL@WORD[,WORD...], each word one of available_targets() or call_modes(), in any case. Its id
// has the instruction set first, then the direction of rounding. In a mode it does not claim the reference's bits.
// Throws Error with what is wrong.
Kernel called(const Kernel& kernel, std::string_view words);

// Of the id of a called kernel, where its '@' is; nothing for any other. The path of a plug-in may have one in it.
std::optional<std::size_t> call_in(std::string_view id);

}  // namespace axiscert

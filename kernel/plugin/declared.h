// Somebody else's kernel by what it declares of itself, each claim checked.
#pragma once

#include <string>

#include "kernel/outcome.h"
#include "kernel/kernel.h"
#include "kernel/plugin/host_process.h"

namespace axiscert::plugin {

// A claim that cannot be true; a finding about a plug-in, and bad input where a manifest makes it.
struct RefusedClaim {
  FindingKind kind;
  std::string detail;
};
[[noreturn]] void refuse(std::string detail);

// Adds to `kernel` its form in one precision, which is number `index` of what is hosted. Throws Refused.
void add_declared(const Description& d, std::uint32_t index, const HostedPlugin& hosted, Kernel& kernel);

}  // namespace axiscert::plugin

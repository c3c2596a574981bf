// What a file is that the loader does not take for a shared object of this machine.
#pragma once

#include <string>

namespace axiscert::plugin {

// What the file is instead, and what would be right: "it is 32-bit, ...". Empty where its header is that of a shared
// object for this machine, or it cannot be read.
std::string what_it_is_instead(const std::string& path);

}  // namespace axiscert::plugin

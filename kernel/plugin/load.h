// A plug-in as a kernel.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "kernel/kernel.h"

namespace axiscert::plugin {

inline constexpr std::string_view plugin_prefix = "plugin:", peer_prefix = "peer/";

// The kernel of the shared object at `path`, under the id as given. What is wrong with it is among its findings, and it
// then exists in no precision. Throws Error where there is no such file.
Kernel load_plugin(std::string id, const std::string& path);

// The plug-ins that come with axiscert: libraries that answer the same question.
struct Peers {
  struct Absent {
    std::string name, package;
  };
  std::vector<std::string> names;  // that were built, in the order of the alphabet
  std::vector<Absent> absent;      // for want of a package
};
Peers peers();
// Throws Error naming those that there are.
std::string peer_path(std::string_view name);

}  // namespace axiscert::plugin

// A plug-in as a kernel.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/kernel.h"

namespace axiscert::plugin {

inline constexpr std::string_view by_path = "plugin:";  // begins the id of a plug-in that is given by its file

// The kernel of the shared object at `path`, under the id as given. What is wrong with it is among its findings, and it
// then exists in no precision. Throws Error where there is no such file.
Kernel load_plugin(std::string id, const std::string& path);

// Plug-ins that come with axiscert, by the prefix of their ids.
struct Shipped {
  struct Absent {
    std::string name, package;
  };
  std::string_view prefix;         // "peer/": libraries that answer the same question; "fault/": kernels with a fault
  std::vector<std::string> names;  // that were built, in the order of the alphabet
  std::vector<Absent> absent;      // for want of a package
};
std::vector<Shipped> shipped_plugins();

// The file of an id "plugin:PATH", "peer/NAME" or "fault/NAME"; nothing for any other id. Throws Error where there is
// no such peer or fault.
std::optional<std::string> plugin_path(std::string_view id);

// The path that an id of no kernel looks like: "my_kernel.so" without "plugin:", "Plugin:my_kernel.so", "my_kernel"
// where that file with ".so" is here. Empty for any other.
std::string misnamed_path(std::string_view id);

}  // namespace axiscert::plugin

// A plug-in, or a program, as a kernel.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/kernel.h"

namespace axiscert::plugin {

inline constexpr std::string_view by_path = "plugin:";       // begins the id of a plug-in that is given by its file
inline constexpr std::string_view by_manifest = "program:";  // and of a program, by its manifest

// The kernel of the shared object at `path`, under the id as given. What is wrong with it is among its findings, and it
// then exists in no precision. Throws Error where there is no such file.
Kernel load_plugin(const std::string& id, const std::string& path);

// The kernel of the program whose manifest is at `path`. Nothing is started: that is done when it is first asked.
// Throws Error, in one line, where the file is no manifest, declares what cannot be true, or names a program that is
// not there; and so does the kernel itself, when it is first asked, where the program fails before it has answered
// anything.
Kernel load_program(const std::string& id, const std::string& path);

// Whether an id's file is a manifest, and not a shared object.
bool is_program(std::string_view id, std::string_view file);
inline bool is_program(const Kernel& kernel) { return is_program(kernel.id, kernel.file); }
// Whether the id names a file of its user's: what a record names so is not loaded unasked.
inline bool is_given_by_file(std::string_view id) { return id.starts_with(by_path) || id.starts_with(by_manifest); }

// The files of which a program consists, as far as its manifest shows: itself, those that its command names and that
// are there, those of its `files`, and the lock file of its packages. For a plug-in its one file.
struct KernelFile {
  std::string kind, path;  // "plugin"; "manifest", "program", "program-2", ..., "file", "file-2", ..., "lock"
};
std::vector<KernelFile> files_of(const Kernel& kernel);

// The manifest's text. Throws Error where it cannot be read, or is far too long for one.
std::string manifest_text(const std::string& path);
// The path of the program that a command begins with, as a shell finds it, in a folder; empty where there is none.
std::string program_file(const std::string& word, const std::string& folder);

// Plug-ins that come with axiscert, by the prefix of their ids.
struct ShippedPlugins {
  struct Absent {
    std::string name, package;
    std::string command;  // which installs it; empty: it is a Debian package
  };
  const Predicate* predicate = nullptr;  // that they answer
  // "peer/": libraries that answer the same question; "fault/": kernels with a fault. Of any predicate but the first
  // the id of the predicate comes before: "moving-sphere/peer/".
  std::string prefix;
  std::vector<std::string> names;  // that were built, in the order of the alphabet; then programs that are installed
  std::vector<Absent> absent;      // for want of a package
};
std::vector<ShippedPlugins> shipped_plugins();

// The file of an id "plugin:PATH", "program:MANIFEST", "peer/NAME", "PREDICATE/peer/NAME" or "fault/NAME"; nothing for
// any other id. Throws Error where there is no such peer or fault.
std::optional<std::string> plugin_path(std::string_view id);

// The path that an id of no kernel looks like: "my_kernel.so" without "plugin:", "Plugin:my_kernel.so", "my_kernel"
// where that file with ".so" is here; a manifest without "program:". Empty for any other.
std::string misnamed_path(std::string_view id);

}  // namespace axiscert::plugin

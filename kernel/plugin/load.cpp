#include "kernel/plugin/load.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "kernel/base/names.h"
#include "kernel/base/text.h"
#include "kernel/base/error.h"
#include "kernel/plugin/declared.h"
#include "kernel/plugin/shared_object.h"
#include "kernel/plugin/supervisor.h"

namespace axiscert::plugin {
namespace {

constexpr double load_seconds = 20;  // of processor time; large libraries take their time

// The shared objects of a folder, by their names, at most a hundred.
std::vector<std::string> shared_objects(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  std::error_code unreadable;
  for (std::filesystem::directory_iterator at(folder, unreadable), end; !unreadable && at != end && names.size() < 100;
       at.increment(unreadable)) {
    if (at->path().extension() == ".so") names.push_back(at->path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

// Throws Error, which guesses what file was meant, where the path is not that of a file.
void require_file(const std::string& id, const std::string& path) {
  if (std::filesystem::is_regular_file(path)) return;
  const auto refuse_path = [&](const std::string& what) {
    throw Error(fmt::format("kernel '{}': {} Give the path of a plug-in's shared object, as in {}my_kernel.so", id,
                            what, by_path));
  };
  if (path.empty()) refuse_path(fmt::format("no path after '{}'.", by_path));
  const std::filesystem::path given(path);
  const bool is_folder = std::filesystem::is_directory(given);
  const std::filesystem::path folder = is_folder ? given : given.parent_path();
  const std::vector<std::string> found = shared_objects(folder.empty() ? "." : folder);
  const std::vector<std::string_view> names(found.begin(), found.end());
  if (is_folder) {
    refuse_path(fmt::format("{} is a directory{}.", path,
                            names.empty() ? "" : fmt::format(", which has {}", fmt::join(names, ", "))));
  }
  const std::string_view name = meant(given.filename().string(), names);
  const std::string guess = !name.empty() ? fmt::format("; did you mean {}{}?", by_path, (folder / name).string())
                            : path.find(',') != path.npos ? "; one kernel is given at a time, without commas."
                                                          : ".";
  if (std::filesystem::exists(given)) refuse_path(fmt::format("{} is not a file{}", path, guess));
  refuse_path(fmt::format("there is no file {}{}", path, guess));
}

}  // namespace

std::string misnamed_path(std::string_view id) {
  const auto begins_alike = [&] {
    return id.size() >= by_path.size() - 1 &&
           std::equal(by_path.begin(), by_path.end() - 1, id.begin(),
                      [](char wanted, char given) { return wanted == (given | 0x20); });
  };
  if (id == by_path.substr(0, by_path.size() - 1)) return "PATH.so";
  if (begins_alike() && id.size() > by_path.size() &&
      !std::isalnum(static_cast<unsigned char>(id[by_path.size() - 1]))) {
    return std::string(id.substr(by_path.size()));
  }
  if (id.ends_with(".so") || id.ends_with(".json")) return std::string(id);
  std::error_code ignored;
  const std::string beside = std::string(id) + ".so";
  if (!id.empty() && std::filesystem::is_regular_file(beside, ignored)) return beside;
  return id.find('/') != id.npos && std::filesystem::exists(id, ignored) ? std::string(id) : "";
}

Kernel load_plugin(const std::string& id, const std::string& path) {
  require_utf8(id, "kernel");
  require_file(id, path);
  // With a slash, so that it is this file and not one of that name in the library path.
  const HostedPlugin hosted{std::filesystem::absolute(path).string(), {}};
  Kernel kernel;
  kernel.id = printable_line(id);
  kernel.file = path;
  try {
    HostProcess host(hosted);
    const auto stop = host.start(load_seconds);
    const Control& control = host.control();
    if (stop || control.load_error[0] != 0) {
      if (const std::string instead = what_it_is_instead(hosted.path); !instead.empty()) refuse(instead);
      if (stop) throw RefusedClaim{stop->kind, "while it was loaded: " + stop->detail};
      refuse(printable_line(control.load_error));
    }
    if (control.kernel_count == 0) refuse("its axiscert_plugin(0) gives no kernel");
    if (control.kernel_count > most_kernels) refuse(fmt::format("it has more than {} kernels", most_kernels));
    for (std::uint32_t i = 0; i < control.kernel_count; ++i) add_declared(control.kernels[i], i, hosted, kernel);
    // It is called in the default environment all the same; whoever else loads it is not.
    if (control.changed != 0) {
      kernel.findings.push_back({FindingKind::environment, 0,
                                 fmt::format("loading it left changed: {}; -ffast-math links code that does that",
                                             changed_modes_text(control.changed))});
    }
  } catch (const RefusedClaim& refused) {
    Kernel unusable;
    unusable.id = kernel.id;
    unusable.file = path;
    unusable.summary = "not loaded";
    unusable.predicate = &predicate_named("");
    unusable.is_reference = false;
    unusable.exposes = Exposure::verdict;
    unusable.findings.push_back({refused.kind, 0, refused.detail});
    return unusable;
  }
  return kernel;
}

}  // namespace axiscert::plugin

#include "kernel/plugin/load.h"

#include <elf.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "kernel/base/error.h"
#include "kernel/plugin/declared.h"
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

#if defined(__x86_64__)
constexpr Elf64_Half own_machine = EM_X86_64;
#elif defined(__aarch64__)
constexpr Elf64_Half own_machine = EM_AARCH64;
#else
constexpr Elf64_Half own_machine = EM_NONE;  // not known: any is left to the loader
#endif

std::string machine_name(Elf64_Half machine) {
  switch (machine) {
    case EM_X86_64:
      return "x86-64";
    case EM_386:
      return "32-bit x86";
    case EM_AARCH64:
      return "64-bit ARM";
    case EM_ARM:
      return "32-bit ARM";
    case EM_RISCV:
      return "RISC-V";
    default:
      return fmt::format("a machine of another kind (ELF number {})", machine);
  }
}

constexpr std::string_view how = "`cc -shared -fPIC my_kernel.c -o my_kernel.so` makes one";

std::string no_elf(std::string_view bytes) {
  constexpr std::string_view archive = "!<arch>\n", windows = "MZ";
  constexpr std::string_view mac[] = {"\xcf\xfa\xed\xfe", "\xce\xfa\xed\xfe", "\xca\xfe\xba\xbe"};
  const auto begins = [&](std::string_view with) { return bytes.starts_with(with); };
  if (begins(archive)) return fmt::format("it is a static library, and no shared object: {}", how);
  if (begins(windows)) return fmt::format("it is for Windows, and no shared object of Linux: {}", how);
  if (std::any_of(std::begin(mac), std::end(mac), begins))
    return fmt::format("it is for macOS, and no shared object of Linux: {}", how);
  const auto is_text = [](char c) { return (c >= 0x20 && c < 0x7f) || c == '\t'; };
  const std::string_view line = bytes.substr(0, std::min<std::size_t>(bytes.find_first_of("\r\n"), 40));
  if (!line.empty() && std::all_of(line.begin(), line.end(), is_text))
    return fmt::format("it is no shared object, but begins with the text \"{}\": {}", line, how);
  return fmt::format("it is no shared object: {}", how);
}

// What the file is in place of a shared object for this machine, and what would be right: "it is 32-bit, ...". Empty
// where its header is that of one, or it cannot be read.
std::string what_it_is_instead(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  char bytes[sizeof(Elf64_Ehdr)] = {};
  in.read(bytes, sizeof bytes);
  const auto size = static_cast<std::size_t>(in.gcount());
  if (in.bad()) return "";
  if (size == 0) return fmt::format("it is empty: {}", how);
  if (size < SELFMAG || std::memcmp(bytes, ELFMAG, SELFMAG) != 0) return no_elf({bytes, size});
  if (size < EI_NIDENT + 4) return fmt::format("it is cut short, after {} bytes: compile or copy it again", size);
  Elf64_Half type, machine;  // at the same place in 32 bits
  std::memcpy(&type, bytes + offsetof(Elf64_Ehdr, e_type), sizeof type);
  std::memcpy(&machine, bytes + offsetof(Elf64_Ehdr, e_machine), sizeof machine);
  const std::string own = machine_name(own_machine);
  const bool is_of_another_order = bytes[EI_DATA] != ELFDATA2LSB;
  if (own_machine != EM_NONE && (is_of_another_order || machine != own_machine)) {
    return fmt::format("it is for {}, and this axiscert for {}: compile it for this machine",
                       is_of_another_order ? "a machine of another byte order" : machine_name(machine), own);
  }
  if (bytes[EI_CLASS] != ELFCLASS64) {
    return fmt::format("it is 32-bit, and this axiscert 64-bit for {}: compile it without -m32", own);
  }
  in.clear();
  in.seekg(0, std::ios::end);
  const auto there = static_cast<std::uint64_t>(in.tellg());
  Elf64_Ehdr header;  // its table of sections is the last part of what a linker writes
  std::memcpy(&header, bytes, sizeof header);
  const std::uint64_t whole = header.e_shoff + std::uint64_t{header.e_shnum} * header.e_shentsize;
  if (size < sizeof header || whole > there)
    return fmt::format("it is cut short, after {} of {} bytes: compile or copy it again", there, whole);
  if (type == ET_REL) return fmt::format("it is an object file, which is not linked: {}", how);
  if (type == ET_EXEC) return fmt::format("it is a program, and no shared object: {}", how);
  return "";
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

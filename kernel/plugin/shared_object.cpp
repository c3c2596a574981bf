#include "kernel/plugin/shared_object.h"

#include <elf.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <string_view>

namespace axiscert::plugin {
namespace {

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

}  // namespace

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

}  // namespace axiscert::plugin

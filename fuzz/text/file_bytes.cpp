#include "fuzz/text/file_bytes.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "kernel/base/error.h"

namespace axiscert {
namespace {

Error unreadable(const std::string& name, int system_error) {
  return Error(
      fmt::format("{}: cannot be read: {}", name, system_error != 0 ? std::strerror(system_error) : "input error"));
}

}  // namespace

std::size_t read_block(std::istream& in, std::span<char> block, const std::string& name) {
  errno = 0;
  in.read(block.data(), static_cast<std::streamsize>(block.size()));
  if (in.bad()) throw unreadable(name, errno);
  return static_cast<std::size_t>(in.gcount());
}

std::string read_bytes(std::istream& in, const std::string& name) {
  std::string bytes;
  std::array<char, 1 << 16> block;
  while (const std::size_t got = read_block(in, block, name)) bytes.append(block.data(), got);
  if (!in.eof()) throw unreadable(name, errno);
  return bytes;
}

std::ifstream open_file(const std::string& path) {
  // A directory can be opened like a file.
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) throw Error(fmt::format("{}: is a directory, not a file", path));
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file.is_open()) throw unreadable(path, errno);
  return file;
}

std::string read_bytes(const std::string& path) {
  std::ifstream file = open_file(path);
  return read_bytes(file, path);
}

Unwritable::Unwritable(const std::string& path, int system_error, std::optional<std::uint64_t> size)
    : Error(fmt::format("{}: cannot be written: {}{}", path,
                        system_error != 0 ? std::strerror(system_error) : "output error",
                        size ? fmt::format("; it has {} bytes", *size) : "")) {}

std::string base_name(const std::string& path) {
  const std::string name = std::filesystem::path(path).filename().string();
  require_utf8(name, "file");
  return printable_line(name);
}

}  // namespace axiscert

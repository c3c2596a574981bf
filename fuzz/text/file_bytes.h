// A file's bytes and its name: the bytes that are hashed are those that are parsed.
#pragma once

#include <cstdint>
#include <fstream>
#include <optional>
#include <span>
#include <string>

#include "kernel/base/error.h"

namespace axiscert {

// All functions throw Error that names the file and quotes the system's message. The whole file, or the rest of a
// stream:
std::string read_bytes(const std::string& path);
std::string read_bytes(std::istream& in, const std::string& name);
// Reads part by part: fills the block and returns the number of bytes read; fewer only at the end.
std::ifstream open_file(const std::string& path);
std::size_t read_block(std::istream& in, std::span<char> block, const std::string& name);

// A file that could not be written: a full disk, a quota, a folder that may not be written.
struct Unwritable : Error {
  // `system_error`: errno of the failed call, or 0. `size`: the bytes that it would have had, where that is known.
  Unwritable(const std::string& path, int system_error, std::optional<std::uint64_t> size);
};

// The last part of the path, as a printable line: all that a record contains about a file's location. Throws Error if
// it is not UTF-8.
std::string base_name(const std::string& path);

}  // namespace axiscert

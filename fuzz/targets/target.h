// Common parts of the fuzz targets: reporting a fault, and the ways in which a parser may treat bad input.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "kernel/base/error.h"

namespace axiscert::fuzzing {

// Prints to standard error and aborts: libFuzzer then keeps the input.
[[noreturn]] void report_fault(std::string_view what);

// Checks a message of Error: it must not be empty, and has to be one line without control characters.
void check_message(std::string_view message);

// Whether a parser accepts its input. It may refuse only by Error; any other exception ends the target.
template <class Parse>
bool accepts(Parse&& parse) {
  try {
    parse();
    return true;
  } catch (const Error& refusal) {
    check_message(refusal.what());
    return false;
  }
}

// Bytes as a file in memory, for functions that read a path; it exists as long as the object.
class MemoryFile {
 public:
  explicit MemoryFile(std::string_view bytes);
  ~MemoryFile();
  MemoryFile(const MemoryFile&) = delete;
  const std::string& path() const { return path_; }

 private:
  int file_;
  std::string path_;
};

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

}  // namespace axiscert::fuzzing

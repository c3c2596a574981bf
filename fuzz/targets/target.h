// What the fuzz targets share: how a fault is told, and what a parser may do with bad input.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "kernel/base/error.h"

namespace axiscert::fuzzing {

// Prints to standard error and aborts: libFuzzer then keeps the input.
[[noreturn]] void fault(std::string_view what);

// What a message of Error is held to: it says something, in one line without control characters.
void check_message(std::string_view message);

// Whether a parser accepts. Error is the one way to refuse; anything else that is thrown ends the target.
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

// Bytes as a file, for what reads a path: in memory, gone with the object.
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

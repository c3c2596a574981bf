#include "fuzz/targets/target.h"

#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

namespace axiscert::fuzzing {

void report_fault(std::string_view what) {
  std::fflush(stdout);
  std::fprintf(stderr, "FAULT: %.*s\n", static_cast<int>(what.size()), what.data());
  std::abort();
}

void check_message(std::string_view message) {
  if (message.empty()) report_fault("an Error without a message");
  for (const char c : message) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
      report_fault(fmt::format("an Error's message has a control character, {:#04x}: {}", static_cast<unsigned char>(c),
                               message));
    }
  }
}

MemoryFile::MemoryFile(std::string_view bytes) : file_(memfd_create("fuzzed", MFD_CLOEXEC)) {
  if (file_ < 0) report_fault("memfd_create failed: no file in memory");
  while (!bytes.empty()) {
    const ssize_t written = write(file_, bytes.data(), bytes.size());
    if (written <= 0) report_fault("a file in memory cannot be written");
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  path_ = fmt::format("/proc/self/fd/{}", file_);
}

MemoryFile::~MemoryFile() { close(file_); }

}  // namespace axiscert::fuzzing

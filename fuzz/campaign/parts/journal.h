// The journal: an append-only file of entries, each with its checksums. What was appended is not lost by a process that
// is killed; an entry that was being written then is dropped.
//
// The file is a line, "axiscert-journal/1 DIGEST\n", DIGEST that of the plan in 64 hex digits, and entries. An entry is
// 16 bytes, little-endian, and its content:
//   u32  length of the content
//   u32  first 4 bytes of SHA-256 over the plan's digest, the entry's offset in the file (u64) and the length
//   u64  first 8 bytes of SHA-256 over the offset and the content
// A length is not believed without its own checksum, or a flipped bit in it would hide all that follows. Checksums that
// know the offset tell an entry that was moved, too. A wrong entry passes with probability 2^-64.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace axiscert {

struct JournalEnd {
  std::uint64_t whole = 0;  // bytes up to which every entry is whole
  std::uint64_t torn = 0;   // bytes after them, of an entry that was being written
};

// Calls visit with the content of each entry. Throws Error where the file cannot be read, is that of another plan, or
// is corrupt: then with the byte at which the entry begins. An entry is torn, and no fault, where the file ends with it
// and it is short, or nothing but zeros, or its content has another checksum: what a kill, a full disk or a power cut
// leaves.
JournalEnd read_journal(const std::string& path, const std::string& plan_digest,
                        const std::function<void(std::string_view)>& visit);

// The one writer of a journal: a second one, in whatever process, is refused.
class Journal {
 public:
  // Creates the file, or goes on with it after its whole entries, of which `visit` is called with each.
  Journal(std::string path, const std::string& plan_digest, const std::function<void(std::string_view)>& visit);
  ~Journal();
  Journal(const Journal&) = delete;
  std::uint64_t torn() const { return torn_; }  // bytes that were dropped at the start
  std::uint64_t bytes() const { return end_; }

  // Throws Error where the system refuses: a full disk, a quota.
  void append(std::string_view content);
  void sync();  // to the disk itself

 private:
  void write(std::string_view bytes);

  std::string path_, plan_digest_;
  int file_;
  std::uint64_t end_ = 0, torn_ = 0;
};

}  // namespace axiscert

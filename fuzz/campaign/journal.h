// The journal: an append-only file of entries, each with its checksums. Appended entries are not lost if the process is
// killed; an entry that was being written at that moment is dropped.
//
// The file is a line, "axiscert-journal/7 DIGEST\n", DIGEST that of the plan in 64 hex digits, and entries. An entry is
// 16 bytes, little-endian, and its content:
//   u32  length of the content
//   u32  first 4 bytes of SHA-256 over the plan's digest, the entry's offset in the file (u64) and the length
//   u64  first 8 bytes of SHA-256 over the offset and the content
// The length has its own checksum, since a flipped bit in it would otherwise hide everything that follows. The
// checksums include the offset and so also detect an entry that was moved. A wrong entry passes with probability 2^-64.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace axiscert {

struct JournalEnd {
  std::uint64_t whole = 0;  // bytes up to which every entry is whole
  std::uint64_t torn = 0;   // bytes after that, of an entry that was being written
};

// Calls visit with the content of each entry. Throws Error if the file cannot be read, is that of another plan, or is
// corrupt: the message then gives the byte at which the entry begins. The last entry is torn, which is not a fault, if
// it is short, or nothing but zeros, or its content has another checksum: a kill, a full disk or a power cut can leave
// such an entry.
JournalEnd read_journal(const std::string& path, const std::string& plan_digest,
                        const std::function<void(std::string_view)>& visit);

// The only writer of a journal: a second writer, in any process, is refused.
class Journal {
 public:
  // Creates the file, or continues it after its whole entries and calls `visit` with each of these.
  Journal(std::string path, const std::string& plan_digest, const std::function<void(std::string_view)>& visit);
  ~Journal();
  Journal(const Journal&) = delete;
  std::uint64_t torn() const { return torn_; }  // bytes that were dropped at the start
  std::uint64_t bytes() const { return end_; }

  // Throws Error if the system refuses: a full disk, a quota.
  void append(std::string_view content);
  void sync();  // flushes to the disk itself

 private:
  void write(std::string_view bytes);

  std::string path_, plan_digest_;
  int file_;
  std::uint64_t end_ = 0, torn_ = 0;
};

}  // namespace axiscert

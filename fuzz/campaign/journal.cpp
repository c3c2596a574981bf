#include "fuzz/campaign/journal.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <optional>

#include "fuzz/text/file_bytes.h"
#include "kernel/base/sha256.h"
#include "kernel/base/error.h"

namespace axiscert {
namespace {

static_assert(std::endian::native == std::endian::little);

struct Head {
  std::uint32_t length, length_check;
  std::uint64_t content_check;
};
static_assert(sizeof(Head) == 16);

template <class Number>
std::string_view raw(const Number& number) {
  return {reinterpret_cast<const char*>(&number), sizeof number};
}

template <class Number>
Number first_bytes(const std::string& hashed) {
  Number number;
  std::memcpy(&number, sha256(std::as_bytes(std::span(hashed))).data(), sizeof number);
  return number;
}

std::uint32_t length_check(const std::string& plan_digest, std::uint64_t offset, std::uint32_t length) {
  return first_bytes<std::uint32_t>(fmt::format("{}{}{}", plan_digest, raw(offset), raw(length)));
}
std::uint64_t content_check(std::uint64_t offset, std::string_view content) {
  return first_bytes<std::uint64_t>(fmt::format("{}{}", raw(offset), content));
}

constexpr std::string_view any_journal = "axiscert-journal/", journal_format = "axiscert-journal/7";

std::string first_line(const std::string& plan_digest) { return fmt::format("{} {}\n", journal_format, plan_digest); }

// What to do about a journal of another version; empty for one of this version, or for what is no journal.
std::string advice_on(std::string_view start) {
  const bool is_of_another = start.starts_with(any_journal) && !start.starts_with(journal_format);
  return is_of_another ? "; it is of another version: run the plan again into an empty folder" : "";
}

// Reads a file from its start, some bytes at a time: a journal may be larger than memory.
class JournalReader {
 public:
  JournalReader(const std::string& path, const std::string& plan_digest)
      : in_(open_file(path)), path_(path), digest_(plan_digest) {}

  JournalEnd read(const std::function<void(std::string_view)>& visit) {
    const std::string line = first_line(digest_);
    const std::string_view start = next(line.size());
    if (start.size() < line.size() && line.starts_with(start)) return {0, start.size()};
    if (start != line) {
      throw Error(
          fmt::format("{}: is not a journal of this plan: it begins with \"{}\", the plan's journals with \"{}\"{}",
                      path_, start.substr(0, start.find('\n')), line.substr(0, line.size() - 1), advice_on(start)));
    }
    std::uint64_t offset = line.size();
    while (true) {
      const std::string_view bytes = next(sizeof(Head));
      if (bytes.size() < sizeof(Head)) return {offset, bytes.size()};
      Head head;
      std::memcpy(&head, bytes.data(), sizeof head);
      if (head.length_check != length_check(digest_, offset, head.length)) {
        if (const auto zeros = zeros_to_the_end(bytes)) return {offset, *zeros};
        fail(offset);
      }
      const std::string_view content = next(head.length);
      if (content.size() < head.length) return {offset, sizeof head + content.size()};
      if (head.content_check != content_check(offset, content)) {
        if (in_.peek() == std::ifstream::traits_type::eof()) return {offset, sizeof head + content.size()};
        fail(offset);
      }
      visit(content);
      offset += sizeof head + content.size();
    }
  }

 private:
  // Returns fewer bytes at the end of the file.
  std::string_view next(std::size_t size) {
    block_.resize(size);
    return {block_.data(), read_block(in_, block_, path_)};
  }

  std::optional<std::uint64_t> zeros_to_the_end(std::string_view bytes) {
    std::uint64_t count = 0;
    for (; !bytes.empty(); bytes = next(4096)) {
      if (bytes.find_first_not_of('\0') != bytes.npos) return std::nullopt;
      count += bytes.size();
    }
    return count;
  }

  [[noreturn]] void fail(std::uint64_t offset) const {
    throw Error(
        fmt::format("{}: corrupt: the entry at byte {} has changed since it was written; "
                    "restore the file, or truncate it there (truncate -s {}) and run with --resume, which "
                    "repeats the missing work",
                    path_, offset, offset));
  }

  std::ifstream in_;
  const std::string &path_, &digest_;
  std::string block_;
};

}  // namespace

JournalEnd read_journal(const std::string& path, const std::string& plan_digest,
                        const std::function<void(std::string_view)>& visit) {
  return JournalReader(path, plan_digest).read(visit);
}

Journal::Journal(std::string path, const std::string& plan_digest, const std::function<void(std::string_view)>& visit)
    : path_(std::move(path)),
      plan_digest_(plan_digest),
      file_(open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
  if (file_ < 0) throw Error(fmt::format("{}: cannot be written: {}", path_, std::strerror(errno)));
  try {
    if (flock(file_, LOCK_EX | LOCK_NB) != 0) {
      if (errno == EWOULDBLOCK) {
        throw Error(fmt::format("{}: another process is writing it; give another folder, or wait", path_));
      }
      throw Error(fmt::format("{}: cannot be locked ({}); give a folder on a file system that supports locks", path_,
                              std::strerror(errno)));
    }
    std::signal(SIGXFSZ, SIG_IGN);  // makes write() report a file-size limit instead of ending the process
    const JournalEnd end = read_journal(path_, plan_digest, visit);
    torn_ = end.torn;
    end_ = end.whole;
    if (ftruncate(file_, static_cast<off_t>(end_)) != 0 || lseek(file_, 0, SEEK_END) < 0) {
      throw Error(fmt::format("{}: cannot be truncated after its last whole entry: {}", path_, std::strerror(errno)));
    }
    if (end_ == 0) write(first_line(plan_digest));
  } catch (...) {
    close(file_);
    throw;
  }
}

Journal::~Journal() { close(file_); }

void Journal::write(std::string_view bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t written = ::write(file_, bytes.data() + done, bytes.size() - done);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) {
      throw Unwritable(path_, errno, std::nullopt);
    }
    done += static_cast<std::size_t>(written);
  }
  end_ += bytes.size();
}

void Journal::append(std::string_view content) {
  const auto length = static_cast<std::uint32_t>(content.size());
  const Head head{length, length_check(plan_digest_, end_, length), content_check(end_, content)};
  write(fmt::format("{}{}", raw(head), content));
}

void Journal::sync() {
  if (fdatasync(file_) != 0) {
    throw Unwritable(path_, errno, std::nullopt);
  }
}

}  // namespace axiscert

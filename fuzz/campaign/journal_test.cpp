// The journal, truncated at every byte and with every byte changed, either returns the entries that were written or is
// refused.
#include "fuzz/campaign/journal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <fstream>

#include "fuzz/text/file_bytes.h"
#include "kernel/base/error.h"
#include "kernel/base/folders.h"

namespace axiscert {
namespace {

const std::string digest(64, 'a');
const std::vector<std::string> contents = {"first", std::string(300, 'x'), "", std::string("\0\0\0", 3), "last one"};

class JournalTest : public testing::Test {
 protected:
  JournalTest() {
    Journal journal(path_, digest, [](std::string_view) {});
    starts_.push_back(journal.bytes());
    for (const std::string& content : contents) {
      journal.append(content);
      starts_.push_back(journal.bytes());
    }
    bytes_ = read_bytes(path_);
  }

  void write(const std::string& bytes) const { std::ofstream(path_, std::ios::binary) << bytes; }
  std::vector<std::string> read(JournalEnd* end = nullptr) const {
    std::vector<std::string> read;
    const JournalEnd found = read_journal(path_, digest, [&](std::string_view content) { read.emplace_back(content); });
    if (end) *end = found;
    return read;
  }

  const TemporaryFolder folder_;
  const std::string path_ = (folder_.path() / "journal").string();
  std::string bytes_;
  std::vector<std::uint64_t> starts_;  // starts of the entries, and the end of the last one
};

TEST_F(JournalTest, GivesBackWhatWasAppended) { EXPECT_EQ(read(), contents); }

TEST_F(JournalTest, CutOffAnywhereItKeepsTheWholeEntriesAndGoesOn) {
  for (std::size_t size = 0; size < bytes_.size(); ++size) {
    write(bytes_.substr(0, size));
    const auto whole = std::upper_bound(starts_.begin(), starts_.end(), size) - starts_.begin();
    std::vector<std::string> expected(contents.begin(), contents.begin() + std::max<std::ptrdiff_t>(0, whole - 1));
    JournalEnd end;
    EXPECT_EQ(read(&end), expected) << size;
    EXPECT_EQ(end.whole + end.torn, size);
    Journal(path_, digest, [](std::string_view) {}).append("more");
    expected.emplace_back("more");
    EXPECT_EQ(read(&end), expected) << size;
    EXPECT_EQ(end.torn, 0u);
  }
}

TEST_F(JournalTest, RefusalHasNoControlCharacters) {
  write("\x1b[31m\x7f is no journal");
  try {
    read();
    ADD_FAILURE() << "accepted";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("it begins with \"\\u001b[31m\\u007f is no journal\""));
  }
}

TEST_F(JournalTest, AnyByteChangedIsSeen) {
  for (std::size_t i = 0; i < bytes_.size(); ++i) {
    for (const int bit : {0, 3, 7}) {
      std::string changed = bytes_;
      changed[i] = static_cast<char>(changed[i] ^ (1 << bit));
      write(changed);
      const auto after = std::upper_bound(starts_.begin(), starts_.end(), i);
      const bool is_head = after == starts_.begin();
      try {
        JournalEnd end;
        const std::vector<std::string> kept = read(&end);
        // Only the last entry's content can be mistaken for a torn one.
        EXPECT_GE(i, starts_[starts_.size() - 2]) << "byte " << i << " bit " << bit;
        EXPECT_EQ(kept, std::vector<std::string>(contents.begin(), contents.end() - 1));
        EXPECT_GT(end.torn, 0u);
      } catch (const Error& error) {
        const std::string where =
            is_head ? "not a journal of this plan" : "the entry at byte " + std::to_string(*std::prev(after)) + " ";
        EXPECT_THAT(error.what(), testing::HasSubstr(where));
      }
    }
  }
}

TEST_F(JournalTest, ZerosThatAPowerCutLeavesAreATornEntry) {
  write(bytes_ + std::string(5000, '\0'));
  JournalEnd end;
  EXPECT_EQ(read(&end), contents);
  EXPECT_EQ(end.torn, 5000u);
}

TEST_F(JournalTest, EntriesOfAnotherJournalOrInAnotherPlaceAreSeen) {
  EXPECT_THROW(read_journal(path_, std::string(64, 'b'), [](std::string_view) {}), Error);
  // The last entry moved to the place of the first.
  write(bytes_.substr(0, starts_[0]) + bytes_.substr(starts_[4]) + bytes_.substr(starts_[1]));
  EXPECT_THROW(read(), Error);
}

TEST_F(JournalTest, HasOneWriter) {
  const Journal first(path_, digest, [](std::string_view) {});
  EXPECT_THROW(Journal(path_, digest, [](std::string_view) {}), Error);
}

TEST_F(JournalTest, AFullDiskIsToldAndLosesNothing) {
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  {
    Journal journal(path_, digest, [](std::string_view) {});
    const rlimit small{bytes_.size() + 30, before.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
    try {
      journal.append(std::string(1000, 'y'));
      ADD_FAILURE() << "more than fits";
    } catch (const Unwritable& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr("journal: cannot be written: File too large"));
    }
    setrlimit(RLIMIT_FSIZE, &before);
  }
  JournalEnd end;
  EXPECT_EQ(read(&end), contents);
  EXPECT_EQ(end.torn, 30u);
}

}  // namespace
}  // namespace axiscert

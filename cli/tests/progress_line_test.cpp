// A command that takes long, as a person or a log sees it.
#include "cli/progress_line.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <string>

namespace axiscert {
namespace {

// A file in the place of standard error.
class Stream {
 public:
  Stream() : file_(std::tmpfile()) {}
  ~Stream() { std::fclose(file_); }
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;
  std::FILE* file() { return file_; }
  std::string text() {
    std::string text(static_cast<std::size_t>(length()), '\0');
    std::rewind(file_);
    text.resize(std::fread(text.data(), 1, text.size(), file_));
    std::fseek(file_, 0, SEEK_END);
    return text;
  }
  // For the line's own thread to write: however long that takes.
  void wait_for_more(long than) {
    while (length() <= than) std::this_thread::yield();
  }
  long length() { return std::fseek(file_, 0, SEEK_END) == 0 ? std::ftell(file_) : 0; }

 private:
  std::FILE* file_;
};

constexpr ProgressPace at_once_on_a_terminal = {0, 1e-4, true}, at_once_in_a_log = {0, 1e-4, false},
                       never_so_soon = {1e6, 1e6, true};

TEST(ProgressLine, InALogIsALineEachTime) {
  Stream stream;
  {
    ProgressLine line("ladder", at_once_in_a_log, stream.file());
    line.show({3, 96, 3072, 60, "accuracy"});
    stream.wait_for_more(0);
    stream.wait_for_more(stream.length() + 200);
  }
  const std::string text = stream.text();
  EXPECT_EQ(text.find("axiscert: ladder"), 0u) << text;
  EXPECT_NE(text.find("axiscert: ladder: accuracy: 3 of 96 units, about 18"), text.npos) << text;
  EXPECT_EQ(text.back(), '\n');
  EXPECT_EQ(text.find_first_of("\r\x1b"), text.npos) << text;
}

TEST(ProgressLine, OnATerminalIsOneLineThatIsClearedInTheEnd) {
  Stream stream;
  {
    ProgressLine line("map", at_once_on_a_terminal, stream.file());
    line.begin_stage("the witnesses are confirmed");
    stream.wait_for_more(0);
  }
  const std::string text = stream.text();
  EXPECT_EQ(text.find("\r\x1b[Kmap"), 0u);
  EXPECT_EQ(text.find('\n'), text.npos);
  EXPECT_TRUE(text.ends_with("\r\x1b[K")) << text;
}

TEST(ProgressLine, OfACommandThatIsDoneSoonSaysNothing) {
  Stream stream;
  {
    ProgressLine line("map", never_so_soon, stream.file());
    line.show({1, 2, 3, 4});
    line.clear();
  }
  EXPECT_EQ(stream.text(), "");
  {
    ProgressLine line("map", std::nullopt, stream.file());  // quiet
    line.show({1, 2, 3, 4});
  }
  EXPECT_EQ(stream.text(), "");
}

// A computation that reports nothing for long is seen to be alive.
TEST(ProgressLine, IsWrittenWithoutAnyReport) {
  Stream stream;
  {
    ProgressLine line("shrink", at_once_in_a_log, stream.file());
    stream.wait_for_more(0);
  }
  EXPECT_EQ(stream.text().find("axiscert: shrink (0 s)\n"), 0u) << stream.text();
}

TEST(ProgressText, SaysHowFarHowLongAndHowFast) {
  EXPECT_EQ(progress_text({3, 96, 3000, 60}), "3 of 96 units, about 1860 s left; 3000 queries, 50 a second");
  EXPECT_EQ(progress_text({0, 96, 0, 60}), "0 of 96 units");
  EXPECT_EQ(progress_text({7, 0, 100, 10}), "7 units; 100 queries, 10 a second");
  EXPECT_EQ(progress_text({96, 96, 0, 60}), "96 of 96 units");
}

}  // namespace
}  // namespace axiscert

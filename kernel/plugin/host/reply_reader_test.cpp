// Replies in parts of any length, and everything that is none.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

#include "kernel/plugin/host/reply_reader.h"
#include "kernel/plugin/pipe_format.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert::plugin {
namespace {

std::vector<std::byte> bytes_of(std::string_view text) {
  const auto* const begin = reinterpret_cast<const std::byte*>(text.data());
  return {begin, begin + text.size()};
}

const std::vector<std::byte>& batch_header() {
  static const std::vector<std::byte> header =
      bytes_of(program_header(sphere_triangle_predicate(), 0, Precision::binary32));
  return header;
}

std::vector<std::byte> after_header(std::string_view replies) {
  std::vector<std::byte> stream = batch_header();
  const auto more = bytes_of(replies);
  stream.insert(stream.end(), more.begin(), more.end());
  return stream;
}

std::string reply_bytes(std::uint8_t verdict, std::uint8_t flags, std::uint64_t bits) {
  const pipe::ReplyRecord reply{verdict, flags, {}, bits};
  return {reinterpret_cast<const char*>(&reply), sizeof reply};
}

const std::string three_replies = reply_bytes(0, 1, 4) + reply_bytes(1, 1, 1) + reply_bytes(2, 1, 0);

TEST(ReplyReader, TakesPartsOfAnyLength) {
  const auto stream = after_header(three_replies);
  for (std::size_t part = 1; part <= stream.size(); ++part) {
    ReplyReader reader(batch_header(), 3, true);
    for (std::size_t at = 0; at < stream.size(); at += part) {
      EXPECT_FALSE(reader.is_complete());
      const std::size_t size = std::min(part, stream.size() - at);
      EXPECT_EQ(reader.take(std::span(stream).subspan(at, size)), size);
    }
    EXPECT_TRUE(reader.is_complete()) << reader.fault();
    EXPECT_THAT(reader.verdicts(), testing::ElementsAre(0, 1, 2));
    EXPECT_THAT(reader.bits(), testing::ElementsAre(4, 1, 0));
  }
}

TEST(ReplyReader, LeavesWhatComesAfterTheLastReply) {
  const auto stream = after_header(three_replies);
  ReplyReader reader(batch_header(), 2, false);
  EXPECT_EQ(reader.take(stream), stream.size() - sizeof(pipe::ReplyRecord));
  EXPECT_TRUE(reader.is_complete());
}

// Two replies of the moving sphere, each followed by a time in binary32.
TEST(ReplyReader, TakesTheMeasuresAfterEachReply) {
  const Predicate& predicate = find_predicate("moving-sphere");
  const auto header = bytes_of(program_header(predicate, 0, Precision::binary32, 1));
  std::string replies(40, '\0');
  const float times[] = {0.25f, 0.75f};
  for (std::size_t i = 0; i < 2; ++i) {
    replies[20 * i + 1] = 2;  // flags: measures
    std::memcpy(&replies[20 * i + 16], &times[i], sizeof(float));
  }
  auto stream = header;
  for (const std::byte b : bytes_of(replies)) stream.push_back(b);
  for (std::size_t part = 1; part <= 41; part += 4) {
    ReplyReader reader(header, 2, false, sizeof(float));
    for (std::size_t at = 0; at < stream.size(); at += part) {
      reader.take(std::span(stream).subspan(at, std::min(part, stream.size() - at)));
    }
    ASSERT_TRUE(reader.is_complete()) << reader.fault();
    ASSERT_EQ(reader.measures().size(), sizeof times);
    EXPECT_EQ(std::memcmp(reader.measures().data(), times, sizeof times), 0);
  }
  ReplyReader without(header, 2, false, sizeof(float));
  without.take(header);
  without.take(bytes_of(std::string(20, '\0')));
  EXPECT_THAT(without.fault(), testing::HasSubstr("bit 1, which its manifest asks for, that measures follow"));
}

std::string fault_of(const std::vector<std::byte>& stream, bool wants_bits = false, bool is_next = false) {
  ReplyReader reader(batch_header(), 3, wants_bits);
  reader.restart(is_next);
  reader.take(stream);
  EXPECT_FALSE(reader.is_complete());
  return reader.fault();
}

TEST(ReplyReader, SaysWhatIsNoReply) {
  using testing::HasSubstr;
  EXPECT_THAT(fault_of(bytes_of("loading\n")), HasSubstr("but with \"loading\"; messages belong on standard error"));
  EXPECT_THAT(fault_of(bytes_of("AXI says hello")), HasSubstr("\"AXI says hello\""));
  EXPECT_THAT(fault_of(bytes_of("more"), false, true), HasSubstr("after its last reply it wrote more, \"more\""));
  EXPECT_THAT(fault_of(after_header(reply_bytes(0, 2, 0))), HasSubstr("reply 1 of 3 has flags 0x02"));
  EXPECT_THAT(fault_of(after_header(reply_bytes(0, 0, 0) + "text of a program")),
              HasSubstr("reply 2 of 3 has flags 0x65"));
  EXPECT_THAT(fault_of(after_header(reply_bytes(0, 0, 1))), HasSubstr("without the flag"));
  EXPECT_THAT(fault_of(after_header(reply_bytes(0, 0, 0)), true), HasSubstr("no comparison bits"));
  // What a program of an earlier version writes: four bytes a reply.
  EXPECT_THAT(fault_of(after_header(std::string_view("\0\0\0\0\1\0\0\0\0\0\0\0\0\0\0\0", 16))),
              HasSubstr("has bytes 3 to 8 that are not 0"));
  auto changed = batch_header();
  changed[50] ^= std::byte{1};
  EXPECT_THAT(fault_of(changed), HasSubstr("changed the header of its queries, at byte 50"));
}

}  // namespace
}  // namespace axiscert::plugin

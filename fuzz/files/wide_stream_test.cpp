// Streams of a predicate with forty columns, 33 comparisons and two measures.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <deque>
#include <fstream>
#include <sstream>

#include "fuzz/files/streams.h"
#include "kernel/base/error.h"
#include "kernel/base/folders.h"
#include "kernel/base/sha256.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

using pipe::ReplyRecord;
using testing::HasSubstr;

const Predicate& piped_predicate() {
  static std::deque<std::string> names;
  static const Predicate predicate = [] {
    Predicate wide{.id = "wide",
                   .asks = "nothing",
                   .touching = "never",
                   .wrong_answers = {},
                   .entries = {{"first", "any", {{"y", Role::length, "y"}}}, {"numbers", "any", {}}},
                   .comparisons = {},
                   .clauses = {{"all", (std::uint64_t{1} << 33) - 1}},
                   .measures = {{"time", "fraction", "ulps"}, {"height", "length", "u"}}};
    for (std::size_t k = 0; k < 40; ++k) {
      wide.entries[1].columns.push_back({names.emplace_back(fmt::format("x{}", k)), Role::coordinate, "x"});
    }
    for (std::size_t k = 0; k < 33; ++k) wide.comparisons.push_back({names.emplace_back(fmt::format("c{}", k)), 0});
    return checked(wide);
  }();
  return predicate;
}
const Predicate* const known[] = {&sphere_triangle_predicate(), &piped_predicate()};

// Two queries, of the numbers 0 to 39 and 1000 to 1039.
class WideStream : public testing::Test {
 protected:
  void SetUp() override {
    std::ofstream file(path_);
    for (const int base : {0, 1000}) {
      file << R"({"precision":"binary32","predicate":"wide","entry":"numbers","x":[)";
      for (int k = 0; k < 40; ++k) file << (k == 0 ? "" : ",") << base + k;
      file << "]}\n";
    }
  }

  PipePlan plan() const {
    return {1, Precision::binary32, {{query_file_source(path_, Precision::binary32, known), 2}}};
  }

  const TemporaryFolder folder_;
  const std::string path_ = (folder_.path() / "wide_stream.jsonl").string();
};

std::string stream_bytes(const std::vector<ReplyRecord>& replies) {
  return {reinterpret_cast<const char*>(replies.data()), replies.size() * sizeof(ReplyRecord)};
}
ReplyStream read_stream(const std::string& bytes) {
  std::istringstream in(bytes);
  return read_replies(in, "r.bin", {}, known);
}
std::string stream_refusal(const std::string& bytes) {
  try {
    read_stream(bytes);
    return "accepted";
  } catch (const Error& wrong) {
    return wrong.what();
  }
}

// The header with another plan, whose hash is right.
std::string changed(std::string header, const std::string& from = "", const std::string& to = "") {
  pipe::Head head;
  std::memcpy(&head, header.data(), sizeof head);
  if (!from.empty()) header.replace(header.find(from), from.size(), to);
  header.resize((header.size() + pipe::header_multiple - 1) / pipe::header_multiple * pipe::header_multiple, ' ');
  head.header_size = static_cast<std::uint32_t>(header.size());
  head.plan_sha256 = sha256(std::as_bytes(std::span(header).subspan(sizeof head)));
  std::memcpy(header.data(), &head, sizeof head);
  return header;
}

constexpr std::uint64_t all_bits = (std::uint64_t{1} << 33) - 1;

TEST_F(WideStream, HasItsPredicateInTheHeaderAndFortyNumbersARecord) {
  std::string stream;
  write_queries(plan(), QueryEncoding::binary, 1, [&](std::string_view bytes) { stream += bytes; });
  pipe::Head head;
  std::memcpy(&head, stream.data(), sizeof head);
  EXPECT_EQ(head.version, 3u);
  EXPECT_EQ(head.record_size, 160u);
  EXPECT_THAT(stream,
              HasSubstr(R"("precision":"binary32","predicate":"wide","entry":"numbers","columns":40,"sources":[)"));
  ASSERT_EQ(stream.size(), head.header_size + 2 * 160u);
  std::array<float, 80> numbers;
  std::memcpy(numbers.data(), stream.data() + head.header_size, sizeof numbers);
  EXPECT_EQ(numbers[39], 39);
  EXPECT_EQ(numbers[40], 1000);
}

TEST_F(WideStream, RepliesHaveBitsBeyondSixteen) {
  std::vector<ReplyStream> streams;
  streams.push_back(read_stream(header_of(plan()) + stream_bytes({{1, 1, {}, all_bits}, {0, 1, {}, all_bits >> 1}})));
  ASSERT_EQ(streams[0].replies.size(), 2u);
  EXPECT_EQ(streams[0].replies[0].bits, all_bits);
  const StoredReplies replies(std::move(streams));
  const Source& source = *replies.sources()[0];
  EXPECT_EQ(&source.predicate(), &piped_predicate());
  EXPECT_EQ(source.entry(), 1u);
  EXPECT_EQ(replies.at(source, Precision::binary32, 0).verdict, Verdict::separated);
  EXPECT_EQ(replies.at(source, Precision::binary32, 1).verdict, Verdict::contact);
}

TEST_F(WideStream, AWrongReplyIsNamed) {
  const std::string header = header_of(plan());
  const auto expect_fault = [&](const ReplyRecord& wrong, const std::string& part) {
    EXPECT_EQ(stream_refusal(header + stream_bytes({{0, 1, {}, 0}, wrong})),
              fmt::format("r.bin: reply 2 of 2, at byte {}: {}", header.size() + 16, part));
  };
  expect_fault({0, 1, {}, all_bits}, "contact, but its comparison bits 0x1ffffffff say separated");
  expect_fault({1, 1, {0, 0, 0, 0, 0, 1}, all_bits}, "bytes 3 to 8 of the reply are not 0");
  expect_fault({0, 1, {}, all_bits + 1},
               "comparison bits 0x200000000, but the predicate wide has 33 comparisons; the other bits are 0");
  EXPECT_THAT(stream_refusal(header + stream_bytes({{0, 1, {}, 0}})), HasSubstr("ends after 1 of 2 replies"));
  EXPECT_THAT(stream_refusal(header + stream_bytes({{0, 1, {}, 0}}) + "1234"),
              HasSubstr("4 bytes of the next; a reply has 16"));
}

// Each reply is followed by two numbers of the stream's precision, and says so in its flags.
TEST_F(WideStream, MeasuresFollowTheReplies) {
  PipePlan measured = plan();
  measured.measures = 2;
  const std::string header = header_of(measured);
  EXPECT_THAT(header, HasSubstr(R"("columns":40,"measures":2,"sources":[)"));
  const auto reply = [](std::uint8_t flags, std::array<float, 2> numbers) {
    return stream_bytes({{0, flags, {}, 0}}) + std::string(reinterpret_cast<const char*>(numbers.data()), 8);
  };
  std::vector<ReplyStream> streams;
  streams.push_back(read_stream(header + reply(2, {0.25F, 7}) + reply(2, {1, -INFINITY})));
  const StoredReplies replies(std::move(streams));
  const Source& source = *replies.sources()[0];
  EXPECT_EQ(replies.measure_count(), 2u);
  EXPECT_EQ(replies.measures(source, Precision::binary32, 0), (std::vector<double>{0.25, 7}));
  EXPECT_EQ(replies.measures(source, Precision::binary32, 1), (std::vector<double>{1, -INFINITY}));

  EXPECT_EQ(
      stream_refusal(header + reply(2, {}) + reply(0, {})),
      fmt::format("r.bin: reply 2 of 2, at byte {}: flags 0x00, without bit 1: the plan asks for 2 measures after "
                  "each reply",
                  header.size() + 24));
  EXPECT_THAT(stream_refusal(header + reply(2, {}) + stream_bytes({{0, 2, {}, 0}})),
              HasSubstr("ends after 1 of 2 replies and 16 bytes of the next; a reply has 24"));
  EXPECT_THAT(stream_refusal(header_of(plan()) + stream_bytes({{0, 2, {}, 0}, {0, 2, {}, 0}})),
              HasSubstr("flags 0x02; bit 0 says that comparison bits are given, the others are 0"));
  measured.measures = 3;
  EXPECT_THAT([&] { header_of(measured); },
              testing::ThrowsMessage<Error>(
                  "3 measures, but the predicate wide has 2, from time to height (`axiscert predicates`)"));
  EXPECT_THAT(stream_refusal(changed(header, "\"measures\":2", "\"measures\":9") + reply(2, {})),
              HasSubstr("r.bin: its plan has 9 measures, but the predicate wide has 2"));
}

TEST_F(WideStream, APlanOfAnotherPredicateOrEntryIsRefused) {
  const std::string header = header_of(plan()), replies = stream_bytes({{0, 0, {}, 0}, {0, 0, {}, 0}});
  EXPECT_EQ(stream_refusal(changed(header) + replies), "accepted");
  EXPECT_THAT(stream_refusal(changed(header, "\"wide\",\"entry\":\"numbers\",\"columns\":40",
                                     "\"sphere-triangle\",\"entry\":\"vertices\",\"columns\":13") +
                             replies),
              HasSubstr("its plan is of the predicate sphere-triangle, entry vertices, but"));
  EXPECT_THAT(stream_refusal(changed(header, "\"columns\":40", "\"columns\":39") + replies),
              HasSubstr("its plan has 39 columns, but wide, entry numbers, has 40 here"));
  EXPECT_THAT(stream_refusal(changed(header, "\"numbers\",\"columns\":40", "\"first\",\"columns\":1") + replies),
              HasSubstr("its plan is of the predicate wide, entry first, but queries/wide_stream.jsonl has queries of "
                        "wide, entry numbers here"));
  std::istringstream in(header + replies);
  EXPECT_THAT([&] { read_replies(in, "r.bin", {}); },
              testing::ThrowsMessage<Error>(HasSubstr("unknown predicate 'wide'")));
}

TEST_F(WideStream, SourcesOfTwoPredicatesAreNoStream) {
  PipePlan mixed = plan();
  mixed.parts.push_back({family_source(find_family("general")), 3});
  EXPECT_THAT([&] { header_of(mixed); },
              testing::ThrowsMessage<Error>("a stream is of one predicate and one entry: queries/wide_stream.jsonl "
                                            "has queries of wide, entry numbers, but general has queries of "
                                            "sphere-triangle, entry vertices"));
}

TEST_F(WideStream, AFileOfTwoPredicatesIsNoSource) {
  std::ofstream(path_, std::ios::app) << R"({"precision":"binary32","predicate":"wide","y":1})"
                                      << "\n";
  EXPECT_THAT([&] { plan(); }, testing::ThrowsMessage<Error>(
                                   path_ + ": it has 2 queries of wide, entry numbers, 1 of wide, and here the "
                                           "queries of a file have one predicate and one entry"));
}

}  // namespace
}  // namespace axiscert

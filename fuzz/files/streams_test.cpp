// The pipe's streams: a written stream can be read, and every fault of a reply stream gives one clear message.
#include "fuzz/files/streams.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <sstream>

#include "kernel/base/error.h"
#include "kernel/base/folders.h"
#include "kernel/base/sha256.h"
#include "kernel/base/version.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

using pipe::ReplyRecord;

PipePlan plan_of(Precision precision = Precision::binary32, std::uint64_t seed = 7) {
  return {seed, precision, {{family_source(find_family("general")), 3}, {family_source(find_family("tie")), 2}}};
}

std::string bytes_of(const std::vector<ReplyRecord>& replies) {
  return {reinterpret_cast<const char*>(replies.data()), replies.size() * sizeof(ReplyRecord)};
}

// Five replies, each unlike the one before.
const std::vector<ReplyRecord> good_replies = {
    {0, 0, {}, 0}, {1, 0, {}, 0}, {2, 0, {}, 0}, {3, 0, {}, 0}, {0, 0, {}, 0}};
const std::vector<ReplyRecord> good_bits = {
    {0, 1, {}, 0}, {1, 1, {}, 1}, {2, 1, {}, 0xffff}, {3, 1, {}, 0}, {1, 1, {}, 0xc000}};

ReplyStream read(const std::string& bytes, const FilePlaces& places = {}) {
  std::istringstream in(bytes);
  return read_replies(in, "r.bin", places);
}

// The message about a stream that cannot be read: one line that begins with the stream's name.
std::string reply_refusal(const std::string& bytes) {
  try {
    read(bytes);
    return "accepted";
  } catch (const Error& wrong) {
    const std::string message = wrong.what();
    EXPECT_EQ(message.substr(0, 7), "r.bin: ");
    EXPECT_EQ(message.find('\n'), message.npos);
    return message;
  }
}
void expect_refusal(const std::string& bytes, const std::string& part) {
  EXPECT_PRED_FORMAT2(testing::IsSubstring, part, reply_refusal(bytes));
}

// A header whose head was modified by `change`; the hash of the plan is correct again.
std::string changed_header(const std::function<void(pipe::Head&)>& change, const std::string& from = "",
                           const std::string& to = "") {
  std::string bytes = header_of(plan_of());
  pipe::Head head;
  std::memcpy(&head, bytes.data(), sizeof head);
  if (!from.empty()) bytes.replace(bytes.find(from), from.size(), to);
  bytes.resize((bytes.size() + pipe::header_multiple - 1) / pipe::header_multiple * pipe::header_multiple, ' ');
  head.header_size = static_cast<std::uint32_t>(bytes.size());
  head.plan_sha256 = sha256(std::as_bytes(std::span(bytes).subspan(sizeof head)));
  change(head);
  std::memcpy(bytes.data(), &head, sizeof head);
  return bytes;
}
const auto nothing = [](pipe::Head&) {};

TEST(Replies, AreReadInTheOrderOfTheSources) {
  const PipePlan plan = plan_of();
  std::vector<ReplyStream> streams;
  streams.push_back(read(header_of(plan) + bytes_of(good_replies)));
  const StoredReplies replies(std::move(streams));
  ASSERT_EQ(replies.sources().size(), 2u);
  const Source &general = *replies.sources()[0], &tie = *replies.sources()[1];
  EXPECT_EQ(general.name(), "general");
  EXPECT_EQ(replies.seed(), 7u);
  EXPECT_EQ(replies.size(general, Precision::binary32), 3u);
  EXPECT_EQ(replies.size(tie, Precision::binary32), 2u);
  EXPECT_EQ(replies.size(tie, Precision::binary64), 0u);
  EXPECT_EQ(replies.at(general, Precision::binary32, 1), (Answer{Verdict::separated, std::nullopt}));
  EXPECT_EQ(replies.at(tie, Precision::binary32, 0), (Answer{Verdict::invalid, std::nullopt}));
  EXPECT_EQ(replies.at(tie, Precision::binary32, 1), (Answer{Verdict::contact, std::nullopt}));
}

TEST(Replies, CarryComparisonBits) {
  std::vector<ReplyStream> streams;
  streams.push_back(read(header_of(plan_of()) + bytes_of(good_bits)));
  const StoredReplies replies(std::move(streams));
  EXPECT_TRUE(replies.has_bits());
  const Source& tie = *replies.sources()[1];
  EXPECT_EQ(replies.at(tie, Precision::binary32, 1), (Answer{Verdict::separated, ComparisonBits{0xc000}}));
  EXPECT_EQ(replies.at(tie, Precision::binary32, 0), (Answer{Verdict::invalid, ComparisonBits{0}}));
}

TEST(Replies, StreamsOfBothPrecisionsShareTheirSources) {
  std::vector<ReplyStream> streams;
  streams.push_back(read(header_of(plan_of(Precision::binary64)) + bytes_of(good_replies)));
  streams.push_back(read(header_of(plan_of()) + bytes_of(good_replies)));
  const StoredReplies replies(std::move(streams));
  EXPECT_EQ(replies.precisions(), (std::vector{Precision::binary32, Precision::binary64}));
  ASSERT_EQ(replies.sources().size(), 2u);
  EXPECT_EQ(replies.at(*replies.sources()[1], Precision::binary64, 0).verdict, Verdict::invalid);
}

TEST(Replies, StreamsThatDoNotGoTogetherAreRefused) {
  const auto both = [](const std::string& first, const std::string& second) -> std::string {
    std::vector<ReplyStream> streams;
    streams.push_back(read(first));
    streams.push_back(read(second));
    try {
      const StoredReplies replies(std::move(streams));
    } catch (const Error& wrong) {
      return wrong.what();
    }
    return "accepted";
  };
  const std::string stream = header_of(plan_of()) + bytes_of(good_replies);
  const auto other = [](std::uint64_t seed, const std::vector<ReplyRecord>& replies) {
    return header_of(plan_of(Precision::binary64, seed)) + bytes_of(replies);
  };
  EXPECT_PRED_FORMAT2(testing::IsSubstring, "a second stream in binary32", both(stream, stream));
  EXPECT_PRED_FORMAT2(testing::IsSubstring, "seeds 7 and 8", both(stream, other(8, good_replies)));
  EXPECT_PRED_FORMAT2(testing::IsSubstring, "comparison bits", both(stream, other(7, good_bits)));
}

TEST(BadReplies, NotTheHeader) {
  expect_refusal("", "empty");
  expect_refusal("Hello world\n", "begins with text, \"Hello world");
  expect_refusal(std::string("\0\1\2\3\0\0\0\0", 8), "does not begin with AXISCERT");
  expect_refusal("AXIS", "ends after 4 bytes, inside the header of 64");
  expect_refusal(header_of(plan_of()).substr(0, 63), "inside the header of 64");
  expect_refusal(header_of(plan_of()).substr(0, 100), "ends after 100 bytes, inside the header of");
}

TEST(BadReplies, TheHeaderWasChanged) {
  const auto expect_change = [](const std::function<void(pipe::Head&)>& change, const std::string& part) {
    expect_refusal(changed_header(change) + bytes_of(good_replies), part);
  };
  EXPECT_EQ(reply_refusal(changed_header(nothing) + bytes_of(good_replies)), "accepted");
  for (const std::uint32_t other : {1u, 2u, 4u}) {
    expect_change(
        [&](pipe::Head& h) { h.version = other; },
        fmt::format("version {} of the format, but this axiscert reads version 3: generate the queries again, "
                    "and reply as docs/pipe.md says",
                    other));
  }
  expect_change([](pipe::Head& h) { h.precision = 64; }, "the header was changed");
  expect_change([](pipe::Head& h) { h.record_size = 104; }, "the header was changed");
  expect_change([](pipe::Head& h) { h.count = 4; }, "it says 4 queries");
  expect_change([](pipe::Head& h) { h.header_size = 65; }, "cannot be 65 bytes long");
  expect_change([](pipe::Head& h) { h.header_size = 64; }, "cannot be 64 bytes long");
  expect_change([](pipe::Head& h) { h.header_size = UINT32_MAX - 63; }, "bytes long");
  expect_change([](pipe::Head& h) { h.plan_sha256[31] ^= std::byte{1}; }, "SHA-256 of its plan");
  std::string plan_changed = header_of(plan_of());
  plan_changed[plan_changed.find("\"queries\":3") + 10] = '4';
  expect_refusal(plan_changed + bytes_of(good_replies), "SHA-256 of its plan");
}

TEST(BadReplies, APlanThatCannotBeMadeHere) {
  const auto expect_plan = [](const std::string& from, const std::string& to, const std::string& part) {
    expect_refusal(changed_header(nothing, from, to) + bytes_of(good_replies), part);
  };
  expect_plan("{\"axis", "[\"axis", "not one that this axiscert writes");
  expect_plan("\"seed\":7", "\"seed\":x", "not one that this axiscert writes");
  expect_plan("\"seed\":7", "\"seed\":1e30",
              "in its plan 'seed': 1e+30 is not a whole number from 0 to 18446744073709551615");
  expect_plan("\"seed\":7", "\"seed\":-7", "in its plan 'seed': -7 is not a whole number");
  // control characters must not reach the terminal
  expect_plan("\"seed\":7", "\"see\x7f\xff\":7", "last read: '\"see\\u007f\\xff");
  expect_plan("\"seed\":7", "\"sees\":7", "not one that this axiscert writes");
  for (const char* member : {"predicate", "entry", "columns"}) {
    expect_plan(fmt::format("\"{}\":", member), fmt::format("\"no {}\":", member), "not one that this axiscert writes");
  }
  expect_plan(std::string("\"axiscert\":\"") + axiscert_version, "\"axiscert\":\"0.0.9", "made by axiscert 0.0.9");
  expect_plan("\"version\":2", "\"version\":9", "version 9 of the generator general, which is at version 2");
  expect_plan("\"name\":\"general\"", "\"name\":\"special\"", "unknown family 'special'");
  expect_plan("\"kind\":\"family\"", "\"kind\":\"folder\"", "unknown kind 'folder'");
}

TEST(BadReplies, TooFewOrTooMany) {
  const std::string stream = header_of(plan_of()) + bytes_of(good_replies);
  expect_refusal(header_of(plan_of()), "ends after 0 of 5 replies");
  expect_refusal(stream.substr(0, stream.size() - sizeof(ReplyRecord)), "ends after 4 of 5 replies");
  expect_refusal(stream.substr(0, stream.size() - 1), "ends after 4 of 5 replies and 15 bytes of the next");
  expect_refusal(stream + '\0', "continues after 5 of 5 replies");
  expect_refusal(stream + "done\n", "it is text, \"done");
}

TEST(BadReplies, OneIsWrong) {
  const std::string header = header_of(plan_of());
  const auto expect_fault = [&](std::vector<ReplyRecord> replies, std::size_t k, ReplyRecord wrong,
                                const std::string& part) {
    replies[k] = wrong;
    expect_refusal(header + bytes_of(replies),
                   fmt::format("reply {} of 5, at byte {}: {}", k + 1, header.size() + sizeof(ReplyRecord) * k, part));
  };
  expect_fault(good_replies, 2, {4, 0, {}, 0}, "verdict 4; 0 is contact");
  expect_fault(good_replies, 4, {255, 0, {}, 0}, "verdict 255");
  expect_fault(good_replies, 1, {0, 2, {}, 0}, "flags 0x02");
  expect_fault(good_replies, 1, {0, 0x81, {}, 0}, "flags 0x81");
  expect_fault(good_replies, 3, {0, 1, {}, 0}, "comparison bits, but the replies before it have none");
  expect_fault(good_bits, 3, {0, 0, {}, 0}, "no comparison bits, but");
  expect_fault(good_replies, 0, {0, 0, {}, 5}, "comparison bits 0x0005 without the flag");
  expect_fault(good_bits, 0, {0, 1, {}, 1}, "contact, but its comparison bits 0x0001 say separated");
  expect_fault(good_bits, 0, {1, 1, {}, 2}, "separated, but its comparison bits 0x0002 say contact");
  const std::string text =
      header + bytes_of(good_replies).substr(0, 2 * sizeof(ReplyRecord)) + "warning: no device found\n";
  expect_refusal(text, "it is text, \"warning: no devi\": did the program print");
}

// A count is only a claim: no memory is allocated for bytes that never arrive.
TEST(BadReplies, AnEnormousCountEndsWithTheStream) {
  PipePlan plan = plan_of();
  plan.parts[1].queries = (std::uint64_t{1} << 53) - 10;
  expect_refusal(header_of(plan) + bytes_of(good_replies), "ends after 5 of 9007199254740985 replies");
  plan.parts[1].queries += 10;
  EXPECT_THROW(header_of(plan), Error);
}

TEST(QueryStream, AHeaderHasALimit) {
  PipePlan plan = plan_of();
  while (plan.parts.size() < 20000) plan.parts.push_back(plan.parts.front());
  EXPECT_THROW(header_of(plan), Error);
}

class InFolder : public testing::Test {
 protected:
  const TemporaryFolder folder_;
};

using RepliesToAFile = InFolder;

TEST_F(RepliesToAFile, TheFileIsFoundAndKnown) {
  const std::string csv = "ax,ay,az,bx,by,bz,cx,cy,cz,px,py,pz,r\n0,0,0,1,0,0,0,1,0,0,0,1,0.5\n";
  const std::string path = folder_.write("q.csv", csv);
  const PipePlan plan{1, Precision::binary64, {{query_file_source(path, Precision::binary64), 1}}};
  const std::string stream = header_of(plan) + bytes_of({{1, 0, {}, 0}});
  EXPECT_EQ(read(stream).plan.parts[0].source->name(), "queries/q.csv");
  folder_.write("q.csv", csv + "0,0,0,1,0,0,0,1,0,0,0,1,0.25\n");
  expect_refusal(stream, "is not the file that the queries come from");
  std::filesystem::create_directory(folder_.path() / "elsewhere");
  const std::string moved = folder_.write("elsewhere/q.csv", csv);
  EXPECT_EQ(read(stream, {{"q.csv", moved}}).replies.size(), 1u);
  std::filesystem::remove(path);
  expect_refusal(stream, "give its present path with --queries FILE");
}

TEST_F(RepliesToAFile, APathThatIsNotUtf8IsRefused) {
  const std::string path =
      folder_.write("\xff.csv", "ax,ay,az,bx,by,bz,cx,cy,cz,px,py,pz,r\n0,0,0,1,0,0,0,1,0,0,0,1,1\n");
  EXPECT_THROW(query_file_source(path, Precision::binary32), Error);
  // A folder may have any name, but not in a header.
  std::filesystem::create_directory(folder_.path() / "\xff");
  std::filesystem::rename(path, folder_.path() / "\xff/good.csv");
  const PipePlan plan{1,
                      Precision::binary32,
                      {{query_file_source((folder_.path() / "\xff/good.csv").string(), Precision::binary32), 1}}};
  EXPECT_THROW(header_of(plan), Error);
}

// The bytes do not depend on threads, and are the queries' own.
TEST(QueryStream, IsHeaderAndRecords) {
  PipePlan plan = plan_of(Precision::binary64);
  plan.parts[0].queries = 4096 * 3 + 1;  // several blocks and a short last one
  std::string one, four;
  write_queries(plan, QueryEncoding::binary, 1, [&](std::string_view bytes) { one += bytes; });
  write_queries(plan, QueryEncoding::binary, 4, [&](std::string_view bytes) { four += bytes; });
  EXPECT_EQ(one, four);
  const std::string header = header_of(plan);
  EXPECT_EQ(header.size() % 64, 0u);
  ASSERT_EQ(one.size(), header.size() + plan.queries() * 104);
  EXPECT_EQ(one.substr(0, header.size()), header);
  const auto expect_record = [&](std::uint64_t k, const PipePlan::Part& part, std::uint64_t position) {
    std::array<double, coordinate_count> record;
    std::memcpy(record.data(), one.data() + header.size() + k * sizeof record, sizeof record);
    const Query<double> q = part.source->make<double>(plan.seed, position);
    EXPECT_EQ(record, coordinates(q)) << k;
  };
  expect_record(0, plan.parts[0], 0);
  expect_record(4096 * 3, plan.parts[0], 4096 * 3);
  expect_record(4096 * 3 + 1, plan.parts[1], 0);
  expect_record(4096 * 3 + 2, plan.parts[1], 1);
}

TEST(QueryStream, AFailedWriteComesOut) {
  const auto full = [](std::string_view) { throw Error("full"); };
  EXPECT_THROW(write_queries(plan_of(), QueryEncoding::json_lines, 2, full), Error);
}

}  // namespace
}  // namespace axiscert

// The queries read back from a written line and from a whole query file.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <filesystem>
#include <sstream>

#include "fuzz/files/query_file.h"
#include "fuzz/files/query_testing.h"
#include "fuzz/sphere_triangle/families/parts/sphere_triangle_query.h"
#include "fuzz/queries/random.h"
#include "kernel/sphere_triangle/description.h"
#include "fuzz/queries/source.h"
#include "kernel/base/error.h"
#include "kernel/base/temporary_folder.h"

namespace axiscert {
namespace {

// A line with the given radius and first coordinate.
std::string line(const std::string& precision, const std::string& r, const std::string& ax = "0") {
  return R"({"id":"ok","precision":")" + precision + R"(","a":[)" + ax +
         R"(,0,0],"b":[1,0,0],"c":[0,1,0],"p":[0,0,1],"r":)" + r + "}";
}

template <class Real>
void line_round_trip() {
  using Bits = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;
  Stream random(1, name_hash("query_file_predicate"), 1, precision_of<Real>, 0);
  std::string file;
  std::vector<StoredQuery> written;
  for (int i = 0; i < 500; ++i) {
    std::array<Real, coordinate_count> v;
    for (Real& x : v) x = std::bit_cast<Real>(static_cast<Bits>(random.bits()));
    written.push_back({"say \"" + std::to_string(i) + "\"\\\n\xc3\xa4", precision_of<Real>, from_coordinates(v),
                       &sphere_triangle_predicate()});
    file += query_line(written.back()) + "\n";
  }
  std::istringstream in(file);
  const auto read = read_queries(in, "f.jsonl", Precision::binary32);
  ASSERT_EQ(read.size(), written.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    EXPECT_EQ(read[i].id, written[i].id);
    EXPECT_EQ(read[i].precision, precision_of<Real>);
    EXPECT_EQ(query_line(read[i]), query_line(written[i]));
    expect_same_bits(sphere_triangle_query_in<Real>(read[i]), sphere_triangle_query_in<Real>(written[i]));
  }
}
TEST(QueryFile, AWrittenLineReadsBackTheSame) {
  line_round_trip<float>();
  line_round_trip<double>();
  EXPECT_EQ(query_line({"parry-76", Precision::binary32, Query<float>{{1, 0, 0}, {0, -0.0f, 0}, {}, {}, 0.2f},
                        &sphere_triangle_predicate()}),
            R"({"id":"parry-76","precision":"binary32","a":["0x1p+0","0x0p+0","0x0p+0"],)"
            R"("b":["0x0p+0","-0x0p+0","0x0p+0"],"c":["0x0p+0","0x0p+0","0x0p+0"],)"
            R"("p":["0x0p+0","0x0p+0","0x0p+0"],"r":"0x1.99999ap-3"})");
  // An id that is not UTF-8 cannot be JSON; the query must not be lost with it.
  EXPECT_NO_THROW(
      parse_queries(query_line({"\xff", Precision::binary64, Query<double>{}, &sphere_triangle_predicate()}), "f.jsonl",
                    Precision::binary32));
}

TEST(QueryFile, AFileThatCannotBeReadIsNamed) {
  EXPECT_THROW(read_query_file(std::filesystem::temp_directory_path(), Precision::binary32), Error);
  try {
    read_query_file("/nowhere/at all.jsonl", Precision::binary32);
    FAIL();
  } catch (const Error& wrong) {
    EXPECT_STREQ(wrong.what(), "/nowhere/at all.jsonl: cannot be read: No such file or directory");
  }
}

TEST(QuerySource, GivesTheQueriesOfEachPrecisionInOrder) {
  const TemporaryFolder folder;
  const std::string text = line("binary32", "0.5") + "\n" + line("binary64", "1") + "\n" + line("binary32", "3") +
                           "\n" + line("binary32", "1", "-0") + "\n";
  const SourcePtr source = query_file_source(folder.write("four.jsonl", text), Precision::binary32);
  EXPECT_EQ(source->name(), "queries/four.jsonl");
  EXPECT_EQ(source->file()->queries, 4u);
  EXPECT_EQ(source->file()->kind, "queries");
  EXPECT_EQ(source->address_name(), "queries-" + source->file()->sha256);
  EXPECT_EQ(source->fixed_size(Precision::binary32), 3u);
  EXPECT_EQ(source->fixed_size(Precision::binary64), 1u);
  EXPECT_EQ(source->base_triangles(Precision::binary32, 3), 2u);  // -0 is not 0, bit for bit
  EXPECT_EQ(source->base_triangles(Precision::binary64, 1), 1u);
  const Query<float> q = source->make<float>(99, 1);
  EXPECT_EQ(q.r, 3);
  EXPECT_THROW(source->make<float>(1, 3), Error);
}

TEST(QuerySource, TheHashIsThatOfTheBytes) {
  const TemporaryFolder folder;
  const std::string path = folder.write("one.jsonl", line("binary32", "0.5") + "\n");
  // sha256sum of the same 91 bytes.
  EXPECT_EQ(query_file_source(path, Precision::binary32)->file()->sha256,
            "8441caafebdf9af22f997bf0eab8eebb495dc0c2e0437343bdd83f6a439e0aee");
}

}  // namespace
}  // namespace axiscert

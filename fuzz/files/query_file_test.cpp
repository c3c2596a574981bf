#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include "fuzz/files/query_file.h"
#include "fuzz/queries/random.h"
#include "fuzz/queries/source.h"
#include "fuzz/sphere_triangle/families/parts/sphere_triangle_query.h"
#include "kernel/base/error.h"
#include "kernel/base/folders.h"
#include "kernel/queries_testing.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

using namespace std::string_literals;

const std::string header = "ax,ay,az,bx,by,bz,cx,cy,cz,px,py,pz,r";
const std::string good =
    R"({"id":"ok","precision":"binary32","a":[0,0,0],"b":[1,0,0],"c":[0,1,0],"p":[0,0,1],"r":0.5})";

std::vector<StoredQuery> parse(const std::string& text) { return parse_queries(text, "f.jsonl", Precision::binary32); }

std::string refusal(const std::string& text) {
  try {
    return fmt::format("accepted {} queries", parse(text).size());
  } catch (const Error& wrong) {
    return wrong.what();
  }
}

// Expects a message of one line that begins with `start` and contains `part`.
void expect_message(const std::string& message, const std::string& start, const std::string& part) {
  EXPECT_EQ(message.substr(0, start.size()), start);
  EXPECT_PRED_FORMAT2(testing::IsSubstring, part, message);
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}
std::string place(int line, const std::string& field) {
  return fmt::format("f.jsonl:{}: ", line) + (field.empty() ? "" : "field '" + field + "': ");
}

// A line of JSON with one field's value replaced; an empty value omits the field.
std::string with(const std::string& field, const std::string& value) {
  std::string line = "{";
  for (const auto& [name, usual] :
       std::initializer_list<std::pair<std::string, std::string>>{{"id", "\"q\""},
                                                                  {"precision", "\"binary32\""},
                                                                  {"a", "[0,0,0]"},
                                                                  {"b", "[1,0,0]"},
                                                                  {"c", "[0,1,0]"},
                                                                  {"p", "[0,0,1]"},
                                                                  {"r", "1"}}) {
    const std::string& given = name == field ? value : usual;
    if (!given.empty()) line += fmt::format("{}\"{}\":{}", line.size() > 1 ? "," : "", name, given);
  }
  return line + "}";
}

TEST(QueryFile, ReadsALineAsTheDesignWritesIt) {
  const auto queries =
      parse(R"({"id":"parry-76","precision":"binary32","a":["0x1p+0",-0,"nan"],"b":[1e-45,"inf","-inf"],)"
            R"("c":["0.2",0.2,16777217],"p":[123456789012345678901234567890,-1.5E+3,0],"r":"0x1.99999ap-3"})");
  ASSERT_EQ(queries.size(), 1u);
  EXPECT_EQ(queries[0].id, "parry-76");
  EXPECT_EQ(queries[0].line, 1u);
  const auto q = sphere_triangle_query_in<float>(queries[0]);
  const float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  const Vec3<float> p{123456789012345678901234567890.0f, -1500, 0};
  expect_same_bits(q, {{1, -0.0f, nan}, {0x1p-149f, inf, -inf}, {0.2f, 0.2f, 16777216}, p, 0.2f});
}

TEST(QueryFile, AJsonNumberIsItsCharacters) {
  // Through binary64 the first would round to 1, and -0 would lose its sign.
  const auto queries = parse(with("p", "[ 1.00000005960464477540 ,-0, 18446744073709551617]"));
  const auto q = sphere_triangle_query_in<float>(queries[0]);
  EXPECT_EQ(q.p.x, 0x1.000002p+0f);
  EXPECT_TRUE(std::signbit(q.p.y));
  EXPECT_EQ(q.p.z, 0x1p+64f);
}

TEST(QueryFile, AcceptsWhatIsHarmless) {
  EXPECT_EQ(parse("\xef\xbb\xbf" + good + "\r\n\r\n  \t\n" + good).size(), 2u);
  EXPECT_EQ(parse("\n" + with("id", "") + "\n")[0].id, "line-2");
  EXPECT_EQ(parse(good + "\n" + good + "\n")[1].line, 2u);
  // A witness record's own fields, including nested and repeated ones.
  std::string witness = good;
  witness.insert(1, R"("flips":[{"r":"x","a":[1,[2]]},[]],"kernel":{"r":{}},"kernel":null,"x":true,"n":-1.5,)");
  EXPECT_EQ(parse(witness).size(), 1u);
  EXPECT_EQ(parse(R"({"\u0072":"-0x0p+0",)" + with("r", "").substr(1)).size(), 1u);
}

struct BadLine {
  std::string line, field, reason;
};

TEST(QueryFile, AnErrorNamesFileLineAndField) {
  const std::vector<BadLine> bad = {
      {with("r", "\"0x1.9999999p-3\""), "r", "0x1.9999999p-3 is not exact in binary32; nearest is 0x1.99999ap-3"},
      {with("a", "[0,\"0x1.9999999p-3\",0]"), "a", "element 2: 0x1.9999999p-3 is not exact"},
      {with("r", "1e39"), "r", "1e39 overflows binary32"},
      {with("r", "1e999"), "r", "1e999 overflows binary32"},
      {with("r", "-1e999"), "r", "-1e999 overflows binary32"},
      {with("p", "[0,0,1e999]"), "p", "1e999 overflows"},
      {with("p", "[0,\"1e999\",0]"), "p", "element 2: 1e999 overflows"},
      {with("r", "\"0x1p+128\""), "r", "overflows binary32"},
      {with("r", "\"NaN\""), "r", "'NaN' is not a number"},
      {with("r", "\"\""), "r", "'' is not a number"},
      {with("r", "\" 1\""), "r", "' 1' is not a number"},
      {with("r", "\"1\\n\""), "r", "'1\\n' is not a number"},
      {with("r", "NaN"), "r", "malformed JSON"},
      {with("r", "0x1p-3"), "r", "malformed JSON"},
      {with("r", "01"), "r", "malformed JSON"},
      {with("r", "+1"), "r", "malformed JSON"},
      {with("r", "null"), "r", "null; a number belongs here"},
      {with("r", "[1]"), "r", "an array; a number belongs here"},
      {with("r", "{\"r\":1}"), "r", "an object; a number belongs here"},
      {with("r", ""), "r", "missing"},
      {with("a", ""), "a", "missing"},
      {with("b", "3"), "b", "a number; an array of three numbers belongs here"},
      {with("c", "[1,2]"), "c", "an array of 2"},
      {with("c", "[1,2,3,4]"), "c", "an array of 4"},
      {with("c", "[]"), "c", "an array of 0"},
      {with("c", "[1,[2],3]"), "c", "element 2: an array; a number"},
      {with("c", "[1,2,{}]"), "c", "element 3: an object; a number"},
      {with("c", "[1,true,3]"), "c", "element 2: a boolean; a number"},
      {with("c", "{}"), "c", "an object; an array of three"},
      {with("precision", ""), "precision", "missing; \"binary32\" or \"binary64\" belongs here"},
      {with("precision", "32"), "precision", "a number; \"binary32\" or"},
      {with("precision", "\"float\""), "precision", "unknown precision 'float'; did you mean 'binary32'? precisions"},
      {with("id", "7"), "id", "a number; a string belongs here"},
      {with("r", "1,\"r\":2"), "r", "given twice"},
      {with("r", "1,\"\\u0061\":2"), "a", "given twice"},
      {with("r", "1,\"x\":1e999"), "x", "1e999 overflows"},
      {with("r", "1} x"), "r", "malformed JSON"},
      {with("r", "1}{"), "r", "malformed JSON"},
      {with("r", "1,"), "r", "malformed JSON"},
      {with("r", "\"\xff\""), "r", "malformed JSON"},
      {with("r", "\"1\t\""), "r", "malformed JSON"},
      {"[1,2,3]", "", "an array; a line is one JSON object"},
      {"3", "", "a number; a line is one JSON object"},
      {"hello", "", "malformed JSON at column 1"},
      {"{", "", "malformed JSON"},
      {"{}", "precision", "missing"},
      {std::string("{\"a\0\":1}", 9), "", "a NUL byte"},
      {good + std::string(1, '\0'), "", "a NUL byte"},
  };
  for (const BadLine& b : bad) {
    SCOPED_TRACE(b.line);
    expect_message(refusal(good + "\n\n" + b.line + "\n" + good), place(3, b.field), b.reason);
  }
}

TEST(QueryFile, AMisspeltMemberIsNamedWithTheOneThatWasMeant) {
  const auto renamed = [](const std::string& from, const std::string& to) {
    std::string line = good;
    return line.replace(line.find("\"" + from + "\""), from.size() + 2, "\"" + to + "\"");
  };
  for (const auto& [from, to, says] : std::vector<BadLine>{
           {"precision", "precison", "it has what is not read: 'precison' (did you mean 'precision'?)"},
           {"a", "A", "it has what is not read: 'A' (did you mean 'a'?)"},
           {"r", "radius", "it has what is not read: 'radius' (did you mean 'r'?)"},
           {"p", "centre", "it has what is not read: 'centre' (did you mean 'p'?)"}}) {
    expect_message(refusal(renamed(from, to)), place(1, from), says);
  }
}

TEST(QueryFile, AFieldThatIsNotReadIsToldOnce) {
  std::vector<std::string> told;
  set_query_notes([&](const std::string& note) { told.push_back(note); });
  const std::string more = with("id", "").insert(1, R"("colour":1,"Id":"x","flips":[],"depth":0,)");
  EXPECT_EQ(parse(good + "\n" + more + "\n" + more).size(), 3u);
  set_query_notes({});
  EXPECT_EQ(told, (std::vector<std::string>{"f.jsonl:2: field 'Id' is not read; did you mean 'id'?",
                                            "f.jsonl:2: field 'colour' is not read"}));
}

TEST(QueryFile, CsvOfAnotherKindIsNotMalformedJson) {
  std::string semicolons = header, tabs = header, spaces = header, upper = header, quoted = "\"" + header + "\"";
  std::replace(semicolons.begin(), semicolons.end(), ',', ';');
  std::replace(tabs.begin(), tabs.end(), ',', '\t');
  std::replace(spaces.begin(), spaces.end(), ',', ' ');
  for (char& c : upper) c = c == ',' ? c : static_cast<char>(c & ~0x20);
  for (const auto& [text, says, ignored] :
       std::vector<BadLine>{{semicolons, "CSV whose cells are separated by ';', not by ','", ""},
                            {"id;" + semicolons, "CSV whose cells are separated by ';', not by ','", ""},
                            {tabs, "CSV whose cells are separated by tabs", ""},
                            {spaces, "CSV whose cells are separated by spaces", ""},
                            {quoted, "CSV whose header is quoted", ""},
                            {upper, "column 1 of the header of CSV is 'AX'; names of columns are in lower case", ""},
                            {"0,0,0,1,0,0,0,1,0,0,0,1,1", "CSV without a header: its first line has numbers", ""},
                            {"0;0;0;1;0;0;0;1;0;0;0;1;1", "CSV whose cells are separated by ';'", ""},
                            {"x0,y0,z0", "CSV with another header, 'x0,y0,z0'", ""}}) {
    SCOPED_TRACE(text);
    expect_message(refusal(text + "\n1\n"), place(1, ""), says);
    expect_message(refusal(text), place(1, ""), "the header is [id,]" + header);
  }
  expect_message(refusal(header + "\n0;0;0;1;0;0;0;1;0;0;0;1;1\n"), place(2, "ay"),
                 "1 cell under a header of 13; cells are separated by ',', not by ';'");
}

TEST(QueryFile, EveryTruncationOfALineIsAnErrorThatNamesTheLine) {
  for (std::size_t size = 1; size < good.size(); ++size) {
    expect_message(refusal(good + "\n" + good.substr(0, size)), place(2, ""), "malformed JSON");
  }
  expect_message(refusal(good.substr(0, good.find("\"r\""))), place(1, "p"), "malformed JSON");
}

TEST(QueryFile, NothingToReadIsAnError) {
  for (const std::string& text : {std::string(), "\n\n"s, " \t\r\n"s, "\xef\xbb\xbf"s, header + "\n"}) {
    expect_message(refusal(text), "f.jsonl: no queries", header);
  }
}

TEST(QueryFile, AbsurdInputIsRefusedInOneShortLine) {
  // A stack overflows at a sixteenth of this too.
  constexpr std::size_t long_text = TRIAL_DIVISOR == 1 ? 1 << 20 : 1 << 16;
  const std::vector<std::string> absurd = {std::string(long_text, '['),
                                           with("x", "") + std::string(long_text, 'x'),
                                           with("r", std::string(long_text, '9')),
                                           with("r", "\"" + std::string(long_text, '7') + "z\""),
                                           with("id", std::string(long_text, '{')),
                                           with("a", "[" + std::string(long_text, ',')),
                                           header + "\n" + std::string(long_text, ','),
                                           std::string(long_text, ','),
                                           "{\"" + std::string(long_text, 'k') + "\":!}",
                                           std::string(1000, '\x01'),
                                           with("precision", "\"" + std::string(long_text, 'b') + "\"")};
  for (const std::string& text : absurd) {
    const std::string message = refusal(text);
    expect_message(message, "f.jsonl:", "");
    EXPECT_LT(message.size(), 700u) << text.substr(0, 100);
  }
}

TEST(QueryFile, MessageAboutMalformedJsonHasNoControlCharacters) {
  expect_message(refusal(with("r", "\"\x7f\xff\"")), place(1, "r"), "last read: '\"\\u007f");
  EXPECT_EQ(refusal(with("r", "\"\x7f\xff\"")).find('\x7f'), std::string::npos);
}

TEST(QueryFile, CsvTakesItsPrecisionFromTheCaller) {
  const std::string text = "\xef\xbb\xbf\n " + header + " \r\n0,0,0, 1 ,0,0,\t0,0x1p-1,0,nan,-0,inf,0.2\r\n\n";
  const auto singles = parse_queries(text, "f.csv", Precision::binary32);
  ASSERT_EQ(singles.size(), 1u);
  EXPECT_EQ(singles[0].id, "line-3");
  EXPECT_EQ(sphere_triangle_query_in<float>(singles[0]).r, 0.2f);
  const auto doubles = parse_queries(text, "f.csv", Precision::binary64);
  EXPECT_EQ(doubles[0].precision, Precision::binary64);
  EXPECT_EQ(sphere_triangle_query_in<double>(doubles[0]).r, 0.2);
  const auto named = parse("id," + header + "\nfirst one,0,0,0,1,0,0,0,1,0,0,0,1,1\n,0,0,0,1,0,0,0,1,0,0,0,1,1\n");
  EXPECT_EQ(named[0].id, "first one");
  EXPECT_EQ(named[1].id, "line-3");
}

TEST(QueryFile, CsvErrorsNameTheColumn) {
  const std::string zeros = "0,0,0,1,0,0,0,1,0,0,0,1";
  const std::vector<BadLine> bad = {
      {header + "\n" + zeros, "r", "12 cells under a header of 13"},
      {header + "\n" + zeros + ",1,2", "", "14 cells under a header of 13"},
      {header + "\n" + zeros + ",", "r", "'' is not a number"},
      {header + "\n" + zeros + ",0x1.9999999p-3", "r", "is not exact in binary32"},
      {header + "\n0,1e39" + zeros.substr(3) + ",1", "ay", "1e39 overflows binary32"},
      {"id," + header + "\n\"a\"," + zeros + ",1", "id", "is quoted"},
      {"id," + header + "\n" + zeros + ",1", "r", "13 cells under a header of 14"},
  };
  for (const BadLine& b : bad) {
    SCOPED_TRACE(b.line);
    expect_message(refusal(b.line), place(2, b.field), b.reason);
  }
  expect_message(refusal("ay,ax,az,bx,by,bz,cx,cy,cz,px,py,pz,r\n"), place(1, "ax"), "column 1 of the header is 'ay'");
  expect_message(refusal(header.substr(0, header.size() - 2) + "\n"), place(1, "r"), "column 13");
  expect_message(refusal(header + ",id\n"), place(1, "id"), "column 14");
  expect_message(refusal("x,y,z\n1,2,3\n"), place(1, ""), header);
}

}  // namespace

// The queries read back from a written line and from a whole query file.

namespace {

// A line with the given radius and first coordinate.
std::string line(const std::string& precision, const std::string& r, const std::string& ax = "0") {
  return R"({"id":"ok","precision":")" + precision + R"(","a":[)" + ax +
         R"(,0,0],"b":[1,0,0],"c":[0,1,0],"p":[0,0,1],"r":)" + r + "}";
}

template <class Real>
void line_round_trip() {
  using Bits = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;
  Stream random(1, name_hash("query_file_test"), 1, precision_of<Real>, 0);
  std::string file;
  std::vector<StoredQuery> written;
  for (int i = 0; i < 500; ++i) {
    std::array<Real, coordinate_count> v;
    for (Real& x : v) x = std::bit_cast<Real>(static_cast<Bits>(random.bits()));
    written.push_back({"say \"" + std::to_string(i) + "\"\\\xc3\xa4", precision_of<Real>, from_coordinates(v),
                       &sphere_triangle_predicate()});
    file += query_line(written.back()) + "\n";
  }
  std::istringstream in(file);
  const auto read = read_queries(in, "f.jsonl", Precision::binary32);
  ASSERT_EQ(read.size(), written.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    EXPECT_EQ(read[i].id, printable_line(written[i].id));
    EXPECT_EQ(read[i].precision, precision_of<Real>);
    written[i].id = read[i].id;
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
  EXPECT_EQ(source->cluster(Precision::binary32, 0), source->cluster(Precision::binary32, 1));
  EXPECT_NE(source->cluster(Precision::binary32, 0), source->cluster(Precision::binary32, 2));
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

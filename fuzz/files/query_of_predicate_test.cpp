// Query files of several tests: which predicate and entry a line is of, and the members and columns that these have.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <deque>

#include "fuzz/files/query_file.h"
#include "fuzz/sphere_triangle/families/parts/sphere_triangle_query.h"
#include "fuzz/queries/source.h"
#include "kernel/base/error.h"
#include "kernel/base/temporary_folder.h"
#include "kernel/sphere_triangle/description.h"

namespace axiscert {
namespace {

using testing::HasSubstr;

// A test of forty columns in one group, and of two boxes in another entry.
const Predicate& two_entry_predicate() {
  static std::deque<std::string> names;
  static const Predicate predicate = [] {
    Predicate wide{.id = "wide",
                   .asks = "nothing",
                   .touching = "never",
                   .wrong_answers = {},
                   .entries = {{"numbers", "any", {}},
                               {"boxes",
                                "any",
                                {{"mx", Role::coordinate, "m"},
                                 {"my", Role::coordinate, "m"},
                                 {"a", Role::length, "a"},
                                 {"t", Role::time, "t"}}}},
                   .comparisons = {},
                   .clauses = {},
                   .measures = {}};
    for (std::size_t k = 0; k < 40; ++k) {
      wide.entries[0].columns.push_back({names.emplace_back(fmt::format("x{}", k)), Role::coordinate, "x"});
    }
    return checked(wide);
  }();
  return predicate;
}

std::vector<StoredQuery> parse_known(const std::string& text) {
  const Predicate* const known[] = {&sphere_triangle_predicate(), &two_entry_predicate()};
  return parse_queries(text, "f", Precision::binary64, known);
}
std::string known_refusal(const std::string& text) {
  try {
    return fmt::format("accepted {} queries", parse_known(text).size());
  } catch (const Error& wrong) {
    return wrong.what();
  }
}

std::string forty_numbers() {
  std::string text;
  for (int k = 0; k < 40; ++k) text += fmt::format("{}{}", k == 0 ? "" : ",", k);
  return text;
}

const std::string boxes = R"("precision":"binary64","m":[1,2],"a":"0x1p-1","t":7)";

TEST(QueryOfPredicate, FortyColumnsAreOneArray) {
  const auto queries = parse_known(R"({"predicate":"wide","precision":"binary32","x":[)" + forty_numbers() + "]}");
  ASSERT_EQ(queries.size(), 1u);
  EXPECT_EQ(queries[0].predicate, &two_entry_predicate());
  EXPECT_EQ(queries[0].entry, 0u);
  const auto& numbers = std::get<Numbers<float>>(queries[0].numbers);
  ASSERT_EQ(numbers.size(), 40u);
  EXPECT_EQ(numbers[39], 39);
}

TEST(QueryOfPredicate, PredicateAndEntryMayComeLast) {
  for (const std::string& line : {"{" + boxes + R"(,"entry":"boxes","predicate":"wide"})",
                                  R"({"predicate":"wide","entry":"boxes",)" + boxes + "}"}) {
    const auto queries = parse_known(line);
    ASSERT_EQ(queries.size(), 1u);
    EXPECT_EQ(queries[0].predicate, &two_entry_predicate());
    EXPECT_EQ(queries[0].entry, 1u);
    const auto& numbers = std::get<Numbers<double>>(queries[0].numbers);
    EXPECT_THAT(std::vector<double>(numbers.begin(), numbers.end()), testing::ElementsAre(1, 2, 0.5, 7));
  }
}

TEST(QueryOfPredicate, ALineThatNamesNoEntryIsOfThatWhoseMembersItHas) {
  EXPECT_EQ(parse_known("{" + boxes + R"(,"predicate":"wide"})")[0].entry, 1u);
  EXPECT_EQ(parse_known(R"({"predicate":"wide","precision":"binary32","x":[)" + forty_numbers() + "]}")[0].entry, 0u);
}

TEST(QueryOfPredicate, AWrittenLineReadsBackTheSame) {
  const auto queries = parse_known("{" + boxes + R"(,"id":"q","entry":"boxes","predicate":"wide"})");
  const std::string line = query_line(queries[0]);
  EXPECT_EQ(line, R"({"id":"q","precision":"binary64","predicate":"wide","entry":"boxes","m":["0x1p+0","0x1p+1"],)"
                  R"("a":"0x1p-1","t":"0x1.cp+2"})");
  EXPECT_EQ(query_line(parse_known(line)[0]), line);
}

TEST(QueryOfPredicate, TheHeaderOfCsvTellsPredicateAndEntry) {
  const auto rows = parse_known("id,mx,my,a,t\none,1,2,0.5,7\n");
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].id, "one");
  EXPECT_EQ(rows[0].predicate, &two_entry_predicate());
  EXPECT_EQ(rows[0].entry, 1u);
  EXPECT_EQ(std::get<Numbers<double>>(rows[0].numbers)[3], 7);
  EXPECT_EQ(parse_known("ax,ay,az,bx,by,bz,cx,cy,cz,px,py,pz,r\n0,0,0,1,0,0,0,1,0,0,0,1,1\n")[0].predicate,
            &sphere_triangle_predicate());
}

TEST(QueryOfPredicate, AHeaderThatNoEntryHasIsMeasuredByTheNearest) {
  EXPECT_THAT(known_refusal("mx,my,a\n"),
              HasSubstr("f:1: field 't': column 4 of the header is ''; the header is [id,]mx,my,a,t"));
  EXPECT_THAT(known_refusal("id,q\n"), HasSubstr("the header is [id,]ax,ay,az,bx"));
}

TEST(QueryOfPredicate, AMemberThatMattersIsGivenOnce) {
  const std::string line = R"("predicate":"wide","entry":"boxes",)" + boxes;
  EXPECT_EQ(known_refusal("{" + line + R"(,"b":1,"b":2,"x":1,"x":2})"), "accepted 1 queries");
  EXPECT_EQ(known_refusal("{" + line + R"(,"t":1})"), "f:1: field 't': given twice");
  EXPECT_EQ(known_refusal("{" + line + R"(,"predicate":"wide"})"), "f:1: field 'predicate': given twice");
  EXPECT_EQ(known_refusal(R"({"t":1,)" + line + R"(,"x":)"), "f:1: field 't': given twice");
}

TEST(QueryOfPredicate, WhatIsWrongIsNamed) {
  EXPECT_EQ(known_refusal("{" + boxes + R"(,"predicate":"wid"})"),
            "f:1: field 'predicate': unknown predicate 'wid'; did you mean 'wide'? predicates: wide, sphere-triangle");
  EXPECT_EQ(known_refusal("{" + boxes + R"(,"predicate":3})"),
            "f:1: field 'predicate': a number; the id of a predicate belongs here");
  EXPECT_EQ(known_refusal("{" + boxes + R"(,"predicate":"wide","entry":"box"})"),
            "f:1: field 'entry': predicate 'wide': unknown entry 'box'; did you mean 'boxes'? entries: boxes, numbers");
  EXPECT_EQ(known_refusal(R"({"precision":"binary64","predicate":"wide","m":[1,2],"a":1})"),
            "f:1: field 't': missing; a number belongs here");
  EXPECT_EQ(known_refusal(R"({"precision":"binary64","predicate":"wide","entry":"numbers","m":[1,2],"a":1})"),
            "f:1: field 'x': missing; an array of 40 numbers belongs here; it has what is not read: 'a', 'm'");
  EXPECT_EQ(known_refusal(R"({"precision":"binary64","predicate":"wide","entry":"boxes","m":[1],"a":1,"t":1})"),
            "f:1: field 'm': an array of 1; an array of two numbers belongs here");
  EXPECT_EQ(known_refusal("{" + boxes + "}"), "f:1: field 'a': a string; an array of three numbers belongs here");
}

TEST(QueryOfPredicate, CodeOfSphereTriangleTakesNoOther) {
  const auto queries = parse_known("{" + boxes + R"(,"id":"q","entry":"boxes","predicate":"wide"})");
  EXPECT_THAT([&] { sphere_triangle_query(queries[0]); },
              testing::ThrowsMessage<Error>(
                  "q: a query of the predicate wide; only queries of sphere-triangle are served here"));
}

TEST(QueriesOfPredicates, ARepeatedQueryIsNotIndependent) {
  const std::string head = R"({"predicate":"wide","entry":"boxes","precision":"binary64","m":[1,2],"a":3,"t":)";
  const TemporaryFolder folder;
  const std::string path = folder.write("repeated.jsonl", head + "4}\n" + head + "5}\n" + head + "4}\n");
  const Predicate* const known[] = {&sphere_triangle_predicate(), &two_entry_predicate()};
  const SourcePtr source = query_file_source(path, Precision::binary64, known);
  EXPECT_EQ(source->base_triangles(Precision::binary64, 3), 2u) << "the last numbers differ";
  EXPECT_EQ(source->base_triangles(Precision::binary64, 1), 1u);
}

}  // namespace
}  // namespace axiscert

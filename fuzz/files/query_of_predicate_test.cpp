// Query files of several predicates: which predicate and entry a line is of, and the members and columns that these
// have.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <deque>

#include "fuzz/files/nested_members.h"
#include "fuzz/files/query_file.h"
#include "fuzz/queries/source.h"
#include "fuzz/sphere_triangle/families/parts/sphere_triangle_query.h"
#include "fuzz/text/json.h"
#include "kernel/base/error.h"
#include "kernel/base/folders.h"
#include "kernel/boxes/box_triangle.h"
#include "kernel/boxes/boxes.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

using testing::HasSubstr;

// A predicate of forty columns in one group, and of two boxes in another entry.
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

// Lines of queries whose members are nested: two boxes, in either entry.

namespace {

std::string line_of(const std::string& a, const std::string& b) {
  return R"({"predicate":"box-box","precision":"binary64","a":)" + a + R"(,"b":)" + b + "}";
}
const std::string cube = R"({"m":[0,0,0],"s":[1,1,1],"b":[[1,0,0],[0,1,0],[0,0,1]]})";
const std::string slab = R"({"b":[["0x1p-1",0,0],[0,1,0],[0,0,-1]],"s":[1,2,0.25],"m":[3,4,5]})";
const std::string in_either_way = "with m, s and b, with m, s and q or with min and max";
const std::string axes_due = "an array of three, each an array of three numbers, belongs here";
std::string line_of_triangle(const std::string& box) {
  return R"({"predicate":"box-triangle","precision":"binary64","a":[0,0,0],"b":[1,0,0],"c":[0,1,0],"box":)" + box + "}";
}
const std::string turned = R"({"m":[0,0,0],"s":[1,1,1],"q":[1,0,0,0]})";

std::vector<StoredQuery> parsed_boxes(const std::string& line) { return parse_queries(line, "f", Precision::binary64); }
std::string box_refusal(const std::string& line) {
  try {
    return fmt::format("accepted {}", parsed_boxes(line).size());
  } catch (const Error& wrong) {
    return wrong.what();
  }
}

TEST(BoxQuery, IsReadFromNestedMembersInAnyOrder) {
  const StoredQuery stored = parsed_boxes(line_of(cube, slab)).front();
  EXPECT_EQ(stored.predicate, &box_box_predicate());
  EXPECT_EQ(stored.entry, boxes::MatrixBoxes::entry);
  const auto& numbers = std::get<Numbers<double>>(stored.numbers);
  EXPECT_THAT(std::vector<double>(numbers.begin() + 15, numbers.end()),
              testing::ElementsAre(3, 4, 5, 1, 2, 0.25, 0.5, 0, 0, 0, 1, 0, 0, 0, -1));
}

TEST(BoxQuery, HasTheEntryOfItsMembers) {
  EXPECT_EQ(parsed_boxes(line_of(turned, turned)).front().entry, boxes::QuaternionBoxes::entry);
  EXPECT_EQ(box_refusal(line_of(turned, cube)),
            "f:1: field 'a': a is given by q and b by b; both are given in one way, " + in_either_way);
  EXPECT_EQ(box_refusal(line_of(cube, turned)),
            "f:1: field 'a': a is given by b and b by q; both are given in one way, " + in_either_way);
}

TEST(BoxQuery, IsWrittenNestedAndReadsBackTheSame) {
  const std::string line = query_line(parsed_boxes(line_of(cube, slab)).front());
  EXPECT_EQ(line,
            R"({"id":"line-1","precision":"binary64","predicate":"box-box","a":{"m":["0x0p+0","0x0p+0","0x0p+0"],)"
            R"("s":["0x1p+0","0x1p+0","0x1p+0"],"b":[["0x1p+0","0x0p+0","0x0p+0"],["0x0p+0","0x1p+0","0x0p+0"],)"
            R"(["0x0p+0","0x0p+0","0x1p+0"]]},"b":{"m":["0x1.8p+1","0x1p+2","0x1.4p+2"],)"
            R"("s":["0x1p+0","0x1p+1","0x1p-2"],"b":[["0x1p-1","0x0p+0","0x0p+0"],["0x0p+0","0x1p+0","0x0p+0"],)"
            R"(["0x0p+0","0x0p+0","-0x1p+0"]]}})");
  EXPECT_EQ(query_line(parsed_boxes(line).front()), line);
  const std::string quaternions = query_line(parsed_boxes(line_of(turned, turned)).front());
  EXPECT_THAT(quaternions, testing::HasSubstr(R"("entry":"quaternion","a":{"m":)"));
  EXPECT_EQ(query_line(parsed_boxes(quaternions).front()), quaternions);
}

TEST(BoxQuery, WhatIsWrongIsNamedByItsPath) {
  EXPECT_EQ(box_refusal(line_of(R"({"m":[0,0,0],"s":[1,1],"b":[[1,0,0],[0,1,0],[0,0,1]]})", cube)),
            "f:1: field 'a.s': an array of 2; an array of three numbers belongs here");
  EXPECT_THAT(box_refusal(line_of(cube, R"({"m":[0,0,0],"s":[1,1,1],"b":[[1,0,0],[0,1,"x"],[0,0,1]]})")),
              testing::StartsWith("f:1: field 'b.b.1': element 3: "));
  EXPECT_EQ(box_refusal(R"({"predicate":"box-box","precision":"binary64","a":[0,0,0]})"),
            "f:1: field 'a': an array; an object " + in_either_way + " belongs here");
  EXPECT_EQ(box_refusal(R"({"a":1,)" + line_of(cube, cube).substr(1)), "f:1: field 'a': given twice");
  EXPECT_THAT(box_refusal(line_of(R"({"m":[0,0,0],"m":[0,0,0],"s":[1,1,1],"b":[[1,0,0],[0,1,0],[0,0,1]]})", cube)),
              testing::StartsWith("f:1: field 'a.m': given twice"));
}

TEST(BoxQuery, AMemberThatItsEntryDoesNotReadIsRefused) {
  const std::string four_forms =
      "'box' is an object with m and s, with min and max, with m, s and b or with m, s and q";
  EXPECT_EQ(box_refusal(line_of_triangle(R"({"m":[0,0,0],"s":[1,1,1],"max":[1,1,1]})")),
            "f:1: field 'box.max': not read beside m and s; " + four_forms);
  EXPECT_EQ(box_refusal(line_of_triangle(R"({"m":[0,0,0],"s":[1,1,1],"min":[0,0,0],"max":[1,1,1]})")),
            "f:1: field 'box.max': not read beside m and s; " + four_forms);
  EXPECT_EQ(box_refusal(line_of(R"({"m":[0,0,0],"s":[1,1,1],"q":[1,0,0,0],"b":[[1,0,0],[0,1,0],[0,0,1]]})", cube)),
            "f:1: field 'a.q': not read beside m, s and b; 'a' is an object " + in_either_way);
  EXPECT_EQ(parsed_boxes(line_of_triangle(R"({"m":[0,0,0],"s":[1,1,1]})")).front().entry, boxes::CentreEntry::entry);
  EXPECT_EQ(parsed_boxes(line_of_triangle(R"({"min":[0,0,0],"max":[1,1,1]})")).front().entry,
            boxes::MinmaxEntry::entry);
  EXPECT_EQ(parsed_boxes(line_of_triangle(turned)).front().entry, boxes::TurnedEntry::entry);
  const std::string corners = R"({"min":[0,0,0],"max":[1,1,1]})";
  EXPECT_EQ(parsed_boxes(line_of(corners, corners)).front().entry, boxes::MinmaxBoxes::entry);
  EXPECT_EQ(parsed_boxes(line_of(corners, turned)).front().entry, boxes::MixedBoxes::entry);
}

TEST(BoxQuery, TheAxesAreThreeColumns) {
  for (const auto& [axes, found] :
       {std::pair{"[[1,0,0],[0,1,0]]", "an array of 2"},
        std::pair{"[[1,0,0],[0,1,0],[0,0,1],[0,0,0]]", "an array of 4"},
        std::pair{"[1,0,0,0,1,0,0,0,1]", "an array of 9"},
        std::pair{R"({"0":[1,0,0],"1":[0,1,0],"2":[0,0,1]})", "an object"}, std::pair{"7", "a number"}}) {
    const std::string box = fmt::format(R"({{"m":[0,0,0],"s":[1,1,1],"b":{}}})", axes);
    EXPECT_EQ(box_refusal(line_of(box, cube)), fmt::format("f:1: field 'a.b': {}; {}", found, axes_due));
    EXPECT_EQ(box_refusal(line_of_triangle(box)), fmt::format("f:1: field 'box.b': {}; {}", found, axes_due));
  }
  EXPECT_EQ(box_refusal(line_of(R"({"m":[0,0,0],"s":[1,1,1],"b":[[1,0,0],2,[0,0,1]]})", cube)),
            "f:1: field 'a.b': element 2: a number; an array of three numbers belongs here");
  EXPECT_EQ(box_refusal(line_of(R"({"m":[0,0,0],"s":[1,1,1]})", cube)),
            fmt::format("f:1: field 'a.b': missing; {}; 'a' is an object {}", axes_due, in_either_way));
}

TEST(BoxQuery, TheOutermostMemberAtFaultIsBlamed) {
  EXPECT_EQ(box_refusal(line_of("7", cube)), "f:1: field 'a': a number; an object " + in_either_way + " belongs here");
  EXPECT_EQ(box_refusal(R"({"predicate":"box-box","precision":"binary64","A":)" + cube + R"(,"b":)" + cube + "}"),
            "f:1: field 'a': missing; an object " + in_either_way +
                " belongs here; it has what is not read: 'A' (did you mean 'a'?)");
}

TEST(BoxQuery, TheMemberThatWasMeantIsOneThatIsAbsent) {
  const std::string half = R"({"m":[0,0,0],"half":[1,1,1],"q":[1,0,0,0]})";
  EXPECT_EQ(box_refusal(line_of(half, turned)),
            "f:1: field 'a.s': missing; an array of three numbers belongs here; it has what is not read: 'a.half' (did "
            "you mean 'a.s'?)");
  EXPECT_EQ(box_refusal(line_of(half, half)),
            "f:1: field 'a.s': missing; an array of three numbers belongs here; it has what is not read: 'a.half' (did "
            "you mean 'a.s'?), 'b.half' (did you mean 'b.s'?)");
}

TEST(NestedText, ClosesWhatItOpened) {
  NestedText text;
  for (const char* path : {"x", "a.m", "a.b.0", "a.b.1", "c.d.e", "y"}) text.add(path, "1");
  EXPECT_EQ(std::move(text).take(), R"(,"x":1,"a":{"m":1,"b":[1,1]},"c":{"d":{"e":1}},"y":1)");
}

TEST(NestedText, AMemberIsCreatedWhereItsPathSays) {
  Json object = Json::object();
  for (const char* path : {"x", "a.m", "a.b.0", "a.b.1"}) member_at(object, path) = path;
  EXPECT_EQ(object.dump(), R"({"x":"x","a":{"m":"a.m","b":["a.b.0","a.b.1"]}})");
}

}  // namespace

}  // namespace axiscert

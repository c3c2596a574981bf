// Lines of queries whose members are nested: two boxes, in either entry.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fuzz/files/nested_text.h"
#include "fuzz/files/query_file.h"
#include "kernel/base/error.h"
#include "kernel/boxes/box_triangle.h"
#include "kernel/boxes/boxes.h"

namespace axiscert {
namespace {

std::string line_of(const std::string& a, const std::string& b) {
  return R"({"predicate":"box-box","precision":"binary64","a":)" + a + R"(,"b":)" + b + "}";
}
const std::string cube = R"({"m":[0,0,0],"s":[1,1,1],"b":[[1,0,0],[0,1,0],[0,0,1]]})";
const std::string slab = R"({"b":[["0x1p-1",0,0],[0,1,0],[0,0,-1]],"s":[1,2,0.25],"m":[3,4,5]})";
const std::string in_either_way = "with m, s and b or with m, s and q";
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
  const std::string three_forms = "'box' is an object with m and s, with min and max or with m, s and b";
  EXPECT_EQ(box_refusal(line_of_triangle(R"({"m":[0,0,0],"s":[1,1,1],"q":[1,0,0,0]})")),
            "f:1: field 'box.q': not read beside m and s; " + three_forms);
  EXPECT_EQ(box_refusal(line_of_triangle(R"({"m":[0,0,0],"s":[1,1,1],"min":[0,0,0],"max":[1,1,1]})")),
            "f:1: field 'box.max': not read beside m and s; " + three_forms);
  EXPECT_EQ(box_refusal(line_of(R"({"m":[0,0,0],"s":[1,1,1],"q":[1,0,0,0],"b":[[1,0,0],[0,1,0],[0,0,1]]})", cube)),
            "f:1: field 'a.q': not read beside m, s and b; 'a' is an object " + in_either_way);
  EXPECT_EQ(parsed_boxes(line_of_triangle(R"({"m":[0,0,0],"s":[1,1,1]})")).front().entry, boxes::CentreEntry::entry);
  EXPECT_EQ(parsed_boxes(line_of_triangle(R"({"min":[0,0,0],"max":[1,1,1]})")).front().entry,
            boxes::MinmaxEntry::entry);
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

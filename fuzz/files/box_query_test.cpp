// Lines of queries whose members are nested: two boxes, in either entry.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fuzz/files/nested_text.h"
#include "fuzz/files/query_file.h"
#include "kernel/base/error.h"
#include "kernel/boxes/boxes.h"

namespace axiscert {
namespace {

std::string line_of(const std::string& a, const std::string& b) {
  return R"({"test":"box-box","precision":"binary64","a":)" + a + R"(,"b":)" + b + "}";
}
const std::string cube = R"({"m":[0,0,0],"s":[1,1,1],"b":[[1,0,0],[0,1,0],[0,0,1]]})";
const std::string slab = R"({"b":[["0x1p-1",0,0],[0,1,0],[0,0,-1]],"s":[1,2,0.25],"m":[3,4,5]})";
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
  EXPECT_EQ(stored.test, &box_box_test());
  EXPECT_EQ(stored.entry, boxes::MatrixBoxes::entry);
  const auto& numbers = std::get<Numbers<double>>(stored.numbers);
  EXPECT_THAT(std::vector<double>(numbers.begin() + 15, numbers.end()),
              testing::ElementsAre(3, 4, 5, 1, 2, 0.25, 0.5, 0, 0, 0, 1, 0, 0, 0, -1));
}

TEST(BoxQuery, HasTheEntryOfItsMembers) {
  EXPECT_EQ(parsed_boxes(line_of(turned, turned)).front().entry, boxes::QuaternionBoxes::entry);
  EXPECT_THAT(box_refusal(line_of(turned, cube)),
              testing::StartsWith("f:1: field 'a.b.0': missing; an array of three numbers belongs here; it has what is "
                                  "not read: 'a.q'"));
}

TEST(BoxQuery, IsWrittenNestedAndReadsBackTheSame) {
  const std::string line = query_line(parsed_boxes(line_of(cube, slab)).front());
  EXPECT_EQ(line, R"({"id":"line-1","precision":"binary64","test":"box-box","a":{"m":["0x0p+0","0x0p+0","0x0p+0"],)"
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
  EXPECT_EQ(box_refusal(R"({"test":"box-box","precision":"binary64","a":[0,0,0]})"),
            "f:1: field 'a.m': missing; an array of three numbers belongs here");
  EXPECT_EQ(box_refusal(R"({"a":1,)" + line_of(cube, cube).substr(1)), "f:1: field 'a': given twice");
  EXPECT_THAT(box_refusal(line_of(R"({"m":[0,0,0],"m":[0,0,0],"s":[1,1,1],"b":[[1,0,0],[0,1,0],[0,0,1]]})", cube)),
              testing::StartsWith("f:1: field 'a.m': given twice"));
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

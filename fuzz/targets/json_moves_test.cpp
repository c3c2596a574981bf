// The moves of JSON inputs: each makes the change that it describes, determined by the dice alone, and leaves text that
// is not JSON as it was.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "fuzz/targets/json_mutator.h"
#include "fuzz/text/json.h"

namespace axiscert::fuzzing {
namespace {

using Json = nlohmann::ordered_json;
constexpr std::uint64_t seed = 21;
const std::string document = R"({"name":"q","list":[1,2.5,-3,"x"],"inner":{"flag":true,"none":null}})";

std::string moved(JsonMove move, std::uint64_t position) {
  Stream stream(seed, name_hash("json-moves-test"), 1, Precision::binary32, position);
  Dice dice(stream);
  return moved_json(document, move, dice);
}

class JsonMoveTest : public testing::TestWithParam<int> {};

TEST_P(JsonMoveTest, ChangesTheDocumentIntoAnotherThatIsJson) {
  const auto move = static_cast<JsonMove>(GetParam());
  std::set<std::string> found;
  for (std::uint64_t position = 0; position < 100; ++position) {
    const std::string text = moved(move, position);
    EXPECT_EQ(text, moved(move, position)) << "seed " << seed << ", position " << position;
    EXPECT_TRUE(Json::accept(text)) << "position " << position << ": " << text.substr(0, 200);
    found.insert(text);
  }
  found.erase(document);
  EXPECT_GT(found.size(), 3u) << "seed " << seed;
}

INSTANTIATE_TEST_SUITE_P(Moves, JsonMoveTest, testing::Range(0, static_cast<int>(json_move_count)));

TEST(JsonMoves, ReachDepthsThatNoRecursionStands) {
  std::size_t longest = 0;
  for (std::uint64_t position = 0; position < 100; ++position)
    longest = std::max(longest, moved(JsonMove::nest, position).size());
  EXPECT_GT(longest, 800000u);
}

TEST(JsonMoves, LeaveWhatIsNoJson) {
  Stream stream(seed, 0, 1, Precision::binary32, 0);
  Dice dice(stream);
  for (int move = 0; move < static_cast<int>(json_move_count); ++move) {
    EXPECT_EQ(moved_json("{\"a\":", static_cast<JsonMove>(move), dice), "{\"a\":");
    EXPECT_EQ(moved_json("", static_cast<JsonMove>(move), dice), "");
  }
}

}  // namespace
}  // namespace axiscert::fuzzing

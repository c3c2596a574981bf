// A line of JSON as the members of its object, each value by its own characters.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/files/query_line.h"
#include "kernel/base/enums.h"

namespace axiscert {

enum class JsonKind { absent, null, boolean, number, string, array, object };
template <>
inline constexpr std::size_t enum_count<JsonKind> = 7;
// As messages name them.
inline constexpr EnumArray<JsonKind, std::string_view> json_kind_names = {
    "missing", "null", "a boolean", "a number", "a string", "an array", "an object"};
constexpr std::string_view name(JsonKind kind) { return json_kind_names[kind]; }

struct JsonValue {
  JsonKind kind = JsonKind::absent;
  std::string text;  // for a number its characters, for a string its content
};
struct JsonMember {
  JsonValue value;
  std::vector<JsonValue> elements;  // elements of an array
};

struct LineMembers {
  // By name; of a name that is given again, the last. A nested member, up to four deep, is by its path: "a.m" is member
  // `m` of the object `a`, "b.0" an array that is the first element of the array `b`.
  std::map<std::string, JsonMember, std::less<>> members;
  std::vector<std::string> repeated;  // names that were given again, in their order

  // A member without a value if it was not given.
  const JsonMember& at(std::string_view name) const;
};

// By nlohmann's lexer and grammar, but with the characters of each number instead of the library's value, which has
// gone through double. Throws Error by place.fail() for anything but one JSON object, and for a number that is too
// large for the precision that the line states; `known` are the predicates that the message speaks of. `before_a_fault`
// is called with the members so far, so that it can throw what says more.
LineMembers read_members(std::string_view line, const Place& place, KnownPredicates known,
                         const std::function<void(const LineMembers&)>& before_a_fault);

}  // namespace axiscert

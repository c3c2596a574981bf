// Members by their paths (kernel/predicate.h, PredicateColumn::group) as the text of nested JSON.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fuzz/text/json.h"

namespace axiscert {

// The text of members, each after a comma: `,"a":{"m":1,"b":[[2],[3]]}` of a.m, a.b.0 and a.b.1.
class NestedText {
 public:
  // `value` is JSON. Members that share the beginning of their path follow each other, elements of an array from 0 on.
  void add(std::string_view path, std::string_view value);
  std::string take() &&;

 private:
  void leave(std::size_t depth);

  std::string text_;
  std::vector<std::string> open_;  // the names on the way to the last member
  std::string ends_;               // what closes each of these
};

// The member of this path in an object, created where it is absent.
Json& member_at(Json& object, std::string_view path);

}  // namespace axiscert

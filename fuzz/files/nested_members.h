// The objects and arrays that hold members of a line of JSON: a box is an object, its axes are an array of arrays.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/files/line_members.h"
#include "fuzz/text/json_fwd.h"
#include "kernel/predicate.h"

namespace axiscert {
// Members by their paths (kernel/predicate.h, PredicateColumn::group) as the text of nested JSON.

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

// A count as messages say it.
std::string count_in_words(std::size_t count);

// Whether the member of this path is somewhere in that of the other: "a.m" is in "a".
bool is_within(std::string_view path, std::string_view outer);

// The entry that reads the most of the members given; among equals one whose members are all there, then the first.
std::size_t entry_of_most_members(const Predicate& predicate, const LineMembers& given);

// A member at fault, with the end of the message about it.
struct MemberFault {
  std::string field, says;
  bool is_missing = false;
};

// The members of a line that may be in any of `entries`: all of a predicate, or the one that the line states.
class NestedMembers {
 public:
  NestedMembers(const LineMembers& given, std::span<const PredicateEntry> entries) : given_(given), entries_(entries) {}

  // The first of the members around this group of `entry`, the outermost first, that is missing, of another kind or, as
  // an array, of another length: "field 'a': a number; an object with m, s and b or with m, s and q belongs here".
  std::optional<MemberFault> fault_around(std::string_view group, const PredicateEntry& entry) const;

  // The fault of objects that are complete, each in another entry: one box by its axes, the other by a quaternion.
  std::optional<MemberFault> mixed_entries() const;

  // The fault of a member inside an object of `entry` that this entry does not read.
  MemberFault unread_inside(std::string_view path, const PredicateEntry& entry) const;

 private:
  std::string due(std::string_view path, const PredicateEntry& entry) const;
  std::string object_forms(std::string_view outer) const;
  std::vector<std::string_view> given_form(std::string_view outer) const;
  bool has(std::string_view path) const;

  const LineMembers& given_;
  std::span<const PredicateEntry> entries_;
};

}  // namespace axiscert

// Slacks: lengths by which a kernel answers as if a sphere, a box or a motion were larger or smaller than it is.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "fuzz/text/values.h"
#include "kernel/outcome.h"

namespace axiscert {

// What stays the same from query to query: the length itself, or its part of a length of the query.
enum class SlackKind : std::uint8_t { absolute, relative };
template <>
inline constexpr std::size_t enum_count<SlackKind> = 2;
inline constexpr EnumArray<SlackKind, std::string_view> slack_kind_names = {"absolute", "relative"};
constexpr std::string_view name(SlackKind which) { return slack_kind_names[which]; }

// Early: contact where the two are still apart, as if they were larger.
enum class SlackSide : std::uint8_t { early, late };
template <>
inline constexpr std::size_t enum_count<SlackSide> = 2;
inline constexpr EnumArray<SlackSide, std::string_view> slack_side_names = {"early", "late"};
constexpr std::string_view name(SlackSide which) { return slack_side_names[which]; }

struct SlackRecord {
  SlackKind kind = SlackKind::absolute;
  Name to;
  SlackSide side = SlackSide::early;
  double size = 0, least = 0, greatest = 0, in_units = 0;
  std::uint64_t shown = 0, looked_at = 0;
  Name where;
  QueryLine witness;
  Verdict said = Verdict::contact;

  static constexpr std::string_view about =
      "A slack: on these queries the answer turns from separated to contact too early, or too late, by the same size "
      "within a factor of 2 from its middle.";
  AXISCERT_FIELDS(
      SlackRecord,
      AXISCERT_FIELD(kind, "What is the same on all of them: the length, or its part of a length of the query."),
      AXISCERT_FIELD(to, "The length of which the size is a part; of an absolute slack the queries' unit."),
      AXISCERT_FIELD(side, "Early: contact where the two are apart. Late: separated where they touch."),
      AXISCERT_FIELD(size, "The median, in units of `to`."), AXISCERT_FIELD(least, "The least of those that agree."),
      AXISCERT_FIELD(greatest, "The greatest of those that agree."),
      AXISCERT_FIELD(in_units, "The median as a length in the queries' unit, where shapes are about one unit large."),
      AXISCERT_FIELD(shown, "Queries that agree."),
      AXISCERT_FIELD(looked_at,
                     "Queries whose critical value was bracketed, and whose own rounding is under a tenth of it."),
      AXISCERT_FIELD(where, "The queries on which it shows."),
      AXISCERT_FIELD(witness, "A query between the exact turn and the kernel's: the kernel is wrong on it."),
      AXISCERT_FIELD(said, "What the kernel says of the witness."))
};

// What could have been seen on the queries of one kind.
struct SlackLook {
  Name where;
  std::uint64_t bracketed = 0;
  std::optional<double> least_relative, least_absolute;
  std::optional<double> off_relative, off_absolute;

  static constexpr std::string_view about =
      "The queries of one kind, and the least slack that would have been seen on them.";
  AXISCERT_FIELDS(
      SlackLook, AXISCERT_FIELD(where, "The queries."),
      AXISCERT_FIELD(bracketed, "Queries whose exact turn and whose turn by the kernel are known."),
      AXISCERT_FIELD(least_relative, "The least part of a length that would be seen; null: too few queries for any."),
      AXISCERT_FIELD(least_absolute, "The least length in the queries' unit that would be seen; null: the same."),
      AXISCERT_FIELD(off_relative,
                     "The part of a length by which 24 queries or more turn off the exact turn, by one size "
                     "or by many; null: fewer are off."),
      AXISCERT_FIELD(off_absolute, "The same as a length in the queries' unit; null: the same."))
};

struct SlacksRecord {
  std::uint64_t asked = 0, bracketed = 0, answers = 0;
  std::vector<SlackLook> looks;
  std::vector<Name> blind;
  std::vector<SlackRecord> found;

  static constexpr std::string_view about =
      "Slacks of the kernel, sought after its families by bisection on queries made for it. Null where they were not "
      "looked for: a predicate without critical values, answers of a program, a run that was interrupted.";
  AXISCERT_FIELDS(
      SlacksRecord, AXISCERT_FIELD(asked, "Queries that were made, within what the kernel promises."),
      AXISCERT_FIELD(bracketed, "Those whose exact turn and whose turn by the kernel are known."),
      AXISCERT_FIELD(answers, "Answers that the kernel was asked for."),
      AXISCERT_FIELD(looks, "The same by kind of query, with what could have been seen."),
      AXISCERT_FIELD(blind,
                     "Kinds of query on which nothing could: 32 were made or more, and the kernel's answer turns on "
                     "fewer."),
      AXISCERT_FIELD(found, "The slacks that were found, of one size on the most queries first; none: an empty list."))
};

}  // namespace axiscert

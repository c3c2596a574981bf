// Why a kernel is wrong, by what the exact answers say of the queries.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/record/witness_record.h"
#include "fuzz/text/values.h"
#include "kernel/base/enums.h"
#include "kernel/names.h"

namespace axiscert {

// The queries of which a cause speaks: clear ones, which a right method cannot get wrong; those of families on which
// the precision's arithmetic is exact; or those whose depth is not within rounding. None of them touches.
enum class CauseBasis : std::uint8_t { clear, exact, deep };
template <>
inline constexpr std::size_t enum_count<CauseBasis> = 3;
constexpr std::string_view name(CauseBasis basis) {
  return EnumArray<CauseBasis, std::string_view>{"clear", "exact", "deep"}[basis];
}

// Which verdicts are wrong.
enum class CauseDirection : std::uint8_t { missed, phantom, both };
template <>
inline constexpr std::size_t enum_count<CauseDirection> = 3;
constexpr std::string_view name(CauseDirection direction) {
  return EnumArray<CauseDirection, std::string_view>{"missed", "phantom", "both"}[direction];
}

struct CauseWitness {
  std::string address;
  QueryLine query;
  std::vector<Digits> numbers;
  Verdict answered = Verdict::unanswered, truth = Verdict::unanswered;

  static constexpr std::string_view about = "The wrong verdict of the class whose numbers are the simplest.";
  AXISCERT_FIELDS(CauseWitness, AXISCERT_FIELD(address, "Its address."),
                  AXISCERT_FIELD(query, "A line of a query file, in hexadecimal numbers."),
                  AXISCERT_FIELD(numbers, "The same numbers in decimal, in the order of the columns."),
                  AXISCERT_FIELD(answered, "What the kernel said."), AXISCERT_FIELD(truth, "The exact answer."))
};

struct CauseRecord {
  bool is_known = false;
  std::string phrase;
  std::vector<Name> traits;
  CauseBasis basis = CauseBasis::clear;
  CauseDirection direction = CauseDirection::both;
  std::uint64_t wrong = 0, of = 0, elsewhere_wrong = 0, elsewhere_of = 0;
  std::uint64_t explained = 0, looked_at = 0;
  std::optional<CauseWitness> witness;

  // "wrong on 206 of 212 spheres nearest to vertex a, with an obtuse corner there; right elsewhere (0 of 3,100)".
  std::string sentence() const;

  static constexpr std::string_view about =
      "Why it is wrong: the class of queries, by what the exact answers say of them, within which it is wrong and "
      "elsewhere right. The probe asked the kernel again. Null where nothing was wrong, or no kernel could be asked.";
  AXISCERT_FIELDS(
      CauseRecord, AXISCERT_FIELD(sentence, "All of it in one sentence."),
      field(&Of::is_known, {"known",
                            "Whether the class explains half of the wrong verdicts, or a quarter where it is wrong "
                            "on four fifths of its queries, and is wrong more often than others."}),
      AXISCERT_FIELD(phrase, "The class in words."),
      AXISCERT_FIELD(traits, "The traits that its queries have in common; contact and separated are the exact answer."),
      AXISCERT_FIELD(
          basis,
          "The queries that were asked: clear ones, which a right method cannot get wrong; where none of these is "
          "wrong, those of families with exact arithmetic; where none of these, those whose depth is above 64 u."),
      AXISCERT_FIELD(direction, "The wrong verdicts of the class: missed contacts, phantom ones or both."),
      AXISCERT_FIELD(wrong, "Wrong verdicts in the class."),
      AXISCERT_FIELD(of, "Queries of the class that were asked."),
      AXISCERT_FIELD(elsewhere_wrong, "Wrong verdicts elsewhere."),
      AXISCERT_FIELD(elsewhere_of, "Queries elsewhere that were asked."),
      AXISCERT_FIELD(explained, "Of all wrong verdicts that were looked at, those in the class."),
      AXISCERT_FIELD(looked_at, "Wrong verdicts that were looked at, with those that were looked for."),
      AXISCERT_FIELD(witness, "A wrong verdict of the class."))
};

}  // namespace axiscert

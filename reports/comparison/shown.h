// The numbers and comparisons that a kernel shows, and beside which answers: a greatest error over others is no better.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/record/kernel_record.h"

namespace axiscert {

// The answers that say one verdict, and those of them that have a number.
struct GivenBeside {
  std::uint64_t answers = 0, given = 0;
  std::uint64_t mark = 0;  // of the latter: another mark, other answers; the marks of two sets that share none add by ^

  bool is_all() const { return given == answers; }
};

struct Shown {
  std::string name;  // "comparisons", "sides"; a number by its place: "separation", "normal"
  // A number has both: beside contacts, and beside answers that say separated.
  std::optional<std::array<GivenBeside, 2>> beside = {};
};

// The numbers that a kernel shows in a family, and all that it shows.
std::vector<Shown> shown_in(const FamilyRecord& result);
std::vector<Shown> shown_in(const KernelRecord& entry);

// A figure of a place needs these to be shown; one of verdicts nothing.
std::vector<std::string_view> shown_of(const std::string& place, std::string_view member);

enum class Hiding {
  gone,      // it is not shown any more
  others,    // other answers have it, or fewer
  verdicts,  // the same, since verdicts changed: it stands beside all contacts now, or all that say separated. No fault
};
struct Hidden {
  std::string name;
  std::string text;  // "separation beside 215 of 600 contacts, 430 before"
  Hiding kind;
};
// Lists what was shown and is shown no more, or not beside the same answers: no figure of it is better. Over other
// queries it is told of what stood beside all, and stands not even beside half.
std::vector<Hidden> hidden_since(const std::vector<Shown>& before, const std::vector<Shown>& now,
                                 bool are_same_queries = true);

// The same in words that a file can hold: "shows=comparisons,sides", and of each number
// "separation=600@1f3c9a2b4d5e6f70,0": beside 600 contacts, with a mark of which, and no answer that says separated.
std::vector<std::string> words_of_shown(const std::vector<Shown>& shown);
// Reads such a word; false: it is no such word. Throws Error that names it and says what would be right. `predicate`
// may be null: not known here.
bool add_shown_word(const std::string& word, const Predicate* predicate, std::vector<Shown>& shown);

}  // namespace axiscert

// What a kernel shows beside its verdicts, and beside how many answers: a greatest error over fewer of them is no
// better.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/record/kernel_record.h"

namespace axiscert {

struct Shown {
  std::string name;                           // "comparisons", "sides"; a number by its place: "separation", "normal"
  std::optional<std::uint64_t> answers = {};  // of a number: those that it was judged on
  bool operator==(const Shown&) const = default;
};

// What a kernel shows in a family, which may be empty, and in all of them.
std::vector<Shown> shown_in(const FamilyRecord& result);
std::vector<Shown> shown_in(const KernelRecord& entry);

// All that a kernel of a predicate may show; the numbers among it, each of which has a number of answers.
std::vector<std::string> shown_names(const Predicate& predicate);
bool is_shown_number(std::string_view name);
// Of these, what the figures of a place are about: of "pushed" the normal, of "points" the first of the two.
std::string_view shown_of_place(std::string_view place);

// The verdicts of two runs over the same queries that differ for sure, by their counts: each may take its numbers
// along.
std::uint64_t changed_verdicts(const VerdictTally& before, const VerdictTally& now);

// "separation beside 600 answers, 1,200 before".
struct Hidden {
  std::string name, text;
  bool is_gone;  // beside all answers
};
// What was shown and is shown no more, or beside fewer answers than the changed verdicts explain.
std::vector<Hidden> hidden_since(const std::vector<Shown>& before, const std::vector<Shown>& now,
                                 std::uint64_t changed);

}  // namespace axiscert

// Statements about a record that several formats make in the same way.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/record/record.h"

namespace axiscert {
// A cause of wrong verdicts: its meaning in one sentence, what to do about it, and a section of the documents.
struct CauseWords {
  std::string_view meaning, advice, section;
};
// The words of each broken link.
extern const EnumArray<Link, CauseWords> link_words;

// The families of a kernel combined: what adds up, and the kernel's critical radius. Empty where no family ran.
std::optional<FamilyRecord> all_families(const KernelRecord& kernel);

// "interrupted after 1,234 of 5,678 queries", of a record that is not complete.
std::string interrupted_text(const Record& record);

// Per million valid queries within the limits; 0 where there are none.
double per_million(std::uint64_t count, const FamilyCounts& family);

std::string unquoted_text(const Json& value);      // a text without its quotes; "-" for null
std::string thousands(std::uint64_t count);        // "1,234,567"
std::string amount(double value, int digits = 6);  // significant digits, thousands separated
// "61.2 %", rounded down; "less than 0.1 %", "none".
std::string share_rounded_down(std::uint64_t part, std::uint64_t of);

// Adds "44 declined" to words, where there are any.
void add_count(std::vector<std::string>& words, std::uint64_t count, std::string_view what);
// Queries that a kernel called neither contact nor separated, by its answer.
struct NoVerdict {
  std::uint64_t declined = 0, invalid = 0, unanswered = 0;
};
// "44 declined", "2 called invalid", "7 without an answer": those that there are. `declined` is the word of the first.
std::vector<std::string> no_verdict_words(const NoVerdict& counts, std::string_view declined = "declined");

// An error: a number, or its text where binary64 cannot hold it; empty or null where none was measured.
std::string error_amount(const std::optional<Decimal6>& error);
std::string error_amount(const Json& figure);

// Orders figures in their JSON: numbers, and texts of numbers too large for binary64.
bool is_less(const Json& x, const Json& y);

// A kernel's convention for touching spheres, and the limits within which it promises to be right.
std::string touching_text(const KernelRecord& kernel);
std::string limits_text(const KernelRecord& kernel);

// The deepest witness of each kernel, precision, family and kind of wrong verdict, then the second of each, up to
// `limit`, so that one family of deep faults does not hide the others. Deepest first; those without a depth come last.
std::vector<const WitnessRecord*> worst_witnesses(const Record& record, std::size_t limit);

// Findings of a record, faults of a kernel other than wrong answers, as people read them.

// "plugin:x.so binary32: out_of_bounds on family general, 3 times, first at ADDRESS: DETAIL"; for a finding made in
// loading, "plugin:x.so: load: DETAIL".
std::string finding_text(const FindingRecord& finding);
// The findings of a record, grouped by kind, kernel and precision: the first of each group, then the other families on
// which it occurred. In the record's order.
struct FindingGroup {
  const FindingRecord* first;
  std::vector<const FindingRecord*> others;

  // "also on family tangent (4 times), scale (once)"; empty where there are no others.
  std::string others_text() const;
};
std::vector<FindingGroup> finding_groups(const Record& record);
// Whether the finding is about this kernel of a record; one made in loading is about every entry of its kernel.
bool is_about(const FindingRecord& finding, const KernelRecord& kernel);
// The kernels of the plan that exist in no precision, because they could not be loaded.
std::vector<std::string> not_judged(const Record& record);

}  // namespace axiscert

// Statements about a record that several formats make in the same way.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "exact/judge/judge.h"
#include "fuzz/text/json.h"

namespace axiscert {

// The meaning of a broken link, in one sentence; indexed by Link.
extern const EnumArray<Link, std::string_view> link_meanings;

// Orders figures of a record: numbers, and texts of numbers too large for binary64.
bool is_less(const Json& x, const Json& y);

// Adds counts of a family to others: counts add up, of maxima the greater is kept. `total` may be null.
void add_counts(Json& total, const Json& part);

// The families of a record's kernel combined: counts added, maxima kept, null where every one is null. The median of
// the critical radius is the kernel's own. An object without members where no family ran.
Json all_families(const Json& kernel);

// Per million valid queries within the limits; 0 where there are none.
double per_million(std::uint64_t count, const Json& family);

std::string plain_text(const Json& value);         // a text without its quotes; "-" for null
std::string thousands(std::uint64_t count);        // "1,234,567"
std::string amount(double value, int digits = 6);  // significant digits, thousands separated
// "61.2 %", rounded down; "less than 0.1 %", "none".
std::string share_rounded_down(std::uint64_t part, std::uint64_t of);

// Queries that a kernel called neither contact nor separated, by its answer.
struct NoVerdict {
  std::uint64_t declined = 0, invalid = 0, unanswered = 0;
};
// "44 declined", "2 called invalid", "7 without an answer": those that there are. `declined` is the word of the first.
std::vector<std::string> no_verdict_words(const NoVerdict& counts, std::string_view declined = "declined");

// An error in u as the record has it: a number, its text where binary64 cannot hold it, null where none was measured.
std::string error_amount(const Json& error);

// The kernel entry's convention for touching spheres, and the limits within which it promises to be right.
std::string touching_text(const Json& kernel);
std::string limits_text(const Json& kernel);

// The deepest witness of each kernel, precision, family and kind of wrong verdict, then the second of each, up to
// `limit`, so that one family of deep faults does not hide the others. Deepest first; those without a depth come last.
std::vector<const Json*> worst_witnesses(const Json& record, std::size_t limit);

}  // namespace axiscert

// Output of `axiscert check` for one query.
#pragma once

#include <string>

#include "exact/trait/examine.h"
#include "fuzz/search/confirm.h"
#include "fuzz/confirm/record.h"

namespace axiscert {

// A query of any test as `check` shows it.
struct Checked {
  Truth truth;
  std::optional<Rational> squared_distance;   // of a test that compares one; empty if the truth is `invalid`
  std::optional<ComparisonBits> exact, ties;  // of the formulae; empty without formulae, or if the truth is `invalid`
  Answer answer;
  Judgement judgement;
  std::optional<double> depth;
  bool within_limits = true;
  std::vector<Finding> findings;
  std::vector<Detail> details = {};  // of the truth; none if it is `invalid`
  std::string why_invalid = {};      // where the test says it
  // The measures that the kernel gave, where its test has any, and how they are wrong.
  Json measures = {};
  std::string measures_text = {};
};
Checked checked_of(const TestDescription& test, const Examination& found, std::vector<Detail> details = {});

// The standing of the query is "decided", "declined", "undeclared_decline", "called_invalid", "unanswered",
// "outside_limits" or "no_query". Only the first shows whether the kernel is right; the three after `declined` are
// faults.
std::string_view standing_of(const Kernel& kernel, Verdict exact, bool is_within_limits, Verdict computed);
inline std::string_view standing_of(const Kernel& kernel, const Checked& found) {
  return standing_of(kernel, found.truth.verdict, found.within_limits, found.answer.verdict);
}

// One line, without its line end.
std::string check_text(const std::string& id, const Kernel& kernel, const Checked& found);
// An object with "id", "kernel", "standing", "exact" (the details of the test among its members), "computed",
// "within_limits", "findings" and "flips"; with "test" where a query file names it.
Json check_json(const std::string& id, const Kernel& kernel, const Checked& found);

// The errors of the computed sides: as text, one line for each comparison, to follow check_text's; as JSON, for
// check_json, an object of "absolute_u" and "relative_u" by comparison, null where there is none.
std::string errors_text(const TestDescription& test, const std::optional<SideErrors>& errors);
Json errors_json(const TestDescription& test, const std::optional<SideErrors>& errors);

}  // namespace axiscert

// Output of `axiscert check` for one query.
#pragma once

#include <string>

#include "exact/judge/exact_facts.h"
#include "exact/judge/examine.h"
#include "fuzz/search/confirm.h"
#include "fuzz/confirm/record.h"
#include "reports/instrument/query_data.h"

namespace axiscert {

// A query of any predicate as `check` shows it.
struct CheckResult {
  Truth truth;
  std::optional<Rational> squared_distance;   // of a predicate that compares one; empty if the truth is `invalid`
  std::optional<ComparisonBits> exact, ties;  // of the formulae; empty without formulae, or if the truth is `invalid`
  Answer answer;
  Judgement judgement;
  std::optional<double> depth;
  bool within_limits = true;
  std::vector<Finding> findings;
  std::vector<Detail> details = {};   // of the truth; none if it is `invalid`
  std::string why_invalid = {};       // where the predicate says it
  std::vector<ExactFact> facts = {};  // of a valid query
  int digits = 17;                    // significant ones, to which facts are rounded
  // The measures that the kernel gave, where its predicate has any, and how they are wrong.
  std::optional<MeasuresRecord> measures = {};
  std::string measures_text = {};
};
CheckResult checked_of(const Predicate& predicate, const Examination& found, std::vector<Detail> details = {});

// The standing of the query is "decided", "declined", "undeclared_decline", "called_invalid", "unanswered",
// "outside_limits" or "no_query". Only the first shows whether the kernel is right; the three after `declined` are
// faults.
std::string_view standing_of(const Kernel& kernel, Verdict exact, bool is_within_limits, Verdict computed);
inline std::string_view standing_of(const Kernel& kernel, const CheckResult& found) {
  return standing_of(kernel, found.truth.verdict, found.within_limits, found.answer.verdict);
}

// One line, without its line end; and a second one with the exact facts, `is_exact`: as fractions and roots too. Empty
// where there are none.
std::string check_text(const std::string& id, const Kernel& kernel, const CheckResult& found);
std::string facts_text(const CheckResult& found, bool is_exact);
CheckLine check_line(const std::string& id, const Kernel& kernel, const CheckResult& found);

// The errors of the computed sides: as text, one line for each comparison, to follow check_text's; and for a CheckLine,
// by comparison.
std::string errors_text(const Predicate& predicate, const std::optional<SideErrors>& errors);
std::optional<NamedValues<ComparisonErrorLine>> errors_line(const Predicate& predicate,
                                                            const std::optional<SideErrors>& errors);

}  // namespace axiscert

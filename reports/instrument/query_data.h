// One query and what one kernel says of it: a row of `axiscert check` for a range of queries.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "exact/judge/judge.h"
#include "fuzz/files/query_object.h"
#include "fuzz/record/witness_record.h"
#include "kernel/names.h"
#include "kernel/outcome.h"
#include "reports/instrument/data.h"

namespace axiscert {
struct ExactRow {
  Verdict verdict = Verdict::contact;
  bool touching = false;
  std::optional<double> depth;
  std::optional<Name> input_class;
  std::optional<BitText> comparisons;
  NamedValues<Json> details;  // of the predicate, by name

  static constexpr std::string_view about =
      "The exact answer, with what the predicate's oracles know of a valid query besides: a penetration and a "
      "distance, "
      "rounded to the nearest number of the query's precision, a time, rounded down to one, features, deciding axes.";
  AXISCERT_FIELDS(
      ExactRow, AXISCERT_FIELD(verdict, "The geometric truth; invalid: the numbers are no query."),
      AXISCERT_FIELD(touching, "Whether the two touch, exactly; then the verdict is contact."),
      AXISCERT_FIELD(depth,
                     "How far the query is from touching, whatever the kernel says; null where it is invalid, and in a "
                     "predicate without a depth.",
                     "of the scene"),
      field(&Of::input_class,
            {.name = "class",
             .about = "The class of the input, the first whose definition it meets. Absent where it is invalid, and "
                      "in a predicate without classes.",
             .may_be_absent = true}),
      AXISCERT_FIELD(
          comparisons,
          "The comparisons in exact arithmetic, one 0 or 1 each; null where it is invalid, and where there are none."),
      rest(&Of::details))
};

struct ComputedRow {
  Verdict verdict = Verdict::contact;
  std::optional<BitText> comparisons;

  static constexpr std::string_view about = "The kernel's answer.";
  AXISCERT_FIELDS(ComputedRow, AXISCERT_FIELD(verdict, "Its verdict; unanswered: it crashed or hung."),
                  AXISCERT_FIELD(comparisons, "Its comparisons, one 0 or 1 each; null where it does not show them."))
};

struct QueryRow : DataHead<QueryRow> {
  Name address;
  NamedValues<GroupNumbers> numbers;  // of the query, by group of columns
  Name kernel, standing;
  bool wrong = false;
  std::vector<Link> links;
  ExactRow exact;
  ComputedRow computed;
  std::vector<FindingKind> findings;
  std::optional<std::optional<MeasuresRecord>> measures;

  static constexpr std::string_view format = "axiscert-row/3", title = "A query and one kernel's answer to it",
                                    about =
                                        "The numbers of the query have the names of the groups of columns of its "
                                        "predicate.";
  AXISCERT_FIELDS(
      QueryRow, base<Of, DataHead<Of>>(),
      AXISCERT_FIELD(address, "The address from which `axiscert query` makes it again."), rest(&Of::numbers),
      AXISCERT_FIELD(kernel, "The kernel that was asked."),
      AXISCERT_FIELD(standing,
                     "decided; declined; undeclared_decline, called_invalid, unanswered: faults; outside_limits: it "
                     "promises nothing there; no_query: invalid. Only decided shows whether the kernel is right."),
      AXISCERT_FIELD(
          wrong,
          "Whether its verdict is wrong, by its own convention where the two touch. With the standing decided it is a "
          "missed contact of a run where it says separated, a phantom contact where it says contact."),
      AXISCERT_FIELD(links, "The broken links of a wrong verdict."), AXISCERT_FIELD(exact), AXISCERT_FIELD(computed),
      AXISCERT_FIELD(findings, "Its faults other than a wrong answer, by kind."),
      AXISCERT_OPTIONAL_FIELD(measures, MeasuresRecord::about))
};

// A query in a line of JSON: what `axiscert check` says of one in a file, and what `axiscert shrink` makes of one.

// What exact arithmetic tells of a query besides its verdict (exact/judge/exact_facts.h), rounded once.
struct ExactFactLine {
  Json value, exact;
  std::optional<std::string> note;

  static constexpr std::string_view about =
      "A length, the three coordinates of a place or a direction, or names. Lengths are in the unit of the query's "
      "numbers, depth is a share of the scene.";
  AXISCERT_FIELDS(
      ExactFactLine,
      AXISCERT_FIELD(value,
                     "Text: the decimal nearest to it with 9 significant digits in binary32, 17 in binary64; three of "
                     "them; or an array of names. Null where there is none."),
      AXISCERT_FIELD(
          exact,
          "The same before it was rounded, as fractions and roots: 3/4, sqrt(2), 1/2 - sqrt(1/3); null of names."),
      AXISCERT_OPTIONAL_FIELD(note, "That it is not the only one, or is none."))
};

// The answers by exact arithmetic.
struct ExactAnswersLine {
  Verdict verdict = Verdict::contact;
  bool touching = false;
  std::optional<std::string> reason;
  std::optional<std::optional<std::string>> squared_distance;
  NamedValues<Json> details;  // of the predicate, by name
  NamedValues<ExactFactLine> facts;
  std::optional<BitText> comparisons, axes, ties;

  static constexpr std::string_view about =
      "By exact arithmetic. Besides these what the predicate's oracles tell: a penetration and a distance, rounded to "
      "the nearest number of the query's precision, a time, rounded down to one, features, deciding axes.";
  AXISCERT_FIELDS(
      ExactAnswersLine, AXISCERT_FIELD(verdict, "The answer."),
      AXISCERT_FIELD(touching, "Whether the two touch and no more."),
      AXISCERT_OPTIONAL_FIELD(reason, "Why the query is invalid."),
      AXISCERT_OPTIONAL_FIELD(squared_distance,
                              "A fraction, of a predicate that compares one; null where it was not formed."),
      rest(&Of::details),
      AXISCERT_FIELD(facts,
                     "By name, those that the query has: distance of the two that are apart, or penetration, the least "
                     "translation that parts them; depth; the centre_distance of a sphere's centre, of a motion the "
                     "least; a motion's first time; features, nearest_point and normal, of a motion at that time."),
      AXISCERT_FIELD(comparisons,
                     "The bits of the kernel's formulae over the reals; null of a kernel that claims none."),
      AXISCERT_FIELD(axes, "The clauses that hold, a digit each; null where nothing is known of them."),
      AXISCERT_FIELD(ties, "Which of the comparisons are ties."))
};

struct ComputedAnswersLine {
  Verdict verdict = Verdict::contact;
  std::optional<BitText> comparisons, axes;
  std::optional<std::optional<MeasuresRecord>> measures;

  static constexpr std::string_view about = "The kernel's answer.";
  AXISCERT_FIELDS(
      ComputedAnswersLine, AXISCERT_FIELD(verdict, "The answer."),
      AXISCERT_FIELD(comparisons,
                     "Comparison bits, a digit each in the order of `axiscert predicates`; null where there are none."),
      AXISCERT_FIELD(axes, "The clauses that hold, a digit each; null where nothing is known of them."),
      AXISCERT_OPTIONAL_FIELD(measures,
                              "Of a predicate with measures: what was given beside a contact and how wrong it is; null "
                              "where nothing was given."))
};

struct ComparisonErrorLine {
  std::optional<Decimal6> absolute_u, relative_u;

  AXISCERT_FIELDS(ComparisonErrorLine, AXISCERT_FIELD(absolute_u, "Of lhs - rhs, in u of |lhs| + |rhs|.", "u"),
                  AXISCERT_FIELD(relative_u, "The same in u of |lhs - rhs|.", "u"))
};

struct CheckLine : DataHead<CheckLine> {
  std::string id;
  Name kernel, standing;
  ExactAnswersLine exact;
  ComputedAnswersLine computed;
  bool within_limits = true;
  std::vector<FindingRow> findings;
  std::vector<FlipRecord> flips;
  std::optional<Name> predicate;
  std::optional<std::optional<NamedValues<ComparisonErrorLine>>> errors;

  static constexpr std::string_view format = "axiscert-check/3", title = "A query judged",
                                    about =
                                        "A line of `axiscert check --format jsonl`: one query, the exact answers, "
                                        "those of the kernel, and why they differ.";
  AXISCERT_FIELDS(
      CheckLine, base<Of, DataHead<Of>>(), AXISCERT_FIELD(id, "The query's, or empty."),
      AXISCERT_FIELD(kernel, "The kernel that was asked."),
      AXISCERT_FIELD(standing,
                     "decided; declined; undeclared_decline, called_invalid, unanswered: faults; outside_limits: it "
                     "promises nothing there; no_query: invalid. Only decided shows whether the kernel is right."),
      AXISCERT_FIELD(exact), AXISCERT_FIELD(computed),
      AXISCERT_FIELD(within_limits, "Whether the kernel promises anything for such a query."),
      AXISCERT_FIELD(findings, "What was seen besides a wrong answer."),
      AXISCERT_FIELD(flips, "Where the answers differ."),
      AXISCERT_OPTIONAL_FIELD(predicate, "The predicate of both, where files name it."),
      AXISCERT_OPTIONAL_FIELD(errors, "With --errors: of each comparison's sides; null where the kernel shows none."))
};

// The fault that a query and the smaller one both show.
struct KeptLine {
  std::optional<Level> level;
  Name name, kind;
  std::vector<Link> links;
  std::optional<Name> input_class;
  std::optional<std::vector<Name>> classes;

  AXISCERT_FIELDS(
      KeptLine, AXISCERT_FIELD(level, "Where it is wrong; null for a measure."),
      AXISCERT_FIELD(name, "verdict, an axis, a comparison or a measure."),
      AXISCERT_FIELD(kind, "The kind of wrong answer, `error` or `asymmetry`; of a measure what is wrong with it."),
      AXISCERT_FIELD(links, "The broken links of the chain."),
      field(&Of::input_class, {"class", "The class of the input; null with --any-class."}),
      AXISCERT_FIELD(classes, "Every definition of a class that it meets; null with --any-class."))
};

// The query that was given.
struct GivenLine : StoredLine {
  std::optional<StoredLine> image;

  AXISCERT_FIELDS(GivenLine, base<GivenLine, StoredLine>(), AXISCERT_OPTIONAL_FIELD(image, "Of a pair."))
};

template <class T>
struct BeforeAndAfter {
  T before = {}, after = {};

  AXISCERT_FIELDS(BeforeAndAfter, AXISCERT_FIELD(before, "Of the query that was given."),
                  AXISCERT_FIELD(after, "Of the smaller one."))
};

struct ShrunkQuery : StoredLine {
  Name kernel;
  KeptLine kept;
  GivenLine before;
  BeforeAndAfter<std::string> severity;
  BeforeAndAfter<std::uint64_t> bits, nonzero;
  std::uint64_t steps = 0, evaluations = 0;
  bool complete = false;
  std::optional<std::vector<Verdict>> answers;
  std::optional<StoredLine> image;

  AXISCERT_FIELDS(ShrunkQuery, base<Of, StoredLine>(), AXISCERT_FIELD(kernel, "The kernel that is wrong on it."),
                  AXISCERT_FIELD(kept, "What both queries show."),
                  AXISCERT_FIELD(before, "The query that was given, and of a pair its image."),
                  AXISCERT_FIELD(severity, "How severe it is, in words."),
                  AXISCERT_FIELD(bits, "How many bits the numbers have."),
                  AXISCERT_FIELD(nonzero, "How many numbers are not 0."),
                  AXISCERT_FIELD(steps, "Smaller queries on the way."),
                  AXISCERT_FIELD(evaluations, "Queries that were asked."),
                  AXISCERT_FIELD(complete, "Whether no further step makes it smaller; false: the limit ended it."),
                  AXISCERT_OPTIONAL_FIELD(answers, "Of a pair: the answers to the query and to its image."),
                  AXISCERT_OPTIONAL_FIELD(image, "Of a pair: the image that is answered otherwise."))
};

struct ShrinkLine : DataHead<ShrinkLine> {
  ShrunkQuery query;

  static constexpr std::string_view format = "axiscert-shrink/2", title = "A query made smaller",
                                    about =
                                        "A line of `axiscert shrink --format jsonl`: a line of a query file "
                                        "(docs/queries.md) with the smaller query, and what it was made from.";
  AXISCERT_FIELDS(ShrinkLine, base<ShrinkLine, DataHead<ShrinkLine>>(), inlined(&ShrinkLine::query))
};

}  // namespace axiscert

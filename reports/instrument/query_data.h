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
  static constexpr auto fields(auto&& visit) {
    using Of = ExactRow;
    return visit(
        field(&Of::verdict, {"verdict", "The geometric truth; invalid: the numbers are no query."}),
        field(&Of::touching, {"touching", "Whether the two touch, exactly; then the verdict is contact."}),
        field(&Of::depth, {"depth",
                           "How far the query is from touching, whatever the kernel says; null where it is invalid, "
                           "and in a predicate "
                           "without a depth.",
                           "of the scene"}),
        field(&Of::input_class,
              {.name = "class",
               .about = "The class of the input, the first whose definition it meets. Absent where it is invalid, and "
                        "in a predicate without classes.",
               .may_be_absent = true}),
        field(&Of::comparisons,
              {"comparisons",
               "The comparisons in exact arithmetic, one 0 or 1 each; null where it is invalid, and where there are "
               "none."}),
        rest(&Of::details));
  }
};

struct ComputedRow {
  Verdict verdict = Verdict::contact;
  std::optional<BitText> comparisons;

  static constexpr std::string_view about = "The kernel's answer.";
  static constexpr auto fields(auto&& visit) {
    using Of = ComputedRow;
    return visit(field(&Of::verdict, {"verdict", "Its verdict; unanswered: it crashed or hung."}),
                 field(&Of::comparisons,
                       {"comparisons", "Its comparisons, one 0 or 1 each; null where it does not show them."}));
  }
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
  static constexpr auto fields(auto&& visit) {
    using Of = QueryRow;
    return visit(
        base<Of, DataHead<Of>>(),
        field(&Of::address, {"address", "The address from which `axiscert query` makes it again."}), rest(&Of::numbers),
        field(&Of::kernel, {"kernel", "The kernel that was asked."}),
        field(&Of::standing,
              {"standing",
               "decided; declined; undeclared_decline, called_invalid, unanswered: faults; outside_limits: it promises "
               "nothing there; no_query: invalid. Only decided shows whether the kernel is right."}),
        field(&Of::wrong,
              {"wrong",
               "Whether its verdict is wrong, by its own convention where the two touch. With the standing decided it "
               "is a missed contact of a run where it says separated, a phantom contact where it says contact."}),
        field(&Of::links, {"links", "The broken links of a wrong verdict."}), field(&Of::exact, {"exact", {}}),
        field(&Of::computed, {"computed", {}}),
        field(&Of::findings, {"findings", "Its faults other than a wrong answer, by kind."}),
        field(&Of::measures, {.name = "measures", .about = MeasuresRecord::about, .may_be_absent = true}));
  }
};

// A query in a line of JSON: what `axiscert check` says of one in a file, and what `axiscert shrink` makes of one.

// What exact arithmetic tells of a query besides its verdict (exact/trait/exact_facts.h), rounded once.
struct ExactFactLine {
  Json value, exact;
  std::optional<std::string> note;

  static constexpr std::string_view about =
      "A length, the three coordinates of a place or a direction, or names. Lengths are in the unit of the query's "
      "numbers, depth is a share of the scene.";
  static constexpr auto fields(auto&& visit) {
    using Of = ExactFactLine;
    return visit(
        field(&Of::value, {"value",
                           "Text: the decimal nearest to it with 9 significant digits in binary32, 17 in "
                           "binary64; three of them; or an array of names. Null where there is none."}),
        field(&Of::exact, {"exact",
                           "The same before it was rounded, as fractions and roots: 3/4, sqrt(2), 1/2 - "
                           "sqrt(1/3); null of names."}),
        field(&Of::note, {.name = "note", .about = "That it is not the only one, or is none.", .may_be_absent = true}));
  }
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
  static constexpr auto fields(auto&& visit) {
    using Of = ExactAnswersLine;
    return visit(
        field(&Of::verdict, {"verdict", "The answer."}),
        field(&Of::touching, {"touching", "Whether the two touch and no more."}),
        field(&Of::reason, {.name = "reason", .about = "Why the query is invalid.", .may_be_absent = true}),
        field(&Of::squared_distance,
              {.name = "squared_distance",
               .about = "A fraction, of a predicate that compares one; null where it was not formed.",
               .may_be_absent = true}),
        rest(&Of::details),
        field(&Of::facts,
              {"facts",
               "By name, those that the query has: distance of the two that are apart, or penetration, the least "
               "translation that parts them; depth; the centre_distance of a sphere's centre, of a motion the least; "
               "a motion's first time; features, nearest_point and normal, of a motion at that time."}),
        field(&Of::comparisons,
              {"comparisons", "The bits of the kernel's formulae over the reals; null of a kernel that claims none."}),
        field(&Of::axes, {"axes", "The clauses that hold, a digit each; null where nothing is known of them."}),
        field(&Of::ties, {"ties", "Which of the comparisons are ties."}));
  }
};

struct ComputedAnswersLine {
  Verdict verdict = Verdict::contact;
  std::optional<BitText> comparisons, axes;
  std::optional<std::optional<MeasuresRecord>> measures;

  static constexpr std::string_view about = "The kernel's answer.";
  static constexpr auto fields(auto&& visit) {
    using Of = ComputedAnswersLine;
    return visit(
        field(&Of::verdict, {"verdict", "The answer."}),
        field(&Of::comparisons,
              {"comparisons",
               "Comparison bits, a digit each in the order of `axiscert predicates`; null where there are none."}),
        field(&Of::axes, {"axes", "The clauses that hold, a digit each; null where nothing is known of them."}),
        field(&Of::measures,
              {.name = "measures",
               .about = "Of a predicate with measures: what was given beside a contact and how wrong it is; null where "
                        "nothing was given.",
               .may_be_absent = true}));
  }
};

struct ComparisonErrorLine {
  std::optional<Decimal6> absolute_u, relative_u;

  static constexpr auto fields(auto&& visit) {
    using Of = ComparisonErrorLine;
    return visit(field(&Of::absolute_u, {"absolute_u", "Of lhs - rhs, in u of |lhs| + |rhs|.", "u"}),
                 field(&Of::relative_u, {"relative_u", "The same in u of |lhs - rhs|.", "u"}));
  }
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
  static constexpr auto fields(auto&& visit) {
    using Of = CheckLine;
    return visit(
        base<Of, DataHead<Of>>(), field(&Of::id, {"id", "The query's, or empty."}),
        field(&Of::kernel, {"kernel", "The kernel that was asked."}),
        field(&Of::standing,
              {"standing",
               "decided; declined; undeclared_decline, called_invalid, unanswered: faults; outside_limits: it promises "
               "nothing there; no_query: invalid. Only decided shows whether the kernel is right."}),
        field(&Of::exact, {"exact", {}}), field(&Of::computed, {"computed", {}}),
        field(&Of::within_limits, {"within_limits", "Whether the kernel promises anything for such a query."}),
        field(&Of::findings, {"findings", "What was seen besides a wrong answer."}),
        field(&Of::flips, {"flips", "Where the answers differ."}),
        field(&Of::predicate,
              {.name = "predicate", .about = "The predicate of both, where files name it.", .may_be_absent = true}),
        field(&Of::errors, {.name = "errors",
                            .about = "With --errors: of each comparison's sides; null where the kernel shows none.",
                            .may_be_absent = true}));
  }
};

// The fault that a query and the smaller one both show.
struct KeptLine {
  std::optional<Level> level;
  Name name, kind;
  std::vector<Link> links;
  std::optional<Name> input_class;
  std::optional<std::vector<Name>> classes;

  static constexpr auto fields(auto&& visit) {
    using Of = KeptLine;
    return visit(
        field(&Of::level, {"level", "Where it is wrong; null for a measure."}),
        field(&Of::name, {"name", "verdict, an axis, a comparison or a measure."}),
        field(&Of::kind,
              {"kind", "The kind of wrong answer, `error` or `asymmetry`; of a measure what is wrong with it."}),
        field(&Of::links, {"links", "The broken links of the chain."}),
        field(&Of::input_class, {"class", "The class of the input; null with --any-class."}),
        field(&Of::classes, {"classes", "Every definition of a class that it meets; null with --any-class."}));
  }
};

// The query that was given.
struct GivenLine : StoredLine {
  std::optional<StoredLine> image;

  static constexpr auto fields(auto&& visit) {
    return visit(base<GivenLine, StoredLine>(),
                 field(&GivenLine::image, {.name = "image", .about = "Of a pair.", .may_be_absent = true}));
  }
};

template <class T>
struct BeforeAndAfter {
  T before = {}, after = {};

  static constexpr auto fields(auto&& visit) {
    return visit(field(&BeforeAndAfter::before, {"before", "Of the query that was given."}),
                 field(&BeforeAndAfter::after, {"after", "Of the smaller one."}));
  }
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

  static constexpr auto fields(auto&& visit) {
    using Of = ShrunkQuery;
    return visit(
        base<Of, StoredLine>(), field(&Of::kernel, {"kernel", "The kernel that is wrong on it."}),
        field(&Of::kept, {"kept", "What both queries show."}),
        field(&Of::before, {"before", "The query that was given, and of a pair its image."}),
        field(&Of::severity, {"severity", "How severe it is, in words."}),
        field(&Of::bits, {"bits", "How many bits the numbers have."}),
        field(&Of::nonzero, {"nonzero", "How many numbers are not 0."}),
        field(&Of::steps, {"steps", "Smaller queries on the way."}),
        field(&Of::evaluations, {"evaluations", "Queries that were asked."}),
        field(&Of::complete, {"complete", "Whether no further step makes it smaller; false: the limit ended it."}),
        field(&Of::answers, {.name = "answers",
                             .about = "Of a pair: the answers to the query and to its image.",
                             .may_be_absent = true}),
        field(&Of::image,
              {.name = "image", .about = "Of a pair: the image that is answered otherwise.", .may_be_absent = true}));
  }
};

struct ShrinkLine : DataHead<ShrinkLine> {
  ShrunkQuery query;

  static constexpr std::string_view format = "axiscert-shrink/2", title = "A query made smaller",
                                    about =
                                        "A line of `axiscert shrink --format jsonl`: a line of a query file "
                                        "(docs/queries.md) with the smaller query, and what it was made from.";
  static constexpr auto fields(auto&& visit) {
    return visit(base<ShrinkLine, DataHead<ShrinkLine>>(), inlined(&ShrinkLine::query));
  }
};

}  // namespace axiscert

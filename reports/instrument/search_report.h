// The report of `axiscert search`.
#pragma once

#include "exact/judge/judge.h"
#include "fuzz/record/looked_at.h"
#include "fuzz/search/search.h"
#include "fuzz/text/field.h"
#include "reports/instrument/data.h"
#include "reports/instrument/instrument.h"

namespace axiscert {
// search.json: what `axiscert search` writes.

struct RangeFindData {
  int exponent = 0;
  QueryLine witness;

  static constexpr std::string_view about = "The scale at which a comparison leaves the range.";
  AXISCERT_FIELDS(RangeFindData,
                  AXISCERT_FIELD(exponent,
                                 "The exponent m of the factor 2^m on a scene of size 1/2 to 1 and good shape."),
                  AXISCERT_FIELD(witness, "The query at that scale."))
};

struct ComparisonFindData {
  Name name;
  std::optional<Decimal6> attained_u, proved_u;
  std::optional<QueryLine> witness;
  std::optional<Decimal6> relative_u;
  std::optional<QueryLine> relative_witness;
  std::optional<RangeFindData> overflow, underflow;

  static constexpr std::string_view about = "The worst found for one comparison; null where none was found.";
  AXISCERT_FIELDS(
      ComparisonFindData, AXISCERT_FIELD(name, "The name of the comparison."),
      AXISCERT_FIELD(attained_u,
                     "|(l^ - r^) - (l - r)| in u, every coordinate of A - P, B - P and C - P in [-1, 1], r in [0, 1], "
                     "P free, the rounding of the translation included."),
      AXISCERT_FIELD(proved_u, "A bound on attained_u that a checker accepted; null: open."),
      AXISCERT_FIELD(witness, "A query that attains it."),
      AXISCERT_FIELD(relative_u,
                     "|(l^ - r^) - (l - r)| over u (|l| + |r|). Searched up to 2^40, since it has no bound where both "
                     "sides vanish."),
      AXISCERT_FIELD(relative_witness, "A query that attains it."),
      AXISCERT_FIELD(overflow, "The least scale upwards at which it leaves the range; null: it was not observed to."),
      AXISCERT_FIELD(underflow,
                     "The greatest scale downwards at which it leaves the range; null: it was not observed to."))
};

struct WrongVerdictFindData {
  Decimal6 depth;
  std::vector<Link> links;
  QueryLine witness;

  AXISCERT_FIELDS(WrongVerdictFindData,
                  AXISCERT_FIELD(depth,
                                 "How far it is from being right, over the size of the scene, rounded up to six "
                                 "digits; above 1 of two boxes alone."),
                  AXISCERT_FIELD(links, "The broken links."), AXISCERT_FIELD(witness, "A query that shows it."))
};

struct RadiusFindData {
  Decimal6 ulps;
  QueryLine witness;

  AXISCERT_FIELDS(RadiusFindData, AXISCERT_FIELD(ulps, "The error in ulps of the exact distance, correctly rounded."),
                  AXISCERT_FIELD(witness, "The query; its r is the radius."))
};

// A member that is no aim of the search is absent.
struct VerdictFindsData {
  std::optional<std::optional<WrongVerdictFindData>> missed_contact, phantom_contact;
  std::optional<std::optional<RadiusFindData>> critical_radius;

  AXISCERT_FIELDS(VerdictFindsData,
                  AXISCERT_OPTIONAL_FIELD(missed_contact,
                                          "The deepest missed contact; null: none found among the decided queries."),
                  AXISCERT_OPTIONAL_FIELD(phantom_contact,
                                          "The deepest phantom contact; null: none found among the decided ones."),
                  AXISCERT_OPTIONAL_FIELD(critical_radius,
                                          "The greatest error of the smallest radius for which the kernel says "
                                          "contact; null: none found. Sphere-triangle's alone."))
};

struct NumberFindData {
  Name what;
  std::uint64_t judged = 0;
  std::optional<Decimal6> value;
  std::optional<QueryLine> witness;

  AXISCERT_FIELDS(
      NumberFindData, AXISCERT_FIELD(what, "The error, by the name of the level that is for it: `separation`, `left`."),
      AXISCERT_FIELD(judged,
                     "Queries that were evaluated for it, and whose answer had it, where it could be compared."),
      AXISCERT_FIELD(value,
                     "The greatest, rounded up to six digits: an angle in radians, what is left as a share of the "
                     "depth, a length less 1, else a share of the scene; null: none found among those judged."),
      AXISCERT_FIELD(witness, "The query; null where there is none."))
};

struct BegunFromData {
  std::uint64_t queries = 0;
  std::vector<Name> families;
  LookedAt looked_at;

  AXISCERT_FIELDS(BegunFromData, AXISCERT_FIELD(queries, "Queries of each family; 0: it began with no run."),
                  AXISCERT_FIELD(families, "The families of that run."),
                  AXISCERT_FIELD(looked_at, "The queries of that run."))
};

struct SearchData : DataHead<SearchData> {
  static constexpr std::string_view format = "axiscert-search/2", title = "The worst of a kernel that a search found";
  bool complete = true;
  Name kernel;
  Precision precision = Precision::binary32;
  WholeNumber seed;
  std::vector<Name> families;
  std::uint64_t evaluations = 0;
  bool may_decline = false;
  LookedAt looked_at;
  NamedValues<LookedAt> looked_at_by_goal;
  std::vector<ComparisonFindData> comparisons;
  VerdictFindsData verdict;
  std::vector<NumberFindData> numbers;
  BegunFromData begun_from;

  static constexpr std::string_view about =
      "search.json, which `axiscert search` writes. It depends on the plan and on the evaluations alone. Every "
      "attained figure is a lower bound of the worst, confirmed by exact arithmetic.";
  AXISCERT_FIELDS(
      SearchData, base<Of, DataHead<Of>>(), AXISCERT_FIELD(complete, "False where it was interrupted."),
      AXISCERT_FIELD(kernel, "The kernel as given to --kernel."),
      AXISCERT_FIELD(precision, "The precision of the queries and of the kernel's arithmetic."),
      AXISCERT_FIELD(seed, "The seed of all random choices."),
      AXISCERT_FIELD(families, "The families from which the search started."),
      AXISCERT_FIELD(evaluations,
                     "The number of queries that were estimated, including earlier runs of a resumed search. With "
                     "--evaluations, this number makes the same file again."),
      AXISCERT_FIELD(may_decline, "Whether the kernel declares that it may answer `undecided`."),
      AXISCERT_FIELD(looked_at,
                     "All queries that were evaluated, and those of the run before. With none decided, the search says "
                     "nothing about the kernel."),
      AXISCERT_FIELD(looked_at_by_goal,
                     "Those that were evaluated for each goal, by its name: `missed_contact`, `error plane.radius`. "
                     "Where no worst was found, it is none among the decided ones of its goal."),
      AXISCERT_FIELD(
          comparisons,
          "The comparisons that were searched, in their order; none where the kernel does not show its sides."),
      AXISCERT_FIELD(verdict, "The worst wrong verdicts; empty where --comparison was given."),
      AXISCERT_FIELD(numbers,
                     "The worst numbers beside verdicts, each that was searched; none where the kernel gives none, of "
                     "motions, and where --comparison was given."),
      AXISCERT_FIELD(begun_from, "The run from which the search began, and than which it reports nothing less severe."))
};

InstrumentReport search_report(const SearchPlan& plan, const SearchResult& result, const std::string& command);
// Whether it says nothing about the kernel: no query that was evaluated, or of the run before, was decided, or all that
// was searched is beside the verdict and no answer had it. With a find it does: sides may be given beside no verdict.
bool saw_nothing(const SearchResult& result);
// The witnesses as a query file, one for each find.
std::string search_witnesses(const SearchResult& result);

}  // namespace axiscert

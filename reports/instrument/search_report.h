// The report of `axiscert search`.
#pragma once

#include "exact/judge/judge.h"
#include "fuzz/fields/field.h"
#include "fuzz/record/looked_at.h"
#include "fuzz/search/search.h"
#include "reports/instrument/data.h"
#include "reports/instrument/instrument.h"

namespace axiscert {
// search.json: what `axiscert search` writes.

struct RangeFindData {
  int exponent = 0;
  QueryLine witness;

  static constexpr std::string_view about = "The scale at which a comparison leaves the range.";
  static constexpr auto fields(auto&& visit) {
    using Of = RangeFindData;
    return visit(field(&Of::exponent,
                       {"exponent", "The exponent m of the factor 2^m on a scene of size 1/2 to 1 and good shape."}),
                 field(&Of::witness, {"witness", "The query at that scale."}));
  }
};

struct ComparisonFindData {
  Name name;
  std::optional<Decimal6> attained_u, proved_u;
  std::optional<QueryLine> witness;
  std::optional<Decimal6> relative_u;
  std::optional<QueryLine> relative_witness;
  std::optional<RangeFindData> overflow, underflow;

  static constexpr std::string_view about = "The worst found for one comparison; null where none was found.";
  static constexpr auto fields(auto&& visit) {
    using Of = ComparisonFindData;
    return visit(
        field(&Of::name, {"name", "The name of the comparison."}),
        field(&Of::attained_u,
              {"attained_u",
               "|(l^ - r^) - (l - r)| in u, every coordinate of A - P, B - P and C - P in [-1, 1], r in [0, 1], P "
               "free, the rounding of the translation included."}),
        field(&Of::proved_u, {"proved_u", "A bound on attained_u that a checker accepted; null: open."}),
        field(&Of::witness, {"witness", "A query that attains it."}),
        field(&Of::relative_u,
              {"relative_u",
               "|(l^ - r^) - (l - r)| over u (|l| + |r|). Searched up to 2^40, since it has no bound where both sides "
               "vanish."}),
        field(&Of::relative_witness, {"relative_witness", "A query that attains it."}),
        field(&Of::overflow,
              {"overflow", "The least scale upwards at which it leaves the range; null: it was not observed to."}),
        field(
            &Of::underflow,
            {"underflow", "The greatest scale downwards at which it leaves the range; null: it was not observed to."}));
  }
};

struct WrongVerdictFindData {
  Decimal6 depth;
  std::vector<Link> links;
  QueryLine witness;

  static constexpr auto fields(auto&& visit) {
    using Of = WrongVerdictFindData;
    return visit(
        field(&Of::depth,
              {"depth",
               "How far it is from being right, over the size of the scene, rounded up to six digits; above 1 of two "
               "boxes alone."}),
        field(&Of::links, {"links", "The broken links."}), field(&Of::witness, {"witness", "A query that shows it."}));
  }
};

struct RadiusFindData {
  Decimal6 ulps;
  QueryLine witness;

  static constexpr auto fields(auto&& visit) {
    using Of = RadiusFindData;
    return visit(field(&Of::ulps, {"ulps", "The error in ulps of the exact distance, correctly rounded."}),
                 field(&Of::witness, {"witness", "The query; its r is the radius."}));
  }
};

// A member that is no aim of the search is absent.
struct VerdictFindsData {
  std::optional<std::optional<WrongVerdictFindData>> missed_contact, phantom_contact;
  std::optional<std::optional<RadiusFindData>> critical_radius;

  static constexpr auto fields(auto&& visit) {
    using Of = VerdictFindsData;
    return visit(
        field(&Of::missed_contact, {.name = "missed_contact",
                                    .about = "The deepest missed contact; null: none found among the decided queries.",
                                    .may_be_absent = true}),
        field(&Of::phantom_contact, {.name = "phantom_contact",
                                     .about = "The deepest phantom contact; null: none found among the decided ones.",
                                     .may_be_absent = true}),
        field(&Of::critical_radius,
              {.name = "critical_radius",
               .about = "The greatest error of the smallest radius for which the kernel says contact; null: none "
                        "found. Sphere-triangle's alone.",
               .may_be_absent = true}));
  }
};

struct NumberFindData {
  Name what;
  std::optional<Decimal6> value;
  std::optional<QueryLine> witness;

  static constexpr auto fields(auto&& visit) {
    using Of = NumberFindData;
    return visit(
        field(&Of::what, {"what", "The error, by the name of the level that is for it: `separation`, `left`."}),
        field(&Of::value,
              {"value",
               "The greatest, rounded up to six digits: an angle in radians, what is left as a share of the depth, a "
               "length less 1, else a share of the scene; null: none found among the decided queries."}),
        field(&Of::witness, {"witness", "The query; null where there is none."}));
  }
};

struct BegunFromData {
  std::uint64_t queries = 0;
  std::vector<Name> families;
  LookedAt looked_at;

  static constexpr auto fields(auto&& visit) {
    using Of = BegunFromData;
    return visit(field(&Of::queries, {"queries", "Queries of each family; 0: it began with no run."}),
                 field(&Of::families, {"families", "The families of that run."}),
                 field(&Of::looked_at, {"looked_at", "The queries of that run."}));
  }
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
  static constexpr auto fields(auto&& visit) {
    using Of = SearchData;
    return visit(
        base<Of, DataHead<Of>>(), field(&Of::complete, {"complete", "False where it was interrupted."}),
        field(&Of::kernel, {"kernel", "The kernel as given to --kernel."}),
        field(&Of::precision, {"precision", "The precision of the queries and of the kernel's arithmetic."}),
        field(&Of::seed, {"seed", "The seed of all random choices."}),
        field(&Of::families, {"families", "The families from which the search started."}),
        field(&Of::evaluations,
              {"evaluations",
               "The number of queries that were estimated, including earlier runs of a resumed search. With "
               "--evaluations, this number makes the same file again."}),
        field(&Of::may_decline, {"may_decline", "Whether the kernel declares that it may answer `undecided`."}),
        field(&Of::looked_at,
              {"looked_at",
               "All queries that were evaluated, and those of the run before. With none decided, the search says "
               "nothing about the kernel."}),
        field(&Of::looked_at_by_goal,
              {"looked_at_by_goal",
               "Those that were evaluated for each goal, by its name: `missed_contact`, `error plane.radius`. Where "
               "no worst was found, it is none among the decided ones of its goal."}),
        field(&Of::comparisons,
              {"comparisons",
               "The comparisons that were searched, in their order; none where the kernel does not show its sides."}),
        field(&Of::verdict, {"verdict", "The worst wrong verdicts; empty where --comparison was given."}),
        field(
            &Of::numbers,
            {"numbers",
             "The worst numbers beside verdicts, each that was searched; none where the kernel gives none, of motions, "
             "and where --comparison was given."}),
        field(&Of::begun_from,
              {"begun_from", "The run from which the search began, and than which it reports nothing less severe."}));
  }
};

InstrumentReport search_report(const SearchPlan& plan, const SearchResult& result, const std::string& command);
// All queries that the search looked at: those that were evaluated, and those of the run before. Where none of them was
// decided, it says nothing about the kernel.
LookedAt search_looked_at(const SearchResult& result);
// The witnesses as a query file, one for each find.
std::string search_witnesses(const SearchResult& result);

}  // namespace axiscert

// The counts of a run, per kernel, precision and source. Tallies of units merge in any order to the same result.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "exact/judge/judge.h"
#include "exact/numbers/rational.h"
#include "fuzz/record/contact_tally.h"
#include "fuzz/record/leaders.h"
#include "fuzz/record/margins.h"
#include "fuzz/record/wrong_verdicts.h"
#include "fuzz/text/field.h"
#include "fuzz/text/values.h"
#include "kernel/outcome.h"

namespace axiscert {

// Answers to clear queries: those that no right method of the precision gets wrong (exact/judge/clear.h).

// Counts of a kernel without a reference: nothing else tells its faults of logic from its rounding.
struct ClearTally : DecidedCounts {
  std::uint64_t queries = 0, undecided = 0;
  std::uint64_t false_separation = 0, false_contact = 0;
  Leaders<bool> first_missed, first_phantom;  // by the position alone

  std::uint64_t unanswered() const { return queries - decided() - undecided; }
  bool operator==(const ClearTally& other) const {
    return queries == other.queries && decided_contacts == other.decided_contacts &&
           decided_separations == other.decided_separations && undecided == other.undecided &&
           false_separation == other.false_separation && false_contact == other.false_contact;
  }

  static constexpr std::string_view about =
      "Answers to clear queries within the kernel's limits: no right method of the precision gets one wrong, since its "
      "margin is many times the bound of any rounding.";
  AXISCERT_FIELDS(ClearTally, AXISCERT_FIELD(queries, "Clear queries within the limits."),
                  AXISCERT_FIELD(decided_contacts, "Contacts among them that the kernel decided."),
                  AXISCERT_FIELD(decided_separations, "Separations among them that it decided."),
                  AXISCERT_FIELD(decided, "Both together."), AXISCERT_FIELD(undecided, "Those that it declined."),
                  AXISCERT_FIELD(unanswered, "The rest: it called them invalid, or gave no answer."),
                  field(&Of::false_separation,
                        figure_of("decided_contacts", "false_separation", "Missed contacts among them.")),
                  field(&Of::false_contact,
                        figure_of("decided_separations", "false_contact", "Phantom contacts among them.")),
                  journalled(&Of::first_missed), journalled(&Of::first_phantom))
};

struct ExactSides;
class SideError;
template <class Real>
struct Answers;

using LinkCounts = EnumArray<Link, std::uint64_t>;

// The geometric truth of the queries; touching is part of contact.
struct TruthCounts {
  std::uint64_t separated = 0, contact = 0, touching = 0, invalid = 0;

  bool operator==(const TruthCounts&) const = default;

  static constexpr std::string_view about = "The geometric truth of the queries.";
  AXISCERT_FIELDS(TruthCounts, AXISCERT_FIELD(separated, "Queries whose exact squared distance is greater than r^2."),
                  AXISCERT_FIELD(contact, "The other valid ones, touching included."),
                  AXISCERT_FIELD(touching, "Contacts whose squared distance equals r^2."),
                  AXISCERT_FIELD(invalid,
                                 "Queries with a non-finite input or a negative radius: no flips are counted on them."))
};

// Flips by broken link. A flip is relative to the kernel's own exact formulae, so none is `specification`.
struct FormulaLinks {
  std::uint64_t rounding = 0, range = 0, implementation = 0, unattributed = 0;

  static constexpr std::string_view about =
      "Flips with each link broken, on this level's own bits, beginning with the kernel's own exact formulae.";
  AXISCERT_FIELDS(FormulaLinks, AXISCERT_FIELD(rounding, "E and R-infinity differ here."),
                  AXISCERT_FIELD(range, "R-infinity and R differ here."),
                  AXISCERT_FIELD(implementation, "R and K differ here."),
                  AXISCERT_FIELD(unattributed, "E and K differ here, and the kernel has no reference between them."))
};

// Sign errors of one axis or one comparison against the kernel's own formulae in exact arithmetic. What may be empty is
// so where it was not measured: no tolerance was given, or the kernel shows no sides.
struct SignTally {
  std::uint64_t judged = 0;
  std::uint64_t false_separation = 0, missed_separation = 0, masked = 0, decisive = 0;
  std::optional<std::uint64_t> tolerance_failures = 0;
  std::optional<Decimal6> max_error = Decimal6();  // in u
  FormulaLinks links;

  std::optional<Decimal6> smallest_passing_tolerance() const { return max_error; }

  AXISCERT_FIELDS(
      SignTally, AXISCERT_FIELD(judged, "Queries whose sign was compared: those with a verdict and comparisons."),
      field(&Of::false_separation, figure_of("judged", "false_separation",
                                             "Queries that the kernel separates here, and its exact formulae do not.")),
      field(&Of::missed_separation,
            figure_of("judged", "missed_separation",
                      "Queries that its exact formulae separate here, and the kernel does not.")),
      field(&Of::masked, figure_of("judged", "masked", "The flips that are not decisive.")),
      field(&Of::decisive,
            figure_of("judged", "decisive",
                      "The flips on queries where the kernel's verdict differs from that of its exact formulae, the "
                      "same way as the flip; of a comparison, those that belong to a decisive flip of its axis.")),
      AXISCERT_FIELD(tolerance_failures,
                     "Queries whose error is above the plan's tolerance; null where there is none, or no error was "
                     "measured: not checked."),
      field(&SignTally::max_error,
            {"max_error_u",
             "The largest |(computed lhs - computed rhs) - (lhs - rhs)| / (u (|lhs| + |rhs|)), u = 2^-24 or 2^-53, "
             "rounded up to 6 significant digits; null where no query has finite sides and a scale.",
             "u"},
            by::greatest),
      AXISCERT_FIELD(smallest_passing_tolerance, "The smallest tolerance with no failure; equal to max_error_u.", "u"),
      field(&Of::links, figure_of("judged", "links", {})))
};

struct AxisTally : SignTally {
  std::uint64_t sole_separator = 0;

  static constexpr std::string_view about = "One axis: the kernel against its own formulae in exact arithmetic.";
  AXISCERT_FIELDS(AxisTally, base<AxisTally, SignTally>(),
                  AXISCERT_FIELD(sole_separator,
                                 "Queries that this axis alone separates, by the kernel's own formulae in exact "
                                 "arithmetic: without it they would be phantom contacts."))
};

struct ComparisonTally : SignTally {
  MarginTally margins;  // of the source's first queries (has_margins)
  std::uint64_t ties = 0;
  std::optional<std::uint64_t> range_events = 0, error_without_scale = 0;
  Leaders<Decimal6> largest_error;              // in u, other than zero
  Leaders<bool> false_witness, missed_witness;  // ranked by whether the flip is decisive

  static constexpr std::string_view about =
      "One comparison lhs > rhs: the kernel against its own formula in exact arithmetic.";
  AXISCERT_FIELDS(
      ComparisonTally, base<ComparisonTally, SignTally>(), AXISCERT_FIELD(margins),
      AXISCERT_FIELD(ties, "Queries whose exact margin lhs - rhs is zero."),
      AXISCERT_FIELD(
          range_events,
          "Queries with a computed side that is not finite; left out of the error. Null where no sides were measured."),
      AXISCERT_FIELD(error_without_scale,
                     "Queries with both exact sides zero and a computed difference that is not: no relative error; "
                     "left out of the maximum. Null where no sides were measured."),
      journalled(&ComparisonTally::largest_error), journalled(&ComparisonTally::false_witness),
      journalled(&ComparisonTally::missed_witness))
};

// Valid queries outside the limits that a kernel declares; only the truth counts them too.
struct OutsideTally : DecidedCounts {
  std::uint64_t trials = 0;
  std::uint64_t false_separation = 0, false_contact = 0, unanswered = 0;
  std::uint64_t contact = 0, touching = 0;  // the truth; touching is part of contact
  double deepest = 0;

  static constexpr std::string_view about =
      "Results where the kernel promises nothing. No other count of its verdicts, axes, comparisons or critical radii "
      "includes these queries, and no requirement covers them.";
  AXISCERT_FIELDS(
      OutsideTally, AXISCERT_FIELD(trials, "Valid queries outside the limits."),
      AXISCERT_FIELD(decided_contacts, "Contacts among them that it decided, as within the limits."),
      AXISCERT_FIELD(decided_separations, "Separations among them that it decided."),
      AXISCERT_FIELD(decided, "Both together."),
      field(&Of::false_separation, figure_of("decided_contacts", "false_separation", "Missed contacts among them.")),
      field(&Of::false_contact, figure_of("decided_separations", "false_contact", "Phantom contacts among them.")),
      AXISCERT_FIELD(unanswered, "Queries among them without an answer."),
      AXISCERT_FIELD(contact, "Those of trials whose truth is contact."),
      AXISCERT_FIELD(touching, "Those of contact that touch."),
      field(&Of::deepest,
            figure_of("decided", "deepest", "Largest depth of a wrong verdict among them; 0 where there is none.",
                      "of the scene"),
            by::greatest))
};

// The first query of a family with some property, by its position.
struct FirstQuery {
  std::optional<std::uint64_t> position;

  void offer(std::optional<std::uint64_t> other) {
    if (other && (!position || *other < *position)) position = other;
  }
  void merge(const FirstQuery& other) { offer(other.position); }
  void put(auto& encoder) const { encoder.put(position); }
  void get(auto& decoder) { decoder.get(position); }
};
// Counted from 1; null: none.
template <>
struct JsonForm<FirstQuery> {
  static Json write(const FirstQuery& first);
  static void read(const JsonPlace& place, FirstQuery& into);
  static Json schema();
};

// A member may be empty where the kernel declares no limits, has a reference (clear), the predicate has no depth, or
// engines ask no such queries.
struct VerdictTally : DecidedCounts {
  std::uint64_t decided_touching = 0;
  std::uint64_t false_separation = 0, false_contact = 0, undecided = 0;
  std::uint64_t undecided_contact = 0, undecided_touching = 0;  // of undecided; touching is part of contact
  std::uint64_t invalid = 0, unanswered = 0;
  Leaders<double> deepest_false_separation{3}, deepest_false_contact{3};  // ranked by depth
  Leaders<double> farthest_false_separation, farthest_false_contact;      // ranked by its length
  LinkCounts links{}, masked_links{};
  EnumArray<Link, FirstQuery> first_by_link{};
  std::uint64_t touching_flips = 0;
  LinkCounts touching_links{};
  std::optional<OutsideTally> outside_limits = OutsideTally();
  std::optional<ClearTally> clear = ClearTally();
  std::optional<DepthTally> depths = DepthTally();
  std::optional<EngineTally> engine = EngineTally();
  EnumArray<Link, Leaders<double>> deepest_by_link;  // the deepest with that link broken

  std::uint64_t wrong(FlipKind kind) const {
    return kind == FlipKind::false_separation ? false_separation : false_contact;
  }
  double farthest() const { return std::max(farthest_false_separation.best(), farthest_false_contact.best()); }
  double deepest() const { return std::max(deepest_false_separation.best(), deepest_false_contact.best()); }

  static constexpr std::string_view about =
      "The kernel's verdicts on the queries within its limits, against the geometric truth and, where the sphere "
      "touches, its own convention.";
  AXISCERT_FIELDS(
      VerdictTally,
      AXISCERT_FIELD(decided_contacts,
                     "Contacts that the kernel called contact or separated; where it promises to call a touching "
                     "sphere separated, that is "
                     "none, and where it promises nothing, neither."),
      AXISCERT_FIELD(decided_separations, "Separations that it called one of the two, by the same promise."),
      AXISCERT_FIELD(decided_touching, "Those of either that touch."),
      AXISCERT_FIELD(decided, "Contacts and separations together."),
      field(&Of::false_separation,
            figure_of("decided_contacts", "false_separation",
                      "Missed contacts: the kernel says separated, the truth is contact. The dangerous ones.")),
      field(&Of::false_contact, figure_of("decided_separations", "false_contact",
                                          "Phantom contacts: the kernel says contact, the truth is separated.")),
      AXISCERT_FIELD(undecided, "Valid queries that the kernel declined to decide. Not wrong verdicts."),
      AXISCERT_FIELD(undecided_contact, "Those of undecided whose truth is contact."),
      AXISCERT_FIELD(undecided_touching, "Those of undecided_contact that touch."),
      AXISCERT_FIELD(invalid, "Valid queries that the kernel called invalid. Not counted as wrong verdicts."),
      AXISCERT_FIELD(unanswered,
                     "Valid queries without an answer: the kernel crashed, hung, or was not asked because of that. Not "
                     "counted as wrong verdicts."),
      field(&Of::deepest,
            figure_of("decided", "deepest",
                      "Largest depth |d - r| / max(|A-P|, |B-P|, |C-P|, r) of a wrong verdict, d the exact distance; 0 "
                      "where there is none.",
                      "of the scene")),
      field(&Of::deepest_false_separation, figure_of("decided_contacts", "deepest_false_separation",
                                                     "The same over missed contacts.", "of the scene")),
      field(&Of::deepest_false_contact, figure_of("decided_separations", "deepest_false_contact",
                                                  "The same over phantom contacts.", "of the scene")),
      field(&Of::farthest_false_separation,
            figure_of("decided_contacts", "farthest_false_separation",
                      "The greatest length by which a missed contact is off: from touching, in the queries' unit; 0 "
                      "where there is none.",
                      "length")),
      field(&Of::farthest_false_contact,
            figure_of("decided_separations", "farthest_false_contact", "The same over phantom contacts.", "length")),
      field(
          &Of::links,
          figure_of("decided", "links",
                    "Wrong verdicts with each link of the chain broken: geometric truth G, exact formula E, unbounded "
                    "exponent R-infinity, reference R, kernel K. One verdict may break several, so these do not add "
                    "up to the wrong verdicts.")),
      field(&Of::masked_links,
            figure_of("decided", "masked_links", "Right verdicts with each link broken: the breaks cancelled.")),
      AXISCERT_FIELD(
          first_by_link,
          "The first query of the family, counted from 1, with a wrong verdict and this link broken; touching queries, "
          "which a convention may explain, are not counted, except for implementation; null: none."),
      field(&Of::touching_flips,
            figure_of("decided_touching", "touching_flips", "Wrong verdicts on touching queries.")),
      field(&Of::touching_links, figure_of("decided_touching", "touching_links", "Broken links on touching queries.")),
      AXISCERT_FIELD(outside_limits, "Valid queries outside the kernel's limits; null where it declares none."),
      AXISCERT_FIELD(clear,
                     "Answers to clear queries; null for a kernel with a reference, whose links say why it is wrong."),
      AXISCERT_FIELD(depths, "Wrong verdicts by decade of depth; null where the predicate has no depth."),
      field(&VerdictTally::engine,
            {"engine_like", "What is left on engine-like queries; null where the predicate has none."}),
      journalled(&VerdictTally::deepest_by_link))
};

struct CriticalRadiusTally {
  // Unsorted, of a source at most 2^16 (has_critical_radius); negative where the kernel says contact too early, at a
  // radius below the exact distance.
  std::vector<double> errors_ulps;
  std::uint64_t unbounded = 0;               // contact for no radius, finite and within the limits
  std::uint64_t unanswered = 0;              // not measured: a radius got no answer
  std::uint64_t undecided = 0, invalid = 0;  // not measured: that was the answer to some radius

  AXISCERT_FIELDS(CriticalRadiusTally, journalled(&Of::errors_ulps), journalled(&Of::unbounded),
                  journalled(&Of::unanswered), journalled(&Of::undecided), journalled(&Of::invalid))
};

// One kind of finding: how often, and the first of them.
struct FindingTally {
  std::uint64_t count = 0, first = 0;
  std::string detail;  // of the first

  void merge(const FindingTally& other);
  AXISCERT_FIELDS(FindingTally, journalled(&FindingTally::count), journalled(&FindingTally::first),
                  journalled(&FindingTally::detail))
};

struct Tally {
  std::uint64_t trials = 0;
  TruthCounts truth;
  VerdictTally verdict;
  NamedValues<AxisTally> axes;  // by clause
  NamedValues<ComparisonTally> comparisons;
  CriticalRadiusTally critical_radius;
  EnumArray<FindingKind, FindingTally> findings;
  ClassTally classes;             // of a kernel with has_input_classes()
  ContactTally contacts;          // of a predicate with measures
  std::uint64_t asked_again = 0;  // queries asked again in another order of their batch
  std::uint64_t with_signs = 0;   // queries of which every sign was compared: SignTally::judged of each in a record

  void merge(const Tally& other);
  AXISCERT_FIELDS(Tally, journalled(&Tally::trials), journalled(&Tally::truth), journalled(&Tally::verdict),
                  journalled(&Tally::axes), journalled(&Tally::comparisons), journalled(&Tally::critical_radius),
                  journalled(&Tally::findings), journalled(&Tally::classes), journalled(&Tally::contacts),
                  journalled(&Tally::asked_again), journalled(&Tally::with_signs))
};

// Nothing counted, for every clause and comparison of a predicate.
Tally empty_tally(const Predicate& predicate);

// The leaders that other units of the same cell have found: a query that is certainly no greater is not evaluated.
struct StandingLeaders {
  std::vector<Leaders<Decimal6>> largest_error;  // by comparison
  VerdictTally verdict;                          // its leaders

  bool could_keep_depth(const Flip& flip, const Candidate<double>& at_most) const;
  bool could_keep_length(const Flip& flip, const Candidate<double>& at_most) const;
};
StandingLeaders standing_of(const Tally& tally);

// Tolerated error by comparison, in u; none: not checked.
class Tolerances {
 public:
  const std::optional<Rational>& operator[](std::size_t comparison) const {
    static const std::optional<Rational> none;
    return comparison < given_.size() ? given_[comparison] : none;
  }
  void set(std::size_t comparison, const Rational& tolerated) {
    if (given_.size() <= comparison) given_.resize(comparison + 1);
    given_[comparison] = tolerated;
  }

 private:
  std::vector<std::optional<Rational>> given_;
};

// Counts everything of a query within the kernel's limits but the errors of the sides. `ties` are those of the kernel's
// own formulae in exact arithmetic, where they have comparisons; `depth` is asked where the verdict is wrong.
void count(Tally& tally, std::uint64_t position, const Truth& truth, ComparisonBits ties, const Answer& answer,
           const Judgement& judgement, DepthOf& depth, const StandingLeaders& standing);

// The part of count() that adds up: the same for each of `times` queries with this judgement.
void count_numbers(Tally& tally, const Truth& truth, ComparisonBits ties, const Answer& answer,
                   const Judgement& judgement, std::uint64_t times);
// The part of count() that counts engine-like queries.
void count_engine(Tally& tally, DepthOf& depth, const std::optional<Verdict>& right_of_decided);
// The part of count() that counts and keeps the depth of a wrong verdict.
void count_depth(Tally& tally, std::uint64_t position, const Flip& flip, DepthOf& depth,
                 const StandingLeaders& standing);

// Counts a valid query outside the kernel's limits.
void count_outside(Tally& tally, const Truth& truth, const Answer& answer, const Judgement& judgement, DepthOf& depth);

void count_finding(Tally& tally, FindingKind kind, std::uint64_t position, const std::string& detail);

// A smaller error than the largest so far may round up to the same decimal, at an earlier position.
inline double least_of_interest(const ComparisonTally& comparison) {
  return comparison.largest_error.best().value() * Decimal6::least_ratio;
}

// Counts the error of one comparison's sides. Returns whether it exceeds what is tolerated.
bool count_side_error(ComparisonTally& comparison, std::uint64_t position, const SideError& error,
                      const std::optional<Rational>& tolerated);

// Counts the errors of the sides of query `index` of a batch, whose answers are `computed`, against its exact sides.
template <class Real>
void count_errors(Tally& tally, std::uint64_t position, const Predicate& predicate, const ExactSides& exact,
                  const Answers<Real>& computed, std::size_t index, const Tolerances& tolerances);

}  // namespace axiscert

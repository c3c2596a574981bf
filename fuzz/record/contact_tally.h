// The counts of what a kernel says beside its verdicts: times, tunnels, separations, features, normals and points.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "exact/judge/contact_judgement.h"
#include "fuzz/record/leaders.h"
#include "fuzz/record/wrong_verdicts.h"
#include "fuzz/text/field.h"
#include "fuzz/text/values.h"
#include "kernel/predicate.h"

namespace axiscert {

// Errors of times by powers of two, in units in the last place: number k counts those above 2^(k-1) and at most 2^k;
// the first also all that are less, the last all that are more.
inline constexpr std::size_t ulp_powers = 32;
std::size_t ulp_power(const Decimal6& ulps);
struct UlpPowers {
  static constexpr std::size_t size = ulp_powers;
  static std::string name(std::size_t power) { return std::to_string(power); }
  static constexpr std::string_view about =
      "Counts by ulps: K has those above 2^(K-1) and at most 2^K; 0 also all that are less, 31 all that are more.";
};
using UlpCounts = SparseCounts<UlpPowers>;

// Times on one side of the best one.
struct TimeErrors {
  Leaders<Decimal6> largest_ulps, largest_in_u;
  Leaders<double> largest_share, largest_length;
  UlpCounts by_power{};

  static constexpr std::string_view about = "Errors of times on one side of the best one.";
  static constexpr auto fields(auto&& visit) {
    return visit(
        field(
            &TimeErrors::largest_ulps,
            {"largest_ulps",
             "Greatest distance from the first contact, in units in the last place of the best time; 0 where there is "
             "none.",
             "ulps"}),
        field(&TimeErrors::largest_in_u, {"largest_in_u", "The same in u = 2^-24 or 2^-53 of the displacement.", "u"}),
        field(&TimeErrors::largest_share,
              {"largest_share", "Greatest distance from the first contact, as a share of the way.", "of the way"}),
        field(&TimeErrors::largest_length,
              {"largest_length", "Greatest distance of the centre from where it is at the first contact.", "length"}),
        field(&TimeErrors::by_power, {"by_power", {}}));
  }
};

// An error of a time in words: "2.5 ulps" up to 2^13 of them, at most 2^-10 of the way. More of them say nothing: then
// "12 % of the way, length 1.4", in the queries' unit.
std::string time_error_text(const Decimal6& ulps, double share, double length);
std::string way_text(double share, double length);
bool is_told_in_ulps(const Decimal6& ulps);
// The greatest of each: in ulps where all are told in them; of the way and in length.
std::string time_error_text(const TimeErrors& errors);
std::string way_text(const TimeErrors& errors);

// Tunnels that late hits make, or misses.
struct TunnelTally {
  std::uint64_t through = 0;
  Leaders<Decimal6> deepest;

  static constexpr std::string_view about =
      "How far the sphere goes into the triangle unseen: (r - least distance of the motion) / r.";
  static constexpr auto fields(auto&& visit) {
    return visit(
        field(&TunnelTally::through,
              {"through", "Those of exactly 1: the centre comes to the triangle. So it always is for a point, r = 0."}),
        field(&TunnelTally::deepest,
              {"deepest_tunnel", "The deepest, rounded down to six digits; 0 where there is none.", "radii"}));
  }
};

// Which of some answers, as a mark that two sets share only where they are equal, but for one case in 2^64.
struct MarkRule {
  static constexpr std::size_t longest = 16;
  static constexpr std::string_view pattern = "^([1-9a-f][0-9a-f]*)?$";
  static constexpr bool may_be_empty = true;
};
struct AnswerSet {
  std::uint64_t mark = 0;

  void add(std::uint64_t position);
  void merge(const AnswerSet& other) { mark ^= other.mark; }
  void put(auto& encoder) const { encoder.put(mark); }
  void get(auto& decoder) { decoder.get(mark); }
  using Written = Text<MarkRule>;  // in hexadecimal; empty: none
  Written written() const;
  void take(const Written& written);
};

// Which answers have a number, by the verdict that they say.
struct GivenTally {
  std::uint64_t contacts = 0, separations = 0;
  AnswerSet which_contacts, which_separations;

  static constexpr std::string_view about =
      "The answers that have the number as one that is finite, of a time one from 0 to 1; whether or not there is an "
      "exact "
      "one.";
  AXISCERT_FIELDS(GivenTally, AXISCERT_FIELD(contacts, "Those that say contact.", "answers"),
                  AXISCERT_FIELD(separations, "Those that say separated.", "answers"),
                  AXISCERT_FIELD(which_contacts, "A mark of which, in hexadecimal: another mark, other answers.",
                                 "mark"),
                  AXISCERT_FIELD(which_separations, "The same of those that say separated.", "mark"))
};

struct TimeTally {
  std::uint64_t none = 0, invalid = 0, early = 0, best = 0, late = 0;
  GivenTally given;

  std::uint64_t judged() const { return early + best + late; }
  TimeErrors late_errors;
  TunnelTally late_tunnels;
  TimeErrors early_errors;
  Leaders<double> largest_gap;
  Leaders<bool> no_time;  // the first hit whose time is `none` or `invalid`; ranked by whether it is given

  static constexpr std::string_view about = "The times of answers: none + invalid + early + best + late = answers.";
  static constexpr auto fields(auto&& visit) {
    return visit(
        field(&TimeTally::none, {"none", "Answers whose time is NaN."}),
        field(&TimeTally::invalid, {"invalid", "Answers whose time is infinite or outside [0, 1]."}),
        field(&TimeTally::early, {"early", "Times before the best one."}),
        field(&TimeTally::best, {"best", "Times that are the greatest number of the precision that is not late."}),
        field(&TimeTally::late, {"late", "Times after the first contact, the unsafe ones."}),
        field(&TimeTally::given, {"given", GivenTally::about}),
        field(&TimeTally::judged, {"judged", "early + best + late."}),
        field(&TimeTally::late_errors, figure_of("judged", "late_errors", "How late.")),
        field(&TimeTally::late_tunnels, figure_of("judged", "late_tunnels", "Of the motions until late times.")),
        field(&TimeTally::early_errors, figure_of("judged", "early_errors", "How early.")),
        field(&TimeTally::largest_gap,
              figure_of("judged", "largest_gap", "Greatest distance less r at an early time, relative to the scene.",
                        "of the scene")),
        journalled(&TimeTally::no_time));
  }
};

// The numbers of an answer against each other.
struct ConsistencyTally {
  std::uint64_t judged = 0, contacts = 0, separations = 0, positive = 0, negative = 0, missing = 0;
  EnumArray<Consistency, Leaders<bool>> first;  // of each kind

  static constexpr std::string_view about = "Answers whose numbers contradict each other, or their verdict.";
  static constexpr auto fields(auto&& visit) {
    using Of = ConsistencyTally;
    return visit(field(&Of::judged, {"judged", "Answers with a number."}),
                 field(&Of::contacts, {"contacts", "Those that say contact, with a separation that is a number."}),
                 field(&Of::separations, {"separations", "The same of those that say separated."}),
                 field(&Of::positive, figure_of("contacts", "positive", "Contacts with a separation above 0.")),
                 field(&Of::negative, figure_of("separations", "negative", "Separated, with a separation below 0.")),
                 field(&Of::missing,
                       figure_of("judged", "missing", "Answers with some numbers, and without another that there is.")),
                 journalled(&Of::first));
  }
};

// Separations of a kernel that declares a margin, against the exact ones less that.
struct LessMarginTally {
  Leaders<double> largest_error, largest_length;

  static constexpr std::string_view about =
      "The same separations against the exact ones less the margin that the kernel declares: so gives them a kernel "
      "that adds it to its bodies. It is judged by the lesser of the two greatest errors. Absent where it declares "
      "none.";
  static constexpr auto fields(auto&& visit) {
    using Of = LessMarginTally;
    return visit(
        field(&Of::largest_error, {"largest_error", "Greatest difference, relative to the scene.", "of the scene"}),
        field(&Of::largest_length, {"largest_length", "Greatest difference.", "length"}));
  }
};

// Separations against the exact ones: the distance where the two are apart, less the penetration where not.
struct SeparationTally {
  std::uint64_t judged = 0, none = 0;
  GivenTally given;
  DecadeCounts by_decade{};
  Leaders<double> largest_error, largest_length;
  Leaders<Decimal6> largest_ulps, largest_in_u;
  std::optional<LessMarginTally> less_margin;
  Leaders<bool> first_none;

  // The greatest errors that it is judged by.
  bool has_margin() const { return less_margin && less_margin->largest_error.best() < largest_error.best(); }
  double worst_share() const { return has_margin() ? less_margin->largest_error.best() : largest_error.best(); }
  double worst_length() const { return has_margin() ? less_margin->largest_length.best() : largest_length.best(); }

  static constexpr std::string_view about = "The separations that a kernel gives, against the exact ones.";
  static constexpr auto fields(auto&& visit) {
    using Of = SeparationTally;
    return visit(
        field(&Of::judged, {"judged", "Answers with a separation that is a number."}),
        field(&Of::none, {"none", "Answers without one, though they have other numbers."}),
        field(&Of::given, {"given", GivenTally::about}), field(&Of::by_decade, {"by_decade", {}}),
        field(&Of::largest_error,
              figure_of("judged", "largest_error", "Greatest difference, relative to the scene.", "of the scene")),
        field(&Of::largest_length, figure_of("judged", "largest_length", "Greatest difference.", "length")),
        field(&Of::largest_ulps,
              figure_of("judged", "largest_ulps",
                        "Greatest difference in units in the last place of the number nearest to the exact one.",
                        "ulps")),
        field(&Of::largest_in_u,
              figure_of("judged", "largest_in_u", "Greatest difference in u = 2^-24 or 2^-53 of the scene.", "u")),
        field(&Of::less_margin,
              {.name = "less_margin", .about = LessMarginTally::about, .may_be_absent = true, .looked_at = "judged"}),
        journalled(&Of::first_none));
  }
};

struct FeatureTally {
  std::uint64_t judged = 0, none = 0, wrong = 0, unnamed = 0;
  GivenTally given;
  Leaders<double> largest_error;
  Leaders<bool> first_wrong, first_none;

  static constexpr auto fields(auto&& visit) {
    return visit(
        field(&FeatureTally::judged, {"judged", "Answers with a feature."}),
        field(&FeatureTally::none,
              {"none",
               "Answers without one: contacts of motions that do not overlap at the start, and answers of other "
               "predicates with other numbers."}),
        field(&FeatureTally::wrong,
              figure_of("judged", "wrong",
                        "Those that name a part that is not nearest, of motions at the first contact.")),
        field(&FeatureTally::unnamed,
              figure_of("judged", "unnamed", "Of the wrong ones, those whose number names no part.")),
        field(&FeatureTally::given, {"given", GivenTally::about}),
        field(&FeatureTally::largest_error,
              figure_of(
                  "judged", "largest_error",
                  "Greatest distance of the centre, of motions at the first contact, beyond a plane that bounds the "
                  "region in which the "
                  "part that is named is nearest, relative to the scene; of those that name one.",
                  "of the scene")),
        journalled(&FeatureTally::first_wrong), journalled(&FeatureTally::first_none));
  }
};

struct NormalTally {
  std::uint64_t judged = 0, lengths = 0, none = 0;
  GivenTally given;
  Leaders<double> largest_angle, largest_length_error;
  Leaders<bool> first_none;

  static constexpr auto fields(auto&& visit) {
    return visit(
        field(&NormalTally::judged,
              {"judged", "Answers with a normal, where there is a single exact one, of motions at the first contact."}),
        field(&NormalTally::lengths, {"lengths", "Answers with a normal, whose length was judged."}),
        field(&NormalTally::none,
              {"none", "Answers without one, though there is one; of motions that overlap at the start not counted."}),
        field(&NormalTally::given, {"given", GivenTally::about}),
        field(&NormalTally::largest_angle,
              figure_of("judged", "largest_angle", "Greatest angle between it and the exact one, in radians.",
                        "radians")),
        field(
            &NormalTally::largest_length_error,
            figure_of("lengths", "largest_length_error", "Greatest difference of its length from 1.", "of its length")),
        journalled(&NormalTally::first_none));
  }
};

// What is left of penetrations where bodies are pushed along the normals that a kernel gives.
struct PushTally {
  std::uint64_t judged = 0, none = 0, nowhere = 0, flips = 0;
  Leaders<Decimal6> largest_left;
  Leaders<bool> first_flip, first_none;

  std::uint64_t with_a_side() const { return judged - nowhere; }

  static constexpr std::string_view about =
      "What is left of the penetration when the second body is pushed by the exact depth along the normal that is "
      "given, "
      "divided by its exact length: a share of that depth. 0 of every right choice, 1 where the push does nothing, 2 "
      "at "
      "most.";
  static constexpr auto fields(auto&& visit) {
    using Of = PushTally;
    return visit(
        field(&Of::judged,
              {"judged",
               "Answers with a normal where the exact depth is above 0; one of 0 leaves all of it, and counts unless "
               "the centre is on the triangle."}),
        field(&Of::none, {"none", "Answers without a normal there, though there is one."}),
        field(&Of::nowhere, {"nowhere", "Those judged whose normal is 0: it has no side."}),
        field(&Of::with_a_side, {"with_a_side", "judged - nowhere."}),
        field(&Of::flips, figure_of("with_a_side", "flips",
                                    "Those with more than 1/16 left, and a normal at more than a right angle to every "
                                    "exact one; none where "
                                    "the exact side is within the rounding of a difference of the query's numbers.")),
        field(&Of::largest_left, figure_of("judged", "largest_left",
                                           "The most that is left, rounded up; 0 where nothing is.", "of the depth")),
        journalled(&Of::first_flip), journalled(&Of::first_none));
  }
};

struct PointTally {
  std::uint64_t judged = 0, none = 0;
  GivenTally given;
  Leaders<double> largest_error;
  Leaders<bool> first_none;

  static constexpr auto fields(auto&& visit) {
    return visit(
        field(&PointTally::judged, {"judged", "Answers with a point, where it can be judged."}),
        field(&PointTally::none,
              {"none", "Answers without one, though there is one; of motions that overlap at the start not counted."}),
        field(&PointTally::given, {"given", GivenTally::about}),
        field(
            &PointTally::largest_error,
            figure_of("judged", "largest_error",
                      "Greatest distance from the exact point, of motions at the first contact; of two bodies from the "
                      "body whose point it is. Relative to the scene.",
                      "of the scene")),
        journalled(&PointTally::first_none));
  }
};

// How far a push by the way between the two points is from the shortest, or their distance from that of the bodies.
struct PointsTally {
  std::uint64_t judged = 0;
  Leaders<double> largest_error;

  static constexpr auto fields(auto&& visit) {
    return visit(
        field(&PointsTally::judged, {"judged", "Answers with both points."}),
        field(&PointsTally::largest_error,
              figure_of("judged", "largest_error", "Greatest difference, relative to the scene.", "of the scene")));
  }
};

// The optional ones are empty where the kernel does not give that measure, or the predicate has no such thing.
struct ContactTally {
  std::uint64_t answers = 0, separations = 0;
  std::optional<std::uint64_t> decided = 0;
  std::optional<TunnelTally> missed = TunnelTally();
  std::optional<TimeTally> time = TimeTally();
  std::optional<ConsistencyTally> consistency = ConsistencyTally();
  std::optional<SeparationTally> separation = SeparationTally();
  std::optional<FeatureTally> feature = FeatureTally();
  std::optional<NormalTally> normal = NormalTally();
  std::optional<PushTally> pushed = PushTally();
  std::optional<PointTally> point = PointTally(), point_a = PointTally(), point_b = PointTally();
  std::optional<PointsTally> points = PointsTally();

  static constexpr std::string_view about =
      "What the kernel says beside its verdicts, against what is exact. Of motions that is of the first contact.";
  static constexpr auto fields(auto&& visit) {
    using Of = ContactTally;
    return visit(field(&Of::answers, {"answers",
                                      "Answers whose measures are judged: of motions the contacts that are right, else "
                                      "all within its promises."}),
                 field(&Of::separations, {"separations", "Of these, those that say separated.", "answers"}),
                 field(&Of::decided, {"decided",
                                      "Of motions the contacts that it decided: the answers, and those that it missed. "
                                      "Null in another predicate.",
                                      "answers"}),
                 field(&Of::missed,
                       figure_of("decided", "missed", "The missed contacts of motions. Null in another predicate.")),
                 field(&Of::time, {"time", "Null where the kernel gives no time."}),
                 field(&Of::consistency, {"consistency", "Null where the kernel gives no separation."}),
                 field(&Of::separation, {"separation", "Null where the kernel gives none."}),
                 field(&Of::feature, {"feature", "Null where the kernel gives none."}),
                 field(&Of::normal, {"normal", "Null where the kernel gives none."}),
                 field(&Of::pushed, {"pushed", "Null where the kernel gives no normal, and of motions."}),
                 field(&Of::point, {"point", "Null where the kernel gives none."}),
                 field(&Of::point_a, {"point_a", "Of the first body. Null where the kernel gives none."}),
                 field(&Of::point_b, {"point_b", "Of the second body. Null where the kernel gives none."}),
                 field(&Of::points, {"points", "Null where the kernel does not give both."}));
  }
};

// "an answer without a point": as witnesses say it, by which levels find them.
namespace missing_texts {
inline constexpr std::string_view separation = "without a separation", feature = "without a feature",
                                  normal = "without a normal", push = "without a normal along which to push",
                                  point = "without a point";
inline std::string of_answer(std::string_view what) { return std::string("an answer ").append(what); }
}  // namespace missing_texts

// Calls visit(kind, part) for each number, with the part of the tally that has its GivenTally.
void for_each_number(auto& tally, auto&& visit) {
  visit(MeasureKind::time, tally.time);
  visit(MeasureKind::separation, tally.separation);
  visit(MeasureKind::feature, tally.feature);
  visit(MeasureKind::normal, tally.normal);
  visit(MeasureKind::point, tally.point);
  visit(MeasureKind::point_a, tally.point_a);
  visit(MeasureKind::point_b, tally.point_b);
}

void count_contact(ContactTally& tally, std::uint64_t position, const ContactJudgement& judgement);
// Which of the numbers an answer has, as it is counted by count_contact().
void count_given(ContactTally& tally, std::uint64_t position, const Predicate& predicate, Verdict said,
                 std::span<const double> measures);
// Without the parts that a kernel of the predicate does not give, with so many of its measures.
ContactTally given_contacts(ContactTally tally, const Predicate& predicate, std::size_t measure_count);

}  // namespace axiscert

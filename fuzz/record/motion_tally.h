// The counts of the first contacts that a kernel reports: times, tunnels, features, normals and points.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "exact/judge/motion_judgement.h"
#include "fuzz/record/leaders.h"
#include "fuzz/fields/sparse.h"

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

struct TimeTally {
  std::uint64_t none = 0, invalid = 0, early = 0, best = 0, late = 0;
  TimeErrors late_errors;
  TunnelTally late_tunnels;
  TimeErrors early_errors;
  Leaders<double> largest_gap;
  Leaders<bool> no_time;  // the first hit whose time is `none` or `invalid`; ranked by whether it is given

  static constexpr std::string_view about = "The times of hits: none + invalid + early + best + late = hits.";
  static constexpr auto fields(auto&& visit) {
    return visit(
        field(&TimeTally::none, {"none", "Hits whose time is NaN."}),
        field(&TimeTally::invalid, {"invalid", "Hits whose time is infinite or outside [0, 1]."}),
        field(&TimeTally::early, {"early", "Times before the best one."}),
        field(&TimeTally::best, {"best", "Times that are the greatest number of the precision that is not late."}),
        field(&TimeTally::late, {"late", "Times after the first contact, the unsafe ones."}),
        field(&TimeTally::late_errors, {"late_errors", "How late."}),
        field(&TimeTally::late_tunnels, {"late_tunnels", "Of the motions until late times."}),
        field(&TimeTally::early_errors, {"early_errors", "How early."}),
        field(&TimeTally::largest_gap,
              {"largest_gap", "Greatest distance less r at an early time, relative to the scene.", "of the scene"}),
        journalled(&TimeTally::no_time));
  }
};

struct FeatureTally {
  std::uint64_t judged = 0, none = 0, wrong = 0, unnamed = 0;
  Leaders<double> largest_error;
  Leaders<bool> first_wrong;

  static constexpr auto fields(auto&& visit) {
    return visit(
        field(&FeatureTally::judged, {"judged", "Hits with a feature."}),
        field(&FeatureTally::none, {"none", "Hits without one, those that overlap at the start not counted."}),
        field(&FeatureTally::wrong, {"wrong", "Those that name a part that is not nearest at the first contact."}),
        field(&FeatureTally::unnamed, {"unnamed", "Of the wrong ones, those whose number names no part."}),
        field(
            &FeatureTally::largest_error,
            {"largest_error",
             "Greatest distance of the centre at the first contact beyond a plane that bounds the region in which the "
             "part that is named is nearest, relative to the scene; of those that name one.",
             "of the scene"}),
        journalled(&FeatureTally::first_wrong));
  }
};

struct NormalTally {
  std::uint64_t judged = 0, none = 0;
  Leaders<double> largest_angle, largest_length_error;

  static constexpr auto fields(auto&& visit) {
    return visit(
        field(&NormalTally::judged,
              {"judged", "Hits with a normal, on which the distance at the first contact is not 0."}),
        field(&NormalTally::none,
              {"none", "Hits without one, those that overlap at the start, or at the distance 0, not counted."}),
        field(&NormalTally::largest_angle,
              {"largest_angle", "Greatest angle between it and the exact one, in radians.", "radians"}),
        field(&NormalTally::largest_length_error,
              {"largest_length_error", "Greatest difference of its length from 1.", "of its length"}));
  }
};

struct PointTally {
  std::uint64_t judged = 0, none = 0;
  Leaders<double> largest_error;

  static constexpr auto fields(auto&& visit) {
    return visit(field(&PointTally::judged, {"judged", "Hits with a point."}),
                 field(&PointTally::none, {"none", "Hits without one, those that overlap at the start not counted."}),
                 field(&PointTally::largest_error,
                       {"largest_error",
                        "Greatest distance from the triangle's point nearest to the centre at the first contact, "
                        "relative to the scene.",
                        "of the scene"}));
  }
};

// The optional ones are empty where the kernel does not give that measure.
struct MotionTally {
  std::uint64_t hits = 0;
  TunnelTally missed;
  std::optional<TimeTally> time = TimeTally();
  std::optional<FeatureTally> feature = FeatureTally();
  std::optional<NormalTally> normal = NormalTally();
  std::optional<PointTally> point = PointTally();

  static constexpr std::string_view about = "The first contacts that the kernel reports, against the exact one.";
  static constexpr auto fields(auto&& visit) {
    return visit(
        field(&MotionTally::hits, {"hits", "Contacts that are right, on which the kernel's measures are judged."}),
        field(&MotionTally::missed, {"missed", "The missed contacts."}),
        field(&MotionTally::time, {"time", "Null where the kernel gives no time."}),
        field(&MotionTally::feature, {"feature", "Null where the kernel gives none."}),
        field(&MotionTally::normal, {"normal", "Null where the kernel gives none."}),
        field(&MotionTally::point, {"point", "Null where the kernel gives none."}));
  }
};

void count_hit(MotionTally& tally, std::uint64_t position, const MotionJudgement& judgement);
void count_missed(MotionTally& tally, std::uint64_t position, const Tunnel& tunnel);

}  // namespace axiscert

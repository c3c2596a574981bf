// The judgement of what a kernel says beside its verdict: the numbers of a first contact, of a predicate of motions,
// and those of how far apart or how deep in each other two bodies are.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "exact/numbers/rational.h"
#include "kernel/base/enums.h"
#include "kernel/outcome.h"

namespace axiscert {

// The time beside a contact that is right. Late is unsafe: what is moved to that time is in the obstacle.
enum class TimeVerdict : std::uint8_t {
  none,     // NaN: not given
  invalid,  // infinite, or outside [0, 1]
  early,    // less than the greatest number of the precision that is not late
  best,     // that number
  late,     // after the first contact
};
template <>
inline constexpr std::size_t enum_count<TimeVerdict> = 5;
inline constexpr EnumArray<TimeVerdict, std::string_view> time_verdict_names = {"none", "invalid", "early", "best",
                                                                                "late"};
constexpr std::string_view name(TimeVerdict which) { return time_verdict_names[which]; }

// How far the moving body goes into the obstacle, or through it, before the contact that is reported, and without one
// in the whole motion: (r - least distance of that motion) / r. 1: the centre comes to the obstacle itself, as that of
// a point (r = 0) always does.
struct Tunnel {
  Decimal6 depth;   // rounded down: it is at least F, a number of at most six digits, exactly where the tunnel is
  bool is_through;  // exactly 1
};

// The numbers of one answer against each other, and against its verdict; no oracle is asked.
enum class Consistency : std::uint8_t {
  consistent,
  positive,  // a contact with a separation above 0
  negative,  // separated with a separation below 0
  missing,   // without a separation that is a number, or without another that there is, beside those that are given
};
template <>
inline constexpr std::size_t enum_count<Consistency> = 4;
inline constexpr EnumArray<Consistency, std::string_view> consistency_names = {"consistent", "positive", "negative",
                                                                               "missing"};
constexpr std::string_view name(Consistency which) { return consistency_names[which]; }
// As witnesses have it, by which levels find them.
inline constexpr EnumArray<Consistency, std::string_view> consistency_words = {
    "numbers that agree", "a contact with a separation above 0", "a separation below 0 beside separated",
    "an answer without one of its numbers"};

// |s^ - s| of a finite separation s^. Sizes are of the exact difference, rounded once.
struct SeparationError {
  Decimal6 ulps, in_u;           // in units in the last place of the float nearest to s, and in u of the scene; up
  double share = 0, length = 0;  // relative to the scene, as a depth, and in the query's unit
};

// What pushing along a normal leaves. The second body is moved by the exact depth along the normal that is given,
// divided by its exact length.
struct Pushed {
  Decimal6 left;            // the penetration then, as a share of the exact depth, from 0 to 2: rounded up
  bool is_flip = false;     // above 1/16, with more than a right angle to every exact normal
  bool is_nowhere = false;  // along a normal of length 0, which has no angle
};

// Sizes are decided exactly and rounded once, or to 2^-240 before.
struct ContactJudgement {
  // Members of motions.
  std::optional<TimeVerdict> time;  // empty: the kernel gives no times
  // Early or late: |t^ - t*| in units in the last place of the best number, and in u = 2^-24 or 2^-53; rounded up.
  Decimal6 ulps, in_u;
  double share = 0, length = 0;  // the same of the way, and times |D|: nearest of binary64, at most the greatest
  std::optional<Tunnel> tunnel;  // of a late time
  std::optional<Tunnel> missed;  // of an answer that there is no contact; nothing else is judged then
  double gap = 0;                // of an early time: distance - r at that time, relative to the scene

  // Members of two bodies as they are, whatever the verdict.
  std::optional<Consistency> consistency;     // empty: the kernel gives no separation
  std::optional<SeparationError> separation;  // of a number
  // The same against the exact separation less the margin that the kernel declares; empty too where it declares none.
  std::optional<SeparationError> separation_less_margin;
  // There for a normal where the depth is above 0. One of length 0 leaves all of it; beside a sphere whose centre is on
  // the triangle it counts as none.
  std::optional<Pushed> pushed;
  // How far each of two points, one of each body, is from its body; and how far a push that brings them together is
  // from the shortest that parts the bodies, or of bodies apart their distance from the least.
  std::optional<double> point_a_error, point_b_error, points_apart;

  // Empty where not given.
  std::optional<bool> feature_is_right;
  // How far the centre is, at the contact, beyond a plane that bounds the region in which a wrong feature's part
  // is nearest, relative to the scene; infinite where the number names no part.
  std::optional<double> feature_error;
  // At the contact; the angle is empty too where there is no exact normal, or more than one.
  std::optional<double> normal_angle;         // radians; pi of a normal of zero
  std::optional<double> normal_length_error;  // | |n| - 1 |
  std::optional<double> point_error;  // relative to the scene; empty too where the exact point is not the only one
  // A measure that the kernel gives elsewhere is no number here, though there is one.
  bool lacks_feature = false, lacks_normal = false, lacks_point = false, lacks_separation = false;
  bool lacks_push = false;        // lacks_normal, where the depth is above 0
  bool has_right_normal = false;  // of a kernel that gives normals: some normal is right, and not every one
};

// The exact contact, to be shown: each number is the nearest of binary64.
struct ContactPlace {
  using Place = std::optional<std::array<double, 3>>;  // empty where there is none, or more than one
  std::optional<double> after_best = {};               // of a first contact: its time less the best time
  std::optional<double> separation = {};               // of bodies as they are
  Place point = {};    // of the triangle, the nearest to the centre; of two bodies the first's
  Place point_b = {};  // of two bodies the second's
  Place from_a = {};   // of a triangle, the same point less its first vertex
  Place normal = {};   // of length 1
};

// Judges the measures of any kernel's answers to one valid query.
class ContactJudge {
 public:
  virtual ~ContactJudge() = default;
  // `said` is contact or separated, with the first of the predicate's measures. Of motions the query has contact.
  virtual ContactJudgement judge(Verdict said, std::span<const double> measures) = 0;
  // The margin of the kernel whose answers are judged next, in the unit of length (Limits::margin).
  void declare_margin(double margin) { margin_ = exact(margin); }
  virtual ContactPlace place() const = 0;
  // The length of which shares of the scene are, rounded to the nearest.
  virtual double scene() const = 0;

 protected:
  Rational margin_ = 0;
};

}  // namespace axiscert

// The judgement of what a kernel says of a first contact beside its verdict: of the measures of a predicate of motions.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "exact/numbers/rational.h"
#include "kernel/base/enums.h"

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

// Sizes are decided exactly and rounded once, or to 2^-250 before.
struct MotionJudgement {
  std::optional<TimeVerdict> time;  // empty: the kernel gives no times
  // Early or late: |t^ - t*| in units in the last place of the best number, and in u = 2^-24 or 2^-53; rounded up.
  Decimal6 ulps, in_u;
  double share = 0, length = 0;  // the same of the way, and times |D|: nearest of binary64, at most the greatest
  std::optional<Tunnel> tunnel;  // of a late time
  double gap = 0;                // of an early time: distance - r at that time, relative to the scene
  // Empty where not given.
  std::optional<bool> feature_is_right;
  // Of a wrong feature: how far the centre is, at the exact first contact, beyond a plane that bounds the region in
  // which that part is nearest, relative to the scene; infinite where the number names no part.
  std::optional<double> feature_error;
  // At the exact first contact; both empty too where the distance is 0 then.
  std::optional<double> normal_angle;         // radians
  std::optional<double> normal_length_error;  // | |n| - 1 |
  std::optional<double> point_error;          // relative to the scene
  // A measure that the kernel gives elsewhere is no number here, though there is one, and no overlap at the start.
  bool lacks_feature = false, lacks_normal = false, lacks_point = false;
};

// The exact first contact, to be shown: each number is the nearest of binary64.
struct ContactPlace {
  double after_best;                            // its time less the best time
  std::array<double, 3> point;                  // of the obstacle, the nearest to the centre of what moves
  std::array<double, 3> from_a;                 // the same point less the obstacle's first vertex
  std::optional<std::array<double, 3>> normal;  // unit vector from there to the centre; empty where they are the same
};

// Judges the measures of any kernel's answers to one query, which has contact.
class MotionJudge {
 public:
  virtual ~MotionJudge() = default;
  // The measures beside a contact, the first of the predicate's.
  virtual MotionJudgement judge_hit(std::span<const double> measures) = 0;
  // The tunnel of an answer that there is no contact.
  virtual Tunnel judge_miss() = 0;
  virtual ContactPlace first() const = 0;
};

}  // namespace axiscert

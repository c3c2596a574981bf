// The aim of a search: the worst query for one kernel in one respect.
#pragma once

#include <cstdint>
#include <string>

#include "kernel/predicate.h"

namespace axiscert {

enum class Goal : std::uint8_t {
  // |(l^ - r^) - (l - r)| of a comparison's computed sides in u, on the queries that a proved bound is for (of
  // sphere-triangle those in the box of fuzz/sphere_triangle/search_box.h).
  error,
  // The same over |l| + |r|, as in the record. It is unbounded where both sides vanish.
  relative_error,
  // The exponent m of the first factor 2^m, up or down, at which a query of size 1/2 to 1 that is far from every change
  // of sign makes the comparison leave the range.
  overflow,
  underflow,
  // Depth of a wrong verdict; the length that a query has, as its radius, is the kernel's own critical one, or the
  // float
  // below it.
  missed_contact,
  phantom_contact,
  // The kernel's critical radius relative to the exact distance, in ulps of the latter.
  critical_radius,
};
template <>
inline constexpr std::size_t enum_count<Goal> = 7;
inline constexpr EnumArray<Goal, std::string_view> goal_names = {
    "error", "relative_error", "overflow", "underflow", "missed_contact", "phantom_contact", "critical_radius"};
constexpr bool is_about_a_comparison(Goal goal) { return goal < Goal::missed_contact; }
constexpr bool is_about_range(Goal goal) { return goal == Goal::overflow || goal == Goal::underflow; }

struct Aim {
  Goal goal;
  std::size_t which = 0;  // the comparison, for the goals about one
  bool operator==(const Aim&) const = default;
};

// "error plane.radius", "missed_contact".
inline std::string name(const Aim& aim, const Predicate& predicate) {
  const std::string goal(goal_names[aim.goal]);
  return is_about_a_comparison(aim.goal) ? goal + ' ' + std::string(predicate.comparisons[aim.which].name) : goal;
}

}  // namespace axiscert

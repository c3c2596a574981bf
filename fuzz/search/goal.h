// The aim of a search: the worst query for one kernel in one respect.
#pragma once

#include <string>
#include <vector>

#include "kernel/kernel.h"
#include "kernel/sphere_triangle/names.h"

namespace axiscert {

enum class Goal : std::uint8_t {
  // |(l^ - r^) - (l - r)| in u, if every coordinate of A - P, B - P and C - P lies in [-1, 1] and r in [0, 1], with P
  // free and the rounding of the translation included: the quantity that a proved bound limits.
  error,
  // The same over |l| + |r|, as in the record. It is unbounded where both sides vanish.
  relative_error,
  // For queries of a good shape (fuzz/search/range.h): the exponent m of the first factor 2^m, up or down, at which
  // such a query of size 1/2 to 1 makes the comparison leave the range.
  overflow,
  underflow,
  // Depth of a wrong verdict; the radius, or the length that another test has, is the kernel's own critical one, or the
  // float below it.
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
  Comparison which = Comparison::plane_radius;  // for the goals about a comparison
  bool operator==(const Aim&) const = default;
};

// "error plane.radius", "missed_contact".
std::string name(const Aim& aim);

// The aims that a search can have for a kernel: comparisons if it exposes their sides and claims formulae, restricted
// to `only` unless that is empty; verdicts only if `only` is empty. A kernel of a test other than sphere-triangle has
// wrong verdicts alone, and these where the test's oracles have a depth.
std::vector<Aim> aims_of(const Kernel& kernel, const std::vector<Comparison>& only);

}  // namespace axiscert

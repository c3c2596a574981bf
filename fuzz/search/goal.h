// What a search looks for: the worst of one kernel in one respect.
#pragma once

#include <string>
#include <vector>

#include "kernel/kernel.h"

namespace axiscert {

enum class Goal : std::uint8_t {
  // |(l^ - r^) - (l - r)| in u, where every coordinate of A - P, B - P and C - P lies in [-1, 1] and r in [0, 1], P
  // free,
  // the rounding of the translation included: what a proved bound is about.
  error,
  // The same over |l| + |r|, as the record has it. It has no bound where both sides vanish.
  relative_error,
  // Of queries of a good shape (fuzz/search/range.h): the exponent m of the first 2^m, up or down, by which such a
  // query
  // of size 1/2 to 1 is to be multiplied for the comparison to leave the range.
  overflow,
  underflow,
  // Depth of a wrong verdict; the radius is the kernel's own critical radius, or the float below it.
  missed_contact,
  phantom_contact,
  // Its critical radius against the exact distance, in ulps of that.
  critical_radius,
};
inline constexpr std::array<std::string_view, 7> goal_names = {
    "error", "relative_error", "overflow", "underflow", "missed_contact", "phantom_contact", "critical_radius"};
constexpr bool is_about_a_comparison(Goal goal) { return goal < Goal::missed_contact; }
constexpr bool is_about_range(Goal goal) { return goal == Goal::overflow || goal == Goal::underflow; }

struct Aim {
  Goal goal;
  Comparison which = Comparison::plane_radius;  // of the goals about a comparison
  bool operator==(const Aim&) const = default;
};

// "error plane.radius", "missed_contact".
std::string name(const Aim& aim);

// What there is to look for in a kernel: comparisons where it shows their sides and claims formulae, in `only` where
// that is not empty; verdicts where `only` is.
std::vector<Aim> aims_of(const Kernel& kernel, const std::vector<Comparison>& only);

}  // namespace axiscert

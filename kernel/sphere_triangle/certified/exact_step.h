// The last step, which is always exact.
#pragma once

#include "kernel/sphere_triangle/certified/steps.h"

namespace axiscert::certified {

// Results of which an earlier step is certain, in groups of bits for the axes A, B, C, ABC, AB, BC, CA; each group
// begins at the bit of its name. fails: the axis does not separate. radius, sides: these comparisons of the axis hold;
// radius is only set for an axis that has a normal, because where A = B the open sphere's 0 >= 0 says nothing.
struct KnownResults {
  static constexpr int vertex_axis = 0, plane_axis = 3, edge_axis = 4, axes = 7;
  static constexpr int fails = 0, radius = 8, sides = 16;
  std::uint64_t bits = 0;

  // The comparisons that exist: the plane has no sides.
  static constexpr std::uint64_t comparisons = 0b1111111 << radius | 0b1110111 << sides;

  // Comparisons that are not known, on axes that may still separate; one bit per axis.
  std::uint32_t open_radii() const noexcept { return open(radius); }
  std::uint32_t open_sides() const noexcept { return open(sides); }
  bool is_separated() const noexcept { return ((bits >> radius) & (bits >> sides) & 0b1111111) != 0; }
  bool is_contact() const noexcept { return ((bits >> fails) & 0b1111111) == 0b1111111; }

  bool has(int group, int axis) const noexcept { return ((bits >> (group + axis)) & 1u) != 0; }

 private:
  std::uint32_t open(int group) const noexcept {
    return static_cast<std::uint32_t>(~((bits >> fails) | (bits >> group)) & (comparisons >> group) & 0b1111111);
  }
};

// The span in bits up to which numbers of a format are asked as integers: that of the widest integers, which is more
// than the 278 of binary32; of binary64 numbers that span more than 126 mostly have few digits, which are quicker.
template <class Real>
inline constexpr int widest_integers = sizeof(Real) == 4 ? 286 : 126;

// Whether the sphere is separated from the triangle, for the question asked. The query has to be valid: finite, r >= 0;
// binary32 is widened before. Evaluates the comparisons that are not known, in integers on the stack: of 1 to 27 words,
// in units of the least bit that is set in any of the thirteen numbers, if these span at most `widest` bits; otherwise
// by the digits that are not zero. Numbers that span more than 126 bits are asked as balls first. No rounding mode
// matters: an inexact floating-point operation does not give its number back, which is checked. Subnormal numbers must
// not be flushed. Uses about 4 KiB of stack, 29 KiB for numbers that span more than 126 bits.
bool exactly_separated(const double (&query)[13], Question question, KnownResults known,
                       int widest = widest_integers<double>) noexcept;
// The same with nothing known, by integers alone up to 286 bits, as for all of binary32; balls and digits beyond.
bool separated_by_integers(const double (&query)[13], Question question) noexcept;

}  // namespace axiscert::certified

// How far each comparison is from its inputs: its degree in the coordinates and the radius, and the bits that exact
// integer evaluation takes.
#pragma once

#include <array>
#include <optional>

#include "kernel/sphere_triangle/formulae_list.h"

namespace axiscert {

// Bits of an integer, sign apart, where the inputs are integers of b bits: per_bit * b + constant.
struct BitLength {
  int per_bit, constant;
  int at(int b) const { return per_bit * b + constant; }
  bool operator==(const BitLength&) const = default;
};

struct ComparisonDegree {
  // Homogeneous: all coordinates and the radius times s multiply the side by s^degree; a root halves, so that halves
  // occur. None: the side is the constant 0.
  std::optional<double> lhs, rhs;
  // A bound on both sides and all that they are made of, so that arithmetic of as many bits evaluates the comparison
  // without a rounding. None: the formulae divide or take a root on the way, and no number of bits is enough.
  std::optional<BitLength> bits;
};
using ComparisonDegrees = std::array<ComparisonDegree, comparison_count>;

// Of each comparison, the greatest over all branches that its evaluation can take; nothing for a method, which has no
// comparisons. Found by evaluating the formulae over a number type that carries these alone.
std::optional<ComparisonDegrees> degrees_of(Formulae formulae);

}  // namespace axiscert

// The complexity of each comparison in terms of its inputs: its degree in the coordinates and the radius, and the bits
// that exact integer evaluation needs.
#pragma once

#include <optional>

#include "kernel/formulae_list.h"
#include "kernel/sphere_triangle/names.h"

namespace axiscert {

// Bits of an integer without its sign, if the inputs are integers of b bits: per_bit * b + constant.
struct BitLength {
  int per_bit, constant;
  int at(int b) const { return per_bit * b + constant; }
  bool operator==(const BitLength&) const = default;
};

struct ComparisonDegree {
  // Degrees of homogeneity: if all coordinates and the radius are multiplied by s, the side is multiplied by s^degree;
  // a root halves, so that halves occur. Empty: the side is the constant 0.
  std::optional<double> lhs, rhs;
  // A bound on both sides and on all intermediate results, so that arithmetic of that many bits evaluates the
  // comparison without rounding. Empty: the formulae divide or take a root, and no number of bits is enough.
  std::optional<BitLength> bits;
};
using ComparisonDegrees = EnumArray<Comparison, ComparisonDegree>;

// For each comparison, the greatest degrees and bits over all branches that its evaluation can take; empty for a
// method, which has no comparisons. Found by evaluating the formulae over a number type that carries only these.
std::optional<ComparisonDegrees> degrees_of(Formulae formulae);

}  // namespace axiscert

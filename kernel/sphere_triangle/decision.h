// The sides that sphere-triangle's formulae compare, and the decision that follows from their bits.
#pragma once

#include "kernel/outcome.h"
#include "kernel/sphere_triangle/names.h"

namespace axiscert {

// The two sides of every comparison `lhs > rhs`.
template <class T>
struct Sides {
  EnumArray<Comparison, T> lhs, rhs;
};

inline Outcome outcome_of(ComparisonBits bits) { return {verdict_of(axes_of(bits)), bits}; }

}  // namespace axiscert

// The decision on one query: a verdict, the comparison bits that it follows from, the sides that these compare.
#pragma once

#include <array>
#include <optional>

#include "kernel/names.h"

namespace axiscert {

// The two sides of every comparison `lhs > rhs`.
template <class T>
struct Sides {
  std::array<T, comparison_count> lhs, rhs;
};

// The decision of a set of formulae on one query; no bits from a method that has only a verdict.
struct Outcome {
  Verdict verdict;
  std::optional<ComparisonBits> bits;
  bool operator==(const Outcome&) const = default;
};
inline Outcome outcome_of(ComparisonBits bits) { return {verdict_of(axes_of(bits)), bits}; }

}  // namespace axiscert

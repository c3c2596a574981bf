// The decision on one query: a verdict, and the comparison bits that it follows from.
#pragma once

#include <optional>

#include "kernel/names.h"

namespace axiscert {

// The decision of a set of formulae on one query; no bits from a method that has only a verdict.
struct Outcome {
  Verdict verdict;
  std::optional<ComparisonBits> bits;
  bool operator==(const Outcome&) const = default;
};

}  // namespace axiscert

// The sides of formulae in exact arithmetic.
#pragma once

#include <vector>

#include "exact/numbers/binary_fraction.h"
#include "kernel/base/enums.h"
#include "kernel/names.h"

namespace axiscert {

// The sides of one comparison, `lhs > rhs` or `lhs >= rhs`. If it is rooted, the left side is the root of lhs.over,
// over lhs.under, which is rhs.under; only a left side can be a root. If it is undefined, as by 0/0, it has no sides.
// If the right side is a root, both are stored times that root: their order and their ratio are right, their sizes not.
struct ExactComparison {
  const BinaryFraction &lhs, &rhs;
  bool is_rooted = false, is_undefined = false, is_times_root = false;
};

struct ExactSides {
  std::vector<BinaryFraction> lhs, rhs;      // by comparison
  ComparisonBits strict = 0, ties = 0;       // lhs > rhs; lhs == rhs
  ComparisonBits rooted = 0, undefined = 0;  // an undefined comparison holds with no relation, and is no tie
  ComparisonBits times_root = 0;

  explicit ExactSides(std::size_t comparisons) : lhs(comparisons), rhs(comparisons) {}
  // Sides without a root, of a number type of which a BinaryFraction can be made.
  template <class Number>
  void set(std::size_t i, const Number& left, const Number& right) {
    const int which = order(left, right);
    strict |= bit_if<ComparisonBits>(which > 0, i);
    ties |= bit_if<ComparisonBits>(which == 0, i);
    lhs[i] = BinaryFraction(left);
    rhs[i] = BinaryFraction(right);
  }

  // The comparisons that hold, of which `nonstrict` are lhs >= rhs.
  ComparisonBits holding(ComparisonBits nonstrict) const { return strict | (ties & nonstrict); }
  ExactComparison comparison(std::size_t i) const {
    return {lhs[i], rhs[i], has_bit(rooted, i), has_bit(undefined, i), has_bit(times_root, i)};
  }
};

}  // namespace axiscert

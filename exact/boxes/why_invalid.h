// The reasons for which numbers are not boxes, each with the place in a line of JSON, the value and the rule.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "exact/boxes/scaled.h"
#include "exact/trait/dyadic_number.h"
#include "kernel/predicate.h"

namespace axiscert::boxes {

// "a.s, element 2": the place of a column in a line of JSON.
inline std::string place_of(const PredicateEntry& entry, std::size_t column) {
  for (const ColumnGroup& group : groups_of(entry)) {
    if (column < group.first || column >= group.first + group.size) continue;
    return group.size == 1 ? std::string(group.name)
                           : fmt::format("{}, element {},", group.name, column - group.first + 1);
  }
  return std::string(entry.columns[column].name);
}

// The first number that is not finite or a negative half extent; empty where there is none.
inline std::string why_numbers_are_invalid(const PredicateEntry& entry, const Numbers<double>& numbers) {
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    if (!std::isfinite(numbers[k])) {
      return fmt::format("{} is {}; every number is finite", place_of(entry, k), numbers[k]);
    }
    if (entry.columns[k].role == Role::length && numbers[k] < 0) {
      return fmt::format("{} is {}; half extents are 0 or more", place_of(entry, k), numbers[k]);
    }
  }
  return "";
}

// The reason for the axes of a box, whose member this is, by their determinant; empty where they are independent.
inline std::string why_axes_are_invalid(std::string_view member, const OrientedBox<double>& box) {
  if (determinant(scaled<DyadicNumber>(box)).value.sign() != CGAL::ZERO) return "";
  return fmt::format("{}.b has the determinant 0; the axes of a box are linearly independent", member);
}

}  // namespace axiscert::boxes

// The truth about boxes by the nearest points, and the reasons for which numbers are not boxes, each with the place in
// a line of JSON, the value and the rule.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "exact/boxes/clipping.h"
#include "exact/boxes/nearest.h"
#include "exact/boxes/scaled.h"
#include "exact/judge/judge.h"
#include "kernel/base/enums.h"
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

inline std::string why_quaternion_is_invalid(std::string_view member, const TurnedBox<double>& box) {
  const bool is_zero = std::all_of(box.q.begin(), box.q.end(), [](double x) { return x == 0; });
  return is_zero ? fmt::format("{}.q is 0, 0, 0, 0; a quaternion has an element other than 0", member) : "";
}

// Each axis on which min is above max.
inline std::string why_corners_are_invalid(std::string_view member, const CornersBox<double>& box) {
  const std::array<double, 3> low = {box.low.x, box.low.y, box.low.z}, high = {box.high.x, box.high.y, box.high.z};
  std::vector<std::string> faults;
  for (std::size_t i = 0; i < 3; ++i) {
    if (low[i] > high[i])
      faults.push_back(fmt::format("{}.min on {} is {}, above {}", member, "xyz"[i], low[i], high[i]));
  }
  if (faults.empty()) return "";
  return fmt::format("{} in {}.max; on each axis min is at most max", fmt::join(faults, "; "), member);
}

// The truth by the nearest points with what the clipped edges say beside it, and the theorem that ties both to the
// axes.

struct ClippedTruth : Truth {
  Common common;
};

inline ClippedTruth clipped_truth(const NearestPoints& nearest, const Common& common) {
  if (!nearest.in_contact()) return {{Verdict::separated, false}, common};
  return {{Verdict::contact, !common.interiors_meet}, common};
}

// Empty where the three agree: boxes touch exactly where none of the axes separates and on one that is not 0 both sides
// are equal. `bodies()` are those of the query, whose axes have directions.
template <class Bodies>
std::string contradiction_of(std::string_view axes, const ClippedTruth& truth, Verdict by_axes, ComparisonBits holds,
                             ComparisonBits ties, Bodies&& bodies) {
  const Verdict by_clipping = truth.common.meets ? Verdict::contact : Verdict::separated;
  bool axes_touch = false;
  if (by_axes == Verdict::contact && ties != 0) {
    const auto q = bodies();
    for_each_bit(ties, [&](std::size_t i) {
      const auto along = direction(q, i);
      axes_touch = axes_touch || dot(along, along).value.sign() != CGAL::ZERO;
    });
  }
  if (truth.verdict == by_clipping && truth.verdict == by_axes && truth.touching == axes_touch) return "";
  return fmt::format(
      "nearest points {}; edges clipped {}, interiors have a point in common {}; the {} axes {}, touching {}: "
      "{:#b}, ties {:#b} (bit 0 is the first axis)",
      name(truth.verdict), name(by_clipping), truth.common.interiors_meet, axes, name(by_axes), axes_touch, holds,
      ties);
}

}  // namespace axiscert::boxes

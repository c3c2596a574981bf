// The truth by the nearest points with what the clipped edges say beside it, and the theorem that ties both to the
// axes.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

#include "exact/boxes/clipping.h"
#include "exact/boxes/nearest.h"
#include "exact/judge/truth.h"
#include "kernel/base/bits.h"

namespace axiscert::boxes {

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

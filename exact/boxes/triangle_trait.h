// The traits of the test of a box and a triangle, one for each entry: the truth by the nearest points, compared on
// every query with the edges clipped and, by the theorem, with the thirteen axes.
#pragma once

#include <fmt/format.h>

#include <cmath>

#include "exact/boxes/clipping.h"
#include "exact/trait/oracles.h"
#include "exact/trait/trait.h"

namespace axiscert::boxes {

inline std::string no_box(const CentredAndTriangle<double>&) { return ""; }
inline std::string no_box(const CornersAndTriangle<double>& q) {
  const auto below = [](double low, double high, char axis) {
    return low > high ? fmt::format("box.l{} is above box.h{}", axis, axis) : std::string();
  };
  return below(q.low.x, q.high.x, 'x') + below(q.low.y, q.high.y, 'y') + below(q.low.z, q.high.z, 'z');
}
inline std::string no_box(const BoxAndTriangle<double>& q) {
  return determinant(exact_box_and_triangle(q).box) == 0
             ? "box: its three basis vectors are linearly dependent, so that their determinant is 0"
             : "";
}

template <class Entry>
struct TriangleTrait : Entry {
  static auto query(const Numbers<double>& numbers) {
    return Entry::template problem<double>([&](std::size_t k) { return numbers[k]; });
  }
  static ExactBoxAndTriangle exactly(const Numbers<double>& numbers) { return exact_box_and_triangle(query(numbers)); }

  static std::string why_invalid(const Numbers<double>& numbers) {
    const auto& columns = Entry::description().entries[Entry::entry].columns;
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      if (!std::isfinite(numbers[k])) return fmt::format("{} is not finite", columns[k].name);
      if (columns[k].role == Role::length && numbers[k] < 0) {
        return fmt::format("half extent {} is negative", columns[k].name);
      }
    }
    return no_box(query(numbers));
  }
  static bool is_valid(const Numbers<double>& numbers) { return why_invalid(numbers).empty(); }

  static Truth geometric_truth(const Numbers<double>& numbers) {
    const ExactBoxAndTriangle q = exactly(numbers);
    if (squared_distance(q) > 0) return {Verdict::separated, false};
    return {Verdict::contact, !common_of(q).interiors_meet};
  }

  // The theorem, as that of two boxes (exact/boxes/trait.h), of thirteen axes.
  static std::string contradiction(const Numbers<double>& numbers, const Truth& truth, ComparisonBits holds,
                                   ComparisonBits ties) {
    const ExactBoxAndTriangle q = exactly(numbers);
    const Common common = common_of(q);
    const Verdict by_clipping = common.meets ? Verdict::contact : Verdict::separated;
    const Verdict by_axes = verdict_of(box_triangle_test(), holds);
    bool ties_somewhere = false;
    for_each_bit(ties, [&](std::size_t i) {
      const Point along = direction(q, i);
      ties_somewhere = ties_somewhere || dot(along, along) != 0;
    });
    const bool axes_touch = by_axes == Verdict::contact && ties_somewhere;
    if (truth.verdict == by_clipping && truth.verdict == by_axes && truth.touching == axes_touch) return "";
    return fmt::format(
        "nearest points {}; edges clipped {}, interiors have a point in common {}; the thirteen axes {}, touching {}: "
        "{:#b}, ties {:#b} (bit 0 is the first axis)",
        name(truth.verdict), name(by_clipping), common.interiors_meet, name(by_axes), axes_touch, holds, ties);
  }

  static double depth(const Numbers<double>& numbers) { return depth_of(exactly(numbers)); }

  template <class Real>
  static std::vector<Detail> details(const Numbers<double>& numbers) {
    const ExactBoxAndTriangle q = exactly(numbers);
    Detail penetration{"penetration", {}}, distance{"distance", {}};
    const Rational apart = squared_distance(q);
    if (apart > 0) distance.value = static_cast<double>(nearest_sqrt<Real>(apart));
    else penetration.value = static_cast<double>(nearest_sqrt<Real>(squared_penetration(q)));
    return {penetration, distance, {"deciding_axes", deciding_axes(q)}};
  }
};

struct CentreTrait : TriangleTrait<CentreEntry> {
  using AllFormulae = FormulaeList<Thirteen, TextbookThirteen>;
};
struct MinmaxTrait : TriangleTrait<MinmaxEntry> {
  using AllFormulae = FormulaeList<Thirteen, TextbookThirteen>;
};
struct OrientedTrait : TriangleTrait<OrientedEntry> {
  using AllFormulae = FormulaeList<Thirteen, FramedThirteen>;
};

}  // namespace axiscert::boxes

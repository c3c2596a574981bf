// The traits of the test of two boxes, one for each entry: the truth by the nearest points, compared on every query
// with the edges clipped and, by the theorem, with the fifteen axes.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "exact/boxes/box_measures.h"
#include "exact/boxes/clipping.h"
#include "exact/trait/oracles.h"
#include "exact/trait/trait.h"
#include "kernel/boxes/epsilon.h"
#include "kernel/boxes/projected.h"

namespace axiscert::boxes {

// Facts that both entries share, of a query as two exact boxes.
struct BoxTruth {
  // Touching is taken from the clipped edges: nearest points do not tell it.
  static Truth of(const ExactPair& q) {
    if (squared_distance(q) > 0) return {Verdict::separated, false};
    return {Verdict::contact, !common_of(q).interiors_meet};
  }

  // The theorem. With the products of the boxes' own vectors as directions, one of the fifteen axes separates exactly
  // where the boxes have no point in common; they touch exactly where none separates and on one that is not 0 both
  // sides are equal.
  static std::string contradiction(const ExactPair& q, const Truth& truth, ComparisonBits holds, ComparisonBits ties) {
    const Common common = common_of(q);
    const Verdict by_clipping = common.meets ? Verdict::contact : Verdict::separated;
    const Verdict by_axes = verdict_of(box_box_test(), holds);
    bool ties_somewhere = false;
    for_each_bit(ties, [&](std::size_t i) {
      const Point along = direction(q, i);
      ties_somewhere = ties_somewhere || dot(along, along) != 0;
    });
    const bool axes_touch = by_axes == Verdict::contact && ties_somewhere;
    if (truth.verdict == by_clipping && truth.verdict == by_axes && truth.touching == axes_touch) return "";
    return fmt::format(
        "nearest points {}; edges clipped {}, interiors have a point in common {}; the fifteen axes {}, touching {}: "
        "{:#b}, ties {:#b} (bit 0 is the first axis)",
        name(truth.verdict), name(by_clipping), common.interiors_meet, name(by_axes), axes_touch, holds, ties);
  }

  static bool is_valid(const ExactPair& q) {
    for (const ExactBox* box : {&q.a, &q.b}) {
      if (determinant(*box) == 0) return false;
      if (std::any_of(box->half.begin(), box->half.end(), [](const Rational& s) { return s < 0; })) return false;
    }
    return true;
  }
  static bool is_finite(const Numbers<double>& numbers) {
    return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
  }
};

struct MatrixTrait : MatrixBoxes {
  using AllFormulae = FormulaeList<Projected, Columns, Dropped, Framed, Textbook, Rtcd, Gottschalk, Bullet, Cofactor>;

  static ExactPair exactly(const Numbers<double>& numbers) {
    return exact_pair(problem<double>([&](std::size_t k) { return numbers[k]; }));
  }
  static bool is_valid(const Numbers<double>& numbers) {
    return BoxTruth::is_finite(numbers) && BoxTruth::is_valid(exactly(numbers));
  }
  static Truth geometric_truth(const Numbers<double>& numbers) { return BoxTruth::of(exactly(numbers)); }
  static std::string contradiction(const Numbers<double>& numbers, const Truth& truth, ComparisonBits holds,
                                   ComparisonBits ties) {
    return BoxTruth::contradiction(exactly(numbers), truth, holds, ties);
  }
  static double depth(const Numbers<double>& numbers) { return depth_of(exactly(numbers)); }
};

struct QuaternionTrait : QuaternionBoxes {
  using AllFormulae =
      FormulaeList<OfQuaternions<Projected>, OfQuaternions<Columns>, OfQuaternions<Dropped>, OfQuaternions<Framed>,
                   OfQuaternions<Textbook>, OfQuaternions<Rtcd>, OfQuaternions<Gottschalk>, OfQuaternions<Bullet>,
                   OfQuaternions<Cofactor>, Homogeneous>;

  static TurnedPair<double> query(const Numbers<double>& numbers) {
    return problem<double>([&](std::size_t k) { return numbers[k]; });
  }
  static ExactPair exactly(const Numbers<double>& numbers) { return exact_pair(query(numbers)); }
  static bool is_valid(const Numbers<double>& numbers) {
    if (!BoxTruth::is_finite(numbers)) return false;
    const TurnedPair<double> q = query(numbers);
    for (const TurnedBox<double>* box : {&q.a, &q.b}) {
      if (std::all_of(box->q.begin(), box->q.end(), [](double x) { return x == 0; })) return false;
      if (std::any_of(box->half.begin(), box->half.end(), [](double s) { return s < 0; })) return false;
    }
    return true;
  }
  static Truth geometric_truth(const Numbers<double>& numbers) { return BoxTruth::of(exactly(numbers)); }
  static std::string contradiction(const Numbers<double>& numbers, const Truth& truth, ComparisonBits holds,
                                   ComparisonBits ties) {
    return BoxTruth::contradiction(exactly(numbers), truth, holds, ties);
  }
  static double depth(const Numbers<double>& numbers) { return depth_of(exactly(numbers)); }
};

}  // namespace axiscert::boxes

// The truth by the nearest point of the box, in place of its faces.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "exact/judge/oracles_of.h"
#include "fuzz/testing/point_box/point_box.h"

namespace axiscert {
namespace {

struct PointBoxTrait : PointBox {
  using AllFormulae = FormulaeList<PointBoxFaces>;

  static bool is_valid(const Numbers<double>& q) {
    const bool finite = std::all_of(q.begin(), q.end(), [](double x) { return std::isfinite(x); });
    return finite && q[3] <= q[6] && q[4] <= q[7] && q[5] <= q[8];
  }

  // The squares of the distance to the box; of that to its surface, for a point in it; and of the diagonal of both.
  struct Squares {
    Rational outside, to_surface, scene;
  };
  static Squares squares(const Numbers<double>& q) {
    Squares all;
    std::array<Rational, 3> inside;
    for (std::size_t k = 0; k < 3; ++k) {
      const Rational p(q[k]), low(q[3 + k]), high(q[6 + k]);
      const Rational nearest = std::clamp(p, low, high), step = p - nearest;
      all.outside += step * step;
      inside[k] = std::min(Rational(nearest - low), Rational(high - nearest));
      const Rational extent = std::max(p, high) - std::min(p, low);
      all.scene += extent * extent;
    }
    const Rational least = *std::min_element(inside.begin(), inside.end());
    all.to_surface = least * least;
    return all;
  }

  static Truth geometric_truth(const Numbers<double>& q) {
    const Squares found = squares(q);
    if (found.outside != 0) return {Verdict::separated, false};
    return {Verdict::contact, found.to_surface == 0};
  }

  static std::string contradiction(const Numbers<double>&, const Truth& truth, ComparisonBits holds,
                                   ComparisonBits ties) {
    const bool separated = truth.verdict == Verdict::separated, touching = holds == 0 && ties != 0;
    if (separated == (holds != 0) && truth.touching == touching) return "";
    return fmt::format("the nearest point says {}, touching {}; the faces {:#b}, ties {:#b}", name(truth.verdict),
                       truth.touching, holds, ties);
  }

  static ExactDepth exact_depth(const Numbers<double>& q) {
    const Squares found = squares(q);
    if (found.scene == 0) return {0, 0, 1};
    return {found.outside != 0 ? found.outside : found.to_surface, 0, found.scene};
  }
};

}  // namespace

template class OraclesOf<PointBoxTrait>;

const Oracles& point_box_oracles(std::size_t) {
  static const OraclesOf<PointBoxTrait> oracles;
  return oracles;
}

}  // namespace axiscert

#include "exact/sphere_triangle/oracles/exact_truth.h"

#include <fmt/format.h>

#include "exact/sphere_triangle/oracles/area.h"
#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "exact/sphere_triangle/oracles/second_oracle.h"
#include "kernel/sphere_triangle/description.h"

namespace axiscert {
namespace {

template <class Real>
bool has_zero_area(const Query<Real>& q) {
  const Vec3<BinaryNumber> normal = exact_normal(q);
  return normal.x.is_zero() && normal.y.is_zero() && normal.z.is_zero();
}

Verdict separated_if(bool separated) { return separated ? Verdict::separated : Verdict::contact; }

// A description of the first contradiction; empty if there is none. `opinion` is MPFR's, if it was asked.
template <class Real>
std::optional<std::string> contradiction(const Query<Real>& q, int geometric_order, const ExactSides& sides,
                                         const std::optional<SecondOpinion>& opinion) {
  const Verdict geometric = separated_if(geometric_order > 0);
  const Verdict nonstrict = verdict_of(axes_of(sides.holding(side_comparisons)));
  const Verdict strict = verdict_of(axes_of(sides.strict));
  if (nonstrict != geometric) {
    return fmt::format("CGAL says {}, the exact formulae with non-strict sides say {}", name(geometric),
                       name(nonstrict));
  }
  if (strict != geometric && (strict == Verdict::separated || !has_zero_area(q))) {
    return fmt::format(
        "CGAL says {}, the exact strict formulae say {} on a triangle where the theorem allows no such "
        "difference",
        name(geometric), name(strict));
  }
  if (opinion && opinion->distance_order != geometric_order) {
    return fmt::format("distance against radius: CGAL orders them {}, MPFR {}", geometric_order,
                       opinion->distance_order);
  }
  if (opinion && (opinion->strict != sides.strict || opinion->ties != sides.ties)) {
    return fmt::format(
        "the sixteen signs: ring {:016b} ties {:016b}, MPFR {:016b} ties {:016b} (bit 0 is the first "
        "comparison)",
        sides.strict, sides.ties, opinion->strict, opinion->ties);
  }
  return std::nullopt;
}

}  // namespace

template <class Real>
ExactTruth exact_truth(const Query<Real>& q, bool with_second_opinion) {
  if (!is_valid(q)) return {{Verdict::invalid, false}, std::nullopt};
  const int geometric_order = distance_order(q);
  ExactSides sides = exact_sides(q);
  std::optional<SecondOpinion> opinion;
  if (with_second_opinion) opinion = second_opinion(q);
  if (auto wrong = contradiction(q, geometric_order, sides, opinion)) {
    const SecondOpinion mpfr = second_opinion(q);
    throw OracleDisagreement(
        fmt::format("{}; MPFR's own verdict is {}", *wrong, name(separated_if(mpfr.distance_order > 0))),
        Numbers<Real>(q), sphere_triangle_predicate());
  }
  return {{separated_if(geometric_order > 0), geometric_order == 0}, std::move(sides)};
}
template ExactTruth exact_truth<float>(const Query<float>&, bool);
template ExactTruth exact_truth<double>(const Query<double>&, bool);

}  // namespace axiscert

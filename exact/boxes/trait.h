// The traits of the predicate of two boxes, one for each entry: the truth by the nearest points, compared on every
// query with the edges clipped and, by the theorem, with the fifteen axes.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <memory>

#include "exact/boxes/contact_judge.h"
#include "exact/boxes/measures.h"
#include "exact/boxes/truth.h"
#include "exact/judge/oracles.h"
#include "exact/judge/trait.h"
#include "kernel/boxes/textbook.h"
#include "kernel/boxes/projected.h"
#include "kernel/boxes/slips.h"

namespace axiscert::boxes {

// `name` is the box's member: the reason for which its axes, its quaternion or its corners do not make a box, or empty.
inline std::string why_invalid_box(std::string_view name, const OrientedBox<double>& box) {
  return why_axes_are_invalid(name, box);
}
inline std::string why_invalid_box(std::string_view name, const TurnedBox<double>& box) {
  return why_quaternion_is_invalid(name, box);
}
inline std::string why_invalid_box(std::string_view name, const CornersBox<double>& box) {
  return why_corners_are_invalid(name, box);
}

// All entries share this trait; `Boxes` is MatrixBoxes, QuaternionBoxes, MinmaxBoxes or MixedBoxes.
template <class Boxes>
struct BoxTrait : Boxes {
  static auto query(const Numbers<double>& numbers) {
    return Boxes::template problem<double>([&](std::size_t k) { return numbers[k]; });
  }
  static ExactPair exactly(const Numbers<double>& numbers) { return exact_pair(query(numbers)); }

  static std::string why_invalid(const Numbers<double>& numbers) {
    const PredicateEntry& entry = Boxes::description().entries[Boxes::entry];
    if (std::string why = why_numbers_are_invalid(entry, numbers); !why.empty()) return why;
    const auto q = query(numbers);
    if (std::string why = why_invalid_box("a", q.a); !why.empty()) return why;
    return why_invalid_box("b", q.b);
  }
  static bool is_valid(const Numbers<double>& numbers) { return why_invalid(numbers).empty(); }

  // Touching is taken from the clipped edges: nearest points do not tell it.
  static ClippedTruth geometric_truth(const Numbers<double>& numbers) {
    const BoxPair<BinaryNumber> q = scaled<BinaryNumber>(query(numbers));
    return clipped_truth(nearest_points(corners_of(q.a), corners_of(q.b)),
                         common_of(scaled<DyadicNumber>(query(numbers))));
  }

  // The theorem. With the products of the boxes' own vectors as directions, one of the fifteen axes separates exactly
  // where the boxes have no point in common; they touch exactly where none separates and on one that is not 0 both
  // sides are equal.
  static std::string contradiction(const Numbers<double>& numbers, const ClippedTruth& truth, ComparisonBits holds,
                                   ComparisonBits ties) {
    return contradiction_of("fifteen", truth, verdict_of(box_box_predicate(), holds), holds, ties,
                            [&] { return scaled<DyadicNumber>(query(numbers)); });
  }

  static ExactDepth exact_depth(const Numbers<double>& numbers) { return boxes::exact_depth(exactly(numbers)); }
  static Distance distance(const Numbers<double>& numbers) { return {squared_distance(exactly(numbers)), 0}; }
  template <class Real>
  static std::unique_ptr<ContactJudge> contact_judge(const Numbers<double>& numbers) {
    return std::make_unique<BodyContactJudge<Real>>([numbers] { return ExactContact(exactly(numbers)); });
  }

  // That of the half extent of A's first axis at which the boxes touch, in an entry that has it.
  static std::optional<Rational> squared_critical_length(const Numbers<double>& numbers)
    requires(Boxes::entry == MatrixBoxes::entry || Boxes::entry == QuaternionBoxes::entry)
  {
    Numbers<double> any = numbers;
    any[3] = 0;  // the extent that is not read
    if (!is_valid(any)) return std::nullopt;
    const std::optional<Rational> extent = critical_extent(exactly(any));
    if (!extent) return std::nullopt;
    return Rational(*extent * *extent);
  }

  // The penetration or the distance, as a length rounded to nearest; the axes that decide: those on which the
  // penetration is least, or those that separate; and of matrices how far they are from orthonormal, the worse of both,
  // in halves of an ulp of 1.
  template <class Real>
  static std::vector<Detail> details(const Numbers<double>& numbers) {
    const ExactPair q = exactly(numbers);
    Detail penetration{"penetration", {}}, distance{"distance", {}};
    const Rational apart = squared_distance(q);
    if (apart > 0) distance.value = static_cast<double>(nearest_sqrt<Real>(apart));
    else penetration.value = static_cast<double>(nearest_sqrt<Real>(squared_penetration(q)));
    std::vector<Detail> found = {penetration, distance, {"deciding_axes", deciding_axes(q)}};
    if constexpr (Boxes::entry == MatrixBoxes::entry) {
      const Rational defect = std::max(orthonormality_defect(q.a), orthonormality_defect(q.b));
      found.push_back(
          {"defect", nearest<double>(Rational(defect * (mpz_class(1) << std::numeric_limits<Real>::digits)))});
    }
    return found;
  }
  static std::vector<std::string_view> detail_names() {
    std::vector<std::string_view> names = {"penetration", "distance", "deciding_axes"};
    if constexpr (Boxes::entry == MatrixBoxes::entry) names.emplace_back("defect");
    return names;
  }
};

struct MatrixTrait : BoxTrait<MatrixBoxes> {
  using ClearForms = FormulaeList<ProjectedFifteen, Textbook>;  // the second takes the axes to be orthonormal
  using AllFormulae = FormulaeList<ProjectedFifteen, Columns, DroppedFifteen, FramedFifteen, Textbook, Rtcd, Gottschalk,
                                   Bullet, Cofactor, SlipOfTheBook, SlipOfTheFrame, SlipOfEpsilon, SlipOfOneInterval,
                                   SlipOfOwnEdges, SlipOfOneEdge>;
};

struct QuaternionTrait : BoxTrait<QuaternionBoxes> {
  using ClearForms = FormulaeList<ByMatrices<ProjectedFifteen>>;
  using Exact = BinaryFraction;  // the matrix of a quaternion is divided by its squared length
  using AllFormulae = FormulaeList<ByMatrices<ProjectedFifteen>, ByMatrices<Columns>, ByMatrices<DroppedFifteen>,
                                   ByMatrices<FramedFifteen>, ByMatrices<Textbook>, ByMatrices<Rtcd>,
                                   ByMatrices<Gottschalk>, ByMatrices<Bullet>, ByMatrices<Cofactor>, Homogeneous>;
};

struct MinmaxPairTrait : BoxTrait<MinmaxBoxes> {
  using ClearForms = FormulaeList<ByMatrices<ProjectedFifteen>>;
  using AllFormulae = FormulaeList<ByMatrices<ProjectedFifteen>, ByMatrices<Textbook>, ByMatrices<Cofactor>, Intervals>;
};

struct MixedTrait : BoxTrait<MixedBoxes> {
  using ClearForms = FormulaeList<ByMatrices<ProjectedFifteen>>;
  using Exact = BinaryFraction;  // the matrix of a quaternion is divided by its squared length
  using AllFormulae = FormulaeList<ByMatrices<ProjectedFifteen>, ByMatrices<Textbook>, ByMatrices<Cofactor>>;
};

}  // namespace axiscert::boxes

// The traits of the predicate of a box and a triangle, one for each entry: the truth by the nearest points, compared on
// every query with the edges clipped and, by the theorem, with the thirteen axes.
#pragma once

#include <fmt/format.h>

#include <array>
#include <memory>

#include "exact/boxes/contact_judge.h"
#include "exact/boxes/truth.h"
#include "exact/boxes/measures.h"
#include "exact/judge/oracles.h"
#include "exact/judge/trait.h"
#include "kernel/boxes/akenine_moller.h"

namespace axiscert::boxes {

// The reason for which finite numbers with half extents of 0 or more do not make a box, or empty.
inline std::string why_invalid_box(const CentredAndTriangle<double>&) { return ""; }
inline std::string why_invalid_box(const CornersAndTriangle<double>& q) {
  return why_corners_are_invalid("box", {q.low, q.high});
}
inline std::string why_invalid_box(const TurnedAndTriangle<double>& q) {
  return why_quaternion_is_invalid("box", q.box);
}
inline std::string why_invalid_box(const BoxAndTriangle<double>& q) { return why_axes_are_invalid("box", q.box); }

template <class Entry>
struct TriangleTrait : Entry {
  static auto query(const Numbers<double>& numbers) {
    return Entry::template problem<double>([&](std::size_t k) { return numbers[k]; });
  }
  static ExactBoxAndTriangle exactly(const Numbers<double>& numbers) { return exact_box_and_triangle(query(numbers)); }

  static std::string why_invalid(const Numbers<double>& numbers) {
    const PredicateEntry& entry = Entry::description().entries[Entry::entry];
    if (std::string why = why_numbers_are_invalid(entry, numbers); !why.empty()) return why;
    return why_invalid_box(query(numbers));
  }
  static bool is_valid(const Numbers<double>& numbers) { return why_invalid(numbers).empty(); }

  static ClippedTruth geometric_truth(const Numbers<double>& numbers) {
    const BoxAndTriangle<BinaryNumber> q = scaled<BinaryNumber>(query(numbers));
    return clipped_truth(nearest_points(corners_of(q.box), {q.corner.begin(), q.corner.end()}),
                         common_of(scaled<DyadicNumber>(query(numbers))));
  }

  // The theorem, as that of two boxes (exact/boxes/trait.h), of thirteen axes.
  static std::string contradiction(const Numbers<double>& numbers, const ClippedTruth& truth, ComparisonBits holds,
                                   ComparisonBits ties) {
    return contradiction_of("thirteen", truth, verdict_of(box_triangle_predicate(), holds), holds, ties,
                            [&] { return scaled<DyadicNumber>(query(numbers)); });
  }

  static ExactDepth exact_depth(const Numbers<double>& numbers) { return boxes::exact_depth(exactly(numbers)); }
  static Distance distance(const Numbers<double>& numbers) { return {squared_distance(exactly(numbers)), 0}; }
  template <class Real>
  static std::unique_ptr<ContactJudge> contact_judge(const Numbers<double>& numbers) {
    return std::make_unique<BodyContactJudge<Real>>([numbers] { return ExactContact(exactly(numbers)); });
  }
  static bool is_in_front(const Numbers<double>& numbers) {
    const ExactBoxAndTriangle q = exactly(numbers);
    const auto& [a, b, c] = q.corner;
    return sgn(Rational(dot(q.box.centre - a, cross(b - a, c - a)))) > 0;
  }

  template <class Real>
  static std::vector<Detail> details(const Numbers<double>& numbers) {
    const ExactBoxAndTriangle q = exactly(numbers);
    Detail penetration{"penetration", {}}, distance{"distance", {}};
    const Rational apart = squared_distance(q);
    if (apart > 0) distance.value = static_cast<double>(nearest_sqrt<Real>(apart));
    else penetration.value = static_cast<double>(nearest_sqrt<Real>(squared_penetration(q)));
    return {penetration, distance, {"deciding_axes", deciding_axes(q)}};
  }
  static std::vector<std::string_view> detail_names() { return {"penetration", "distance", "deciding_axes"}; }
};

struct CentreTrait : TriangleTrait<CentreEntry> {
  using AllFormulae = FormulaeList<Thirteen, TextbookThirteen, AkenineMoller>;
};
struct MinmaxTrait : TriangleTrait<MinmaxEntry> {
  using AllFormulae = FormulaeList<Thirteen, TextbookThirteen, AkenineMoller>;
};
struct OrientedTrait : TriangleTrait<OrientedEntry> {
  using AllFormulae = FormulaeList<Thirteen, FramedThirteen>;
};
struct TurnedTriangleTrait : TriangleTrait<TurnedEntry> {
  using Exact = BinaryFraction;  // the matrix of a quaternion is divided by its squared length
  using AllFormulae = FormulaeList<Thirteen, TurnedThirteen>;
};

}  // namespace axiscert::boxes

#include "exact/sphere_triangle/claims/asked_sphere_triangle.h"

#include "exact/sphere_triangle/measures/depth.h"
#include "exact/sphere_triangle/measures/error_measure.h"

namespace axiscert {
namespace {

ExactSides rational_sides(const FormulaTruth& truth, Strictness strictness) {
  ExactSides sides{{}, {}, truth.bits(strictness), truth.ties};
  for (std::size_t i = 0; i < comparison_count; ++i) {
    const ExactComparison comparison = truth.comparison(i);
    const Rational denominator = rational(comparison.denominator);
    sides.lhs.emplace_back(Rational(rational(comparison.lhs) / denominator));
    sides.rhs.emplace_back(Rational(rational(comparison.rhs) / denominator));
  }
  return sides;
}

// (lhs - rhs) / (|lhs| + |rhs|), or with the signed squares of the sides; 0/0 and undefined values give 0.
Rational relative_margin(const ExactComparison& sides) {
  if (sides.undefined) return 0;
  const Rational lhs = rational(sides.lhs);
  Rational rhs = rational(sides.rhs);
  if (sides.rooted) rhs = rhs * abs(rhs);
  const Rational scale = abs(lhs) + abs(rhs);
  return sgn(scale) == 0 ? Rational(0) : Rational((lhs - rhs) / scale);
}

}  // namespace

template <class Real>
const ExactTruth& AskedSphereTriangle<Real>::exact() {
  if (truth_) return *truth_;
  truth_ = exact_truth(query_, opinion_ != Opinion::first);
  found(*truth_);
  if (truth_->touching) distance_.set_touching();
  return *truth_;
}

template <class Real>
Claims<Real>& AskedSphereTriangle<Real>::claims() {
  if (!claims_) claims_.emplace(query_, *exact().formula, opinion_ == Opinion::exact_only);
  return *claims_;
}

template <class Real>
std::optional<Reference> AskedSphereTriangle<Real>::chain(const Kernel& kernel) {
  return claims().chain(kernel);
}

// None where a side is a root or does not exist.
template <class Real>
const ExactSides* AskedSphereTriangle<Real>::sides(const Kernel& kernel) {
  const FormulaTruth* own = claims().sides(kernel.formulae);
  if (own == nullptr || own->rooted != 0 || own->undefined != 0) return nullptr;
  const ComparisonBits holds = own->bits(kernel.strictness);
  for (const auto& [truth, sides] : sides_) {
    if (truth == own && sides.holds == holds) return &sides;
  }
  return &sides_.emplace_front(own, rational_sides(*own, kernel.strictness)).second;
}

template <class Real>
std::optional<ExactSigns> AskedSphereTriangle<Real>::published_signs() {
  const FormulaTruth& formula = *exact().formula;
  return ExactSigns{formula.strict, formula.ties};
}

template <class Real>
std::optional<ExactDepth> AskedSphereTriangle<Real>::exact_depth() {
  return axiscert::exact_depth(query_, distance_.squared());
}

template <class Real>
std::vector<Rational> AskedSphereTriangle<Real>::relative_margins(const Kernel& kernel, ComparisonBits comparisons) {
  std::vector<Rational> margins;
  const FormulaTruth* own = claims().sides(kernel.formulae);
  if (own == nullptr) return margins;
  for_each_bit(comparisons, [&](std::size_t k) { margins.push_back(relative_margin(own->comparison(k))); });
  return margins;
}

template <class Real>
std::optional<SideErrorSize> AskedSphereTriangle<Real>::side_error(const Kernel& kernel, std::size_t comparison,
                                                                   double lhs, double rhs) {
  const FormulaTruth* own = claims().sides(kernel.formulae);
  if (own == nullptr) return std::nullopt;
  const ExactComparison exact = own->comparison(comparison);
  const ComparisonError error(static_cast<Real>(lhs), static_cast<Real>(rhs), exact);
  if (error.kind() != ComparisonError::Kind::finite) return std::nullopt;
  if (exact.rooted) return SideErrorSize{error.rounded_up(), std::nullopt};
  const Fraction fraction = error.exact();
  return SideErrorSize{error.rounded_up(), Rational(fraction.numerator) / Rational(fraction.denominator)};
}

template class AskedSphereTriangle<float>;
template class AskedSphereTriangle<double>;

}  // namespace axiscert

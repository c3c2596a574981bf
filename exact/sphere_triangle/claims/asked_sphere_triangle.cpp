#include "exact/sphere_triangle/claims/asked_sphere_triangle.h"

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

template class AskedSphereTriangle<float>;
template class AskedSphereTriangle<double>;

}  // namespace axiscert

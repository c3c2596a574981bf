#include "exact/sphere_triangle/claims/claim.h"

#include <fmt/format.h>

#include "exact/sphere_triangle/unbounded/unbounded.h"
#include "kernel/sphere_triangle/reference/scalar.h"
#include "kernel/sphere_triangle/description.h"

namespace axiscert {
namespace {

// Wherever a rung defines both sides of a comparison, the sign has to be the published one.
std::optional<std::string> contradiction(const FormulaTruth& rung, const FormulaTruth& published) {
  const auto defined = static_cast<ComparisonBits>(~rung.undefined);
  const bool same_ties = (rung.ties & defined) == (published.ties & defined);
  if (rung.strict == published.strict && same_ties) return std::nullopt;
  return fmt::format(
      "exact signs {:016b} ties {:016b} undefined {:016b}, published {:016b} ties {:016b} (bit 0 is the "
      "first comparison)",
      rung.strict, rung.ties, rung.undefined, published.strict, published.ties);
}

}  // namespace

template <class Real>
const FormulaTruth* Claims<Real>::sides(Formulae formulae) {
  if (!has_comparisons(formulae)) return nullptr;
  if (formulae == Formulae::published) return &published_;
  for (const auto& [known, truth] : others_) {
    if (known == formulae) return &truth;
  }
  const FormulaTruth& truth = others_.emplace_back(formulae, formula_truth(formulae, query_)).second;
  if (kind_of(formulae) == FormulaeKind::rung) {
    if (const auto wrong = contradiction(truth, published_)) {
      throw OracleDisagreement(fmt::format("formulae {}: {}", name(formulae), *wrong), Numbers<Real>(query_),
                               sphere_triangle_test());
    }
  }
  return &truth;
}

template <class Real>
std::optional<Reference> Claims<Real>::chain(const Kernel& kernel) {
  if (kernel.formulae == Formulae::none) return std::nullopt;
  const FormulaTruth* own = sides(kernel.formulae);
  Reference chain{own ? outcome_of(own->bits(kernel.strictness)) : Outcome{exact_verdict(kernel.formulae, query_), {}},
                  std::nullopt, own ? own->ties : ComparisonBits{0}};
  if (kernel.is_reference) {
    const auto ask = [&](auto&& of) { return of(kernel.formulae, kernel.arithmetic, kernel.strictness, query_); };
    if (by_mpfr_) {
      chain.rounded = Rounded{ask([](auto... claim) { return unbounded_by_mpfr(claim...); }),
                              ask([](auto... claim) { return reference(claim...); })};
    } else {
      chain.rounded = ask([](auto... claim) { return rounded(claim...); });
    }
  }
  return chain;
}

template class Claims<float>;
template class Claims<double>;

}  // namespace axiscert

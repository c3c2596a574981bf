#include "exact/sphere_triangle/asked_sphere_triangle.h"

#include <fmt/format.h>

#include "exact/sphere_triangle/measures/depth.h"
#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "exact/sphere_triangle/oracles/second_oracle.h"
#include "exact/sphere_triangle/unbounded.h"
#include "kernel/sphere_triangle/forms/scalar.h"
#include "kernel/sphere_triangle/query.h"

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
std::optional<std::string> oracle_contradiction(const Query<Real>& q, int geometric_order, const ExactSides& sides,
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

// Wherever a rung defines both sides of a comparison, the sign has to be the published one.
std::optional<std::string> contradiction(const ExactSides& rung, const ExactSides& published) {
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
ExactTruth exact_truth(const Query<Real>& q, bool with_second_opinion) {
  if (!is_valid(q)) return {{Verdict::invalid, false}, std::nullopt};
  const int geometric_order = distance_order(q);
  ExactSides sides = exact_sides(q);
  std::optional<SecondOpinion> opinion;
  if (with_second_opinion) opinion = second_opinion(q);
  if (auto wrong = oracle_contradiction(q, geometric_order, sides, opinion)) {
    const SecondOpinion mpfr = second_opinion(q);
    throw OracleDisagreement(
        fmt::format("{}; MPFR's own verdict is {}", *wrong, name(separated_if(mpfr.distance_order > 0))),
        Numbers<Real>(q), sphere_triangle_predicate());
  }
  return {{separated_if(geometric_order > 0), geometric_order == 0}, std::move(sides)};
}
template ExactTruth exact_truth<float>(const Query<float>&, bool);
template ExactTruth exact_truth<double>(const Query<double>&, bool);

template <class Real>
const ExactTruth& AskedSphereTriangle<Real>::exact() {
  if (truth_) return *truth_;
  truth_ = exact_truth(query_, opinion_ != Opinion::first);
  check_truth(*truth_);
  if (truth_->touching) distance_.set_touching();
  return *truth_;
}

template <class Real>
const ExactSides* AskedSphereTriangle<Real>::sides(Formulae formulae) {
  if (!has_comparisons(formulae)) return nullptr;
  if (truth_ && formulae == Formulae::published) return &*truth_->sides;
  for (const auto& [known, sides] : sides_) {
    if (known == formulae) return &sides;
  }
  const ExactSides& found = sides_.emplace_front(formulae, exact_sides(formulae, query_)).second;
  if (formulae != Formulae::published && has_published_signs(formulae)) {
    if (const auto wrong = contradiction(found, *sides(Formulae::published))) {
      throw OracleDisagreement(fmt::format("formulae {}: {}", name(formulae), *wrong), Numbers<Real>(query_),
                               sphere_triangle_predicate());
    }
  }
  return &found;
}

template <class Real>
std::optional<Reference> AskedSphereTriangle<Real>::chain(const Kernel& kernel) {
  const Formulae formulae = formulae_of(kernel);
  if (formulae == Formulae::none) return std::nullopt;
  const ExactSides* own = sides(formulae);
  Reference chain{own ? outcome_of(own->holding(nonstrict_comparisons(kernel.strictness)))
                      : Outcome{exact_verdict(formulae, query_), {}},
                  std::nullopt, own ? own->ties : ComparisonBits{0}};
  if (kernel.is_reference) {
    const auto ask = [&](auto&& of) { return of(formulae, kernel.arithmetic, kernel.strictness, query_); };
    if (opinion_ == Opinion::exact_only) {
      chain.rounded = RoundedDecisions{ask([](auto... claim) { return unbounded_by_mpfr(claim...); }),
                                       ask([](auto... claim) { return reference(claim...); })};
    } else {
      chain.rounded = ask([](auto... claim) { return rounded(claim...); });
    }
  }
  return chain;
}

template <class Real>
std::optional<ExactSigns> AskedSphereTriangle<Real>::published_signs() {
  const ExactSides& sides = *exact().sides;
  return ExactSigns{sides.strict, sides.ties};
}

template <class Real>
std::optional<ExactDepth> AskedSphereTriangle<Real>::exact_depth() {
  return axiscert::exact_depth(query_, distance_.squared());
}

template class AskedSphereTriangle<float>;
template class AskedSphereTriangle<double>;

}  // namespace axiscert

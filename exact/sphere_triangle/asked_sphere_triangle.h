// The truth about one query of sphere-triangle, with the cross-checks that every query has to pass before anything is
// reported, and all else that is asked of it.
#pragma once

#include <forward_list>
#include <optional>

#include "exact/judge/oracles.h"
#include "exact/sphere_triangle/measures/depth.h"
#include "exact/sphere_triangle/oracles/exact_truth.h"
#include "kernel/formulae_list.h"

namespace axiscert {
// Decides by CGAL and by the exact formulae and compares: the verdict of the formulae with non-strict sides is the
// geometric one on every triangle; with strict sides it may differ only on a zero-area triangle, and only as a phantom
// contact. With `second_opinion`, and before any disagreement is reported, MPFR repeats all decisions. Throws
// OracleDisagreement.
template <class Real>
ExactTruth exact_truth(const Query<Real>& q, bool second_opinion);

template <class Real>
class AskedSphereTriangle : public AskedQuery {
 public:
  AskedSphereTriangle(const Query<Real>& q, Opinion opinion)
      : query_(q), opinion_(opinion), distance_(query_, opinion == Opinion::exact_only) {}
  AskedSphereTriangle(const AskedSphereTriangle&) = delete;

  Truth truth() override { return exact(); }
  std::optional<Reference> chain(const Kernel& kernel) override;
  const ExactSides* sides(const Kernel& kernel) override { return sides(formulae_of(kernel)); }
  DepthOf& depth() override { return distance_; }
  std::optional<ExactSigns> published_signs() override;
  std::optional<Rational> squared_distance() override { return distance_.squared(); }
  std::optional<ExactDepth> exact_depth() override;

  const Query<Real>& query() const { return query_; }
  LazyDistance<Real>& distance() { return distance_; }
  // With the exact sides of the published formulae.
  const ExactTruth& exact();
  // Those of a set of formulae, without asking the geometry; null for `none` and for a method, which has no sides.
  // Throws OracleDisagreement if a rung defines a sign that differs from the published one: over the reals no query can
  // cause that.
  const ExactSides* sides(Formulae formulae);

 private:
  // The truth was found: a place for checks of it.
  virtual void check_truth(const ExactTruth&) {}

  const Query<Real> query_;
  const Opinion opinion_;
  LazyDistance<Real> distance_;
  std::optional<ExactTruth> truth_;
  std::forward_list<std::pair<Formulae, ExactSides>> sides_;
};

}  // namespace axiscert

// One query of sphere-triangle, of which more than one thing is asked.
#pragma once

#include <forward_list>
#include <optional>

#include "exact/sphere_triangle/measures/lazy_distance.h"
#include "exact/sphere_triangle/oracles/exact_truth.h"
#include "exact/trait/oracles.h"
#include "kernel/formulae_list.h"

namespace axiscert {

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

// One query of sphere-triangle, of which more than one thing is asked.
#pragma once

#include <forward_list>
#include <optional>

#include "exact/sphere_triangle/claims/claim.h"
#include "exact/sphere_triangle/measures/lazy_distance.h"
#include "exact/sphere_triangle/oracles/exact_truth.h"
#include "exact/trait/oracles.h"

namespace axiscert {

template <class Real>
class AskedSphereTriangle : public AskedQuery {
 public:
  AskedSphereTriangle(const Query<Real>& q, Opinion opinion)
      : query_(q), opinion_(opinion), distance_(query_, opinion == Opinion::exact_only) {}
  AskedSphereTriangle(const AskedSphereTriangle&) = delete;

  Truth truth() override { return exact(); }
  std::optional<Reference> chain(const Kernel& kernel) override;
  const ExactSides* sides(const Kernel& kernel) override;
  DepthOf& depth() override { return distance_; }
  std::optional<ExactSigns> published_signs() override;
  std::optional<Rational> squared_distance() override { return distance_.squared(); }
  std::optional<ExactDepth> exact_depth() override;
  std::vector<Rational> relative_margins(const Kernel& kernel, ComparisonBits comparisons) override;
  std::optional<SideErrorSize> side_error(const Kernel& kernel, std::size_t comparison, double lhs,
                                          double rhs) override;

  const Query<Real>& query() const { return query_; }
  LazyDistance<Real>& distance() { return distance_; }
  // With the exact sides of the published formulae.
  const ExactTruth& exact();
  Claims<Real>& claims();  // of a valid query

 private:
  // The truth was found: a place for checks of it.
  virtual void found(const ExactTruth&) {}

  const Query<Real> query_;
  const Opinion opinion_;
  LazyDistance<Real> distance_;
  std::optional<ExactTruth> truth_;
  std::optional<Claims<Real>> claims_;
  std::forward_list<std::pair<const FormulaTruth*, ExactSides>> sides_;  // with their relations
};

}  // namespace axiscert

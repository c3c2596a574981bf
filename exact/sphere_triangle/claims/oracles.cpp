// sphere-triangle by the interface of all tests. Its campaign does not go this way: it has filters.
#include "exact/trait/oracles.h"

#include "exact/sphere_triangle/claims/claim.h"
#include "exact/sphere_triangle/filters/cascade.h"
#include "exact/sphere_triangle/measures/depth.h"
#include "exact/sphere_triangle/measures/limits.h"
#include "exact/sphere_triangle/oracles/exact_truth.h"
#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "kernel/sphere_triangle/description.h"

namespace axiscert {
namespace {

// Empty where a side is a root or does not exist.
std::optional<ExactSides> rational_sides(const FormulaTruth& truth, Strictness strictness) {
  if (truth.rooted != 0 || truth.undefined != 0) return std::nullopt;
  ExactSides sides{{}, {}, truth.bits(strictness), truth.ties};
  for (std::size_t i = 0; i < comparison_count; ++i) {
    const ExactComparison comparison = truth.comparison(i);
    const Rational denominator = rational(comparison.denominator);
    sides.lhs.emplace_back(Rational(rational(comparison.lhs) / denominator));
    sides.rhs.emplace_back(Rational(rational(comparison.rhs) / denominator));
  }
  return sides;
}

template <class Real>
class AskedSphereTriangle final : public AskedQuery {
 public:
  AskedSphereTriangle(const Numbers<Real>& numbers, Opinion opinion) : q_(query_from(numbers)), opinion_(opinion) {}

  Truth truth() override { return exactly(); }
  std::optional<Claimed> claimed(const Kernel& kernel) override {
    if (!claims_) claims_.emplace(q_, *exactly().formula);
    std::optional<Reference> chain = claims_->chain(kernel);
    if (!chain) return std::nullopt;
    const FormulaTruth* own = claims_->sides(kernel.formulae);
    return Claimed{std::move(*chain), own ? rational_sides(*own, kernel.strictness) : std::nullopt};
  }

 private:
  const ExactTruth& exactly() {
    if (!truth_) truth_ = exact_truth(q_, opinion_ == Opinion::second);
    return *truth_;
  }

  const Query<Real> q_;
  const Opinion opinion_;
  std::optional<ExactTruth> truth_;
  std::optional<Claims<Real>> claims_;
};

// By the cascade of filters.
template <class Real>
class FilteredSphereTriangles final : public BatchOracle<Real> {
 public:
  explicit FilteredSphereTriangles(std::string_view target) : cascade_(filter_on<Real>(target)) {}

  void decide(const QueryBatch<Real>& batch) override {
    batch_ = &batch;
    decided_ = &cascade_.decide(batch);
  }
  std::optional<Truth> known(std::size_t i) const override {
    if ((*decided_)[i].step == Step::exact) return std::nullopt;
    const Signs& signs = (*decided_)[i].signs;
    return Truth{verdict_of(signs), is_touching(signs, query_from((*batch_)[i]).r == 0)};
  }

 private:
  Cascade<Real> cascade_;
  const QueryBatch<Real>* batch_ = nullptr;
  const std::vector<DecidedSigns>* decided_ = nullptr;
};

class SphereTriangleOracles final : public Oracles {
 public:
  const TestDescription& test() const override { return sphere_triangle_test(); }
  std::vector<std::string_view> formulae() const override { return {}; }  // a kernel claims them by Kernel::formulae

  std::unique_ptr<BatchOracle<float>> batches(std::string_view target, std::type_identity<float>) const override {
    return std::make_unique<FilteredSphereTriangles<float>>(target);
  }
  std::unique_ptr<BatchOracle<double>> batches(std::string_view target, std::type_identity<double>) const override {
    return std::make_unique<FilteredSphereTriangles<double>>(target);
  }
  std::unique_ptr<AskedQuery> about(const Numbers<float>& q, Opinion opinion) const override {
    return std::make_unique<AskedSphereTriangle<float>>(q, opinion);
  }
  std::unique_ptr<AskedQuery> about(const Numbers<double>& q, Opinion opinion) const override {
    return std::make_unique<AskedSphereTriangle<double>>(q, opinion);
  }
  bool has_depth() const override { return true; }
  std::optional<double> depth(const Numbers<float>& q) const override { return depth_of<float>(q); }
  std::optional<double> depth(const Numbers<double>& q) const override { return depth_of<double>(q); }
  bool is_within(const Limits& limits, const Numbers<float>& q) const override {
    return axiscert::is_within(limits, query_from(q));
  }
  bool is_within(const Limits& limits, const Numbers<double>& q) const override {
    return axiscert::is_within(limits, query_from(q));
  }

 private:
  template <class Real>
  static double depth_of(const Query<Real>& q) {
    return axiscert::depth(q, squared_distance(q));
  }
};

}  // namespace

const Oracles& sphere_triangle_oracles(std::size_t) {
  static const SphereTriangleOracles oracles;
  return oracles;
}

}  // namespace axiscert

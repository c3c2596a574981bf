// sphere-triangle by the interface of all predicates.
#include "exact/judge/oracles.h"
#include "kernel/query.h"

#include "exact/judge/clear.h"
#include "exact/sphere_triangle/asked_sphere_triangle.h"
#include "exact/sphere_triangle/measures/contact_judge.h"
#include "exact/sphere_triangle/measures/critical_radius.h"
#include "exact/sphere_triangle/measures/depth.h"
#include "exact/sphere_triangle/measures/input_class.h"
#include "exact/sphere_triangle/oracles/cascade.h"
#include "exact/sphere_triangle/oracles/exact_truth.h"
#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "kernel/sphere_triangle/forms/ladder.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

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
    if (!is_known(i)) return std::nullopt;
    const Signs& signs = (*decided_)[i].signs;
    return Truth{verdict_of(signs), is_touching(signs, query(i).r == 0)};
  }
  std::optional<KnownSigns> signs(std::size_t i) const override {
    if (!is_known(i)) return std::nullopt;
    return known_signs(i, Strictness::nonstrict);
  }
  std::optional<KnownSigns> claimed(std::size_t i, const Kernel& kernel) const override {
    const Formulae formulae = formulae_of(kernel);
    if (!is_known(i) || !has_comparisons(formulae)) return std::nullopt;
    // Rungs have the published signs on every query.
    if (has_published_signs(formulae)) return known_signs(i, kernel.strictness);
    const ExactSides own = exact_sides(formulae, query(i));
    return KnownSigns{own.holding(nonstrict_comparisons(kernel.strictness)), own.ties, (*decided_)[i].certain_in_lanes};
  }
  void check(std::size_t i, std::uint64_t position, std::uint64_t stride) const override {
    if (!is_known(i)) return;
    const bool is_hardest = (*decided_)[i].step == Step::integers && position % integer_check_stride == 0;
    if (is_hardest || (stride != 0 && position % stride == 0))
      require_same((*decided_)[i], exact_truth(query(i), true), query(i));
  }

 private:
  bool is_known(std::size_t i) const { return (*decided_)[i].step != Step::exact; }
  Query<Real> query(std::size_t i) const { return query_from((*batch_)[i]); }
  KnownSigns known_signs(std::size_t i, Strictness strictness) const {
    const Signs& signs = (*decided_)[i].signs;
    return {signs.bits(strictness), signs.ties, (*decided_)[i].certain_in_lanes};
  }

  Cascade<Real> cascade_;
  const QueryBatch<Real>* batch_ = nullptr;
  const std::vector<DecidedSigns>* decided_ = nullptr;
};

// The predicate, and its formulae, as code for every predicate sees them (kernel/formulae_kernel.h).
struct SphereAndTriangle {
  static const Predicate& description() { return sphere_triangle_predicate(); }
  template <class T, class Load>
  static portable::Problem<T> problem(Load&& load) {
    const auto point = [&](std::size_t k) { return portable::Vec3<T>{load(k), load(k + 1), load(k + 2)}; };
    return {point(0), point(3), point(6), point(9), load(12), T(0.0)};
  }
  template <class Real>
  static double moved_length(const Numbers<Real>& q) {
    const auto given = problem<double>([&](std::size_t k) { return static_cast<double>(q[k]); });
    return barycentric_length(given.a, given.b, given.c);
  }
};
template <class F>
struct ByIndex {
  template <class T, class Sink>
  static void comparisons(const portable::Problem<T>& q, Sink& sink) {
    F::comparisons(q, [&](Comparison which, const T& lhs, const T& rhs) { sink(index_of(which), lhs, rhs); });
  }
};
// The derivation's last form, and its first, in the world's coordinates; the cheaper one decides most.
using ClearForms = FormulaeList<ByIndex<portable::PublishedFormulae>, ByIndex<rungs::Ladder0>>;

class SphereTriangleOracles final : public Oracles {
 public:
  const Predicate& predicate() const override { return sphere_triangle_predicate(); }
  bool is_valid(const Numbers<float>& q) const override { return axiscert::is_valid(query_from(q)); }
  bool is_valid(const Numbers<double>& q) const override { return axiscert::is_valid(query_from(q)); }
  std::vector<std::string_view> formulae() const override {
    std::vector<std::string_view> names;
    for (const Formulae one : enumerators<Formulae>) names.push_back(name(one));
    return names;
  }

  bool has_filters() const override { return true; }
  std::unique_ptr<BatchOracle<float>> batches(std::string_view target, std::type_identity<float>) const override {
    return std::make_unique<FilteredSphereTriangles<float>>(target);
  }
  std::unique_ptr<BatchOracle<double>> batches(std::string_view target, std::type_identity<double>) const override {
    return std::make_unique<FilteredSphereTriangles<double>>(target);
  }
  std::unique_ptr<AskedQuery> about(const Numbers<float>& q, Opinion opinion) const override {
    return std::make_unique<AskedSphereTriangle<float>>(query_from(q), opinion);
  }
  std::unique_ptr<AskedQuery> about(const Numbers<double>& q, Opinion opinion) const override {
    return std::make_unique<AskedSphereTriangle<double>>(query_from(q), opinion);
  }
  std::optional<Verdict> clear_verdict(const Numbers<float>& q) const override { return clear_verdict_of(q); }
  std::optional<Verdict> clear_verdict(const Numbers<double>& q) const override { return clear_verdict_of(q); }
  bool has_depth() const override { return true; }
  bool has_squared_distance() const override { return true; }
  std::optional<double> depth(const Numbers<float>& q) const override { return depth_of<float>(q); }
  std::optional<double> depth(const Numbers<double>& q) const override { return depth_of<double>(q); }
  std::optional<Verdict> verdict_beyond(double depth, const Numbers<float>& q) const override {
    return beyond<float>(depth, q);
  }
  std::optional<Verdict> verdict_beyond(double depth, const Numbers<double>& q) const override {
    return beyond<double>(depth, q);
  }
  std::optional<CriticalLength> critical_length() const override {
    return CriticalLength{coordinate_count - 1, squared_critical_radius, coordinate_count - 4};
  }
  bool is_degenerate(const Numbers<float>& q) const override { return axiscert::is_degenerate(query_from(q)); }
  bool is_degenerate(const Numbers<double>& q) const override { return axiscert::is_degenerate(query_from(q)); }
  bool has_limits() const override { return true; }
  bool is_within(const Limits& limits, const Numbers<float>& q) const override {
    return axiscert::is_within(limits, query_from(q));
  }
  bool is_within(const Limits& limits, const Numbers<double>& q) const override {
    return axiscert::is_within(limits, query_from(q));
  }
  std::unique_ptr<ContactJudge> contact_judge(const Numbers<float>& q) const override { return judge_of(q); }
  std::unique_ptr<ContactJudge> contact_judge(const Numbers<double>& q) const override { return judge_of(q); }

 private:
  template <class Real>
  static std::optional<Verdict> clear_verdict_of(const Numbers<Real>& q) {
    const auto found = clear_verdict_by<SphereAndTriangle>(ClearForms(), q);
    return found && axiscert::is_valid(query_from(q)) ? found : std::nullopt;
  }
  template <class Real>
  static std::unique_ptr<ContactJudge> judge_of(const Numbers<Real>& q) {
    return std::make_unique<SphereTriangleJudge<Real>>(query_from(in_doubles(q)));
  }
  template <class Real>
  static double depth_of(const Query<Real>& q) {
    return axiscert::depth(q, squared_distance(q));
  }
  // By bounds of the depth where they tell.
  template <class Real>
  static std::optional<Verdict> beyond(double threshold, const Query<Real>& q) {
    if (!axiscert::is_valid(q)) return std::nullopt;
    const DepthRange range = depth_range(q);
    if (range.high <= threshold) return std::nullopt;
    if (!(range.low > threshold)) {
      const ExactDepth least{0, exact(threshold), 1};
      if (compare(exact_depth(q, squared_distance(q)), least) <= 0) return std::nullopt;
    }
    return distance_order(q) > 0 ? Verdict::separated : Verdict::contact;
  }
  static std::optional<Rational> squared_critical_radius(const Numbers<double>& q) {
    return squared_distance(query_from(q));
  }
};

}  // namespace

const Oracles& sphere_triangle_oracles(std::size_t) {
  static const SphereTriangleOracles oracles;
  return oracles;
}

}  // namespace axiscert

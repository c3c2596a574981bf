// What a search for the worst queries of sphere-triangle values exactly besides wrong verdicts: the errors of the
// sides, the scales at which a comparison leaves the range, and the error of the critical radius.
#include "fuzz/sphere_triangle/aim_values.h"

#include <cmath>

#include "exact/sphere_triangle/measures/critical_radius.h"
#include "exact/sphere_triangle/measures/limits.h"
#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "exact/sphere_triangle/unbounded/unbounded.h"
#include "fuzz/queries/image_groups.h"
#include "fuzz/sphere_triangle/search_box.h"
#include "fuzz/sphere_triangle/search_range.h"
#include "kernel/ask.h"

namespace axiscert {
namespace {

template <class Real>
std::optional<Decimal6> range_value(const Aim& aim, const Kernel& kernel, const Implementation<Real>& implementation,
                                    const Query<Real>& q) {
  QueryBatch<Real> one(1, coordinate_count);
  one.push_back(q);
  const auto m = range_left(implementation, aim, one).front();
  if (!m) return std::nullopt;
  const Query<Real> there = times_power(q, *m);
  const Reply<Real> reply = ask(implementation, there);
  const std::size_t k = aim.which;
  const bool finite = std::isfinite(reply.answers.lhs[k][0]) && std::isfinite(reply.answers.rhs[k][0]);
  const ComparisonBits expected = *unbounded(formulae_of(kernel), kernel.arithmetic, kernel.strictness, there).bits;
  if (finite && !has_bit(reply.answers.bits[0] ^ expected, k)) return std::nullopt;
  return round_up(exact(range_score(aim.goal, precision_of<Real>, *m)));
}

template <class Real>
std::optional<Decimal6> critical_error(const Kernel& kernel, const Implementation<Real>& implementation,
                                       const Query<Real>& q) {
  const Rational squared = squared_distance(q);
  const auto range = radii_within<Real>(kernel.limits);
  const auto distance = distance_within(squared, range);
  if (!distance) return std::nullopt;
  const auto critical = critical_radius(implementation, q, range);
  if (!critical.answered || critical.not_decided || !critical.radius) return std::nullopt;
  return radius_error_ulps(*critical.radius, *distance, squared);
}

template <class Real>
std::optional<Decimal6> aim_value(const Aim& aim, const Kernel& kernel, const Implementation<Real>& implementation,
                                  const Query<Real>& q) {
  if (!is_valid(q)) return std::nullopt;
  switch (aim.goal) {
    case Goal::error:
    case Goal::relative_error: {
      if (aim.goal == Goal::error && !is_in_box(q)) return std::nullopt;
      const auto all = side_errors<Real>(kernel, implementation, q);
      if (!all) return std::nullopt;
      return (aim.goal == Goal::error ? all->absolute : all->relative)[aim.which];
    }
    case Goal::overflow:
    case Goal::underflow:
      return range_value(aim, kernel, implementation, q);
    case Goal::critical_radius:
      return critical_error(kernel, implementation, q);
    case Goal::missed_contact:
    case Goal::phantom_contact:
      return std::nullopt;  // wrong verdicts, which every predicate has
  }
  return std::nullopt;
}

class SphereTriangleAims final : public AimValues {
 public:
  std::optional<Decimal6> value(const Aim& aim, const Kernel& kernel, const Implementation<float>& implementation,
                                const Numbers<float>& q) const override {
    return aim_value<float>(aim, kernel, implementation, q);
  }
  std::optional<Decimal6> value(const Aim& aim, const Kernel& kernel, const Implementation<double>& implementation,
                                const Numbers<double>& q) const override {
    return aim_value<double>(aim, kernel, implementation, q);
  }
};

}  // namespace

const AimValues& sphere_triangle_aim_values() {
  static const SphereTriangleAims values;
  return values;
}

}  // namespace axiscert

// What a search for the worst queries of sphere-triangle values exactly besides wrong verdicts: the errors of the
// sides, the scales at which a comparison leaves the range, and the error of the critical radius.
#include "fuzz/sphere_triangle/aim_values.h"

#include <cmath>
#include <limits>

#include "exact/sphere_triangle/claims/asked_sphere_triangle.h"
#include "exact/sphere_triangle/measures/critical_radius.h"
#include "exact/sphere_triangle/measures/limits.h"
#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "exact/sphere_triangle/unbounded/unbounded.h"
#include "exact/trait/side_error.h"
#include "fuzz/queries/image_groups.h"
#include "fuzz/sphere_triangle/search_box.h"
#include "fuzz/sphere_triangle/search_range.h"
#include "kernel/ask.h"
#include "kernel/sphere_triangle/shown_sides.h"

namespace axiscert {
namespace {

// |a - sqrt(s)| for s >= 0 as |a^2 - s| / (a + sqrt(s)) if a is positive: no cancellation follows a rounding.
Rational distance_to_root(const Rational& a, const Rational& s) {
  constexpr mp_bitcnt_t bits = 256;
  const mpf_class root = sqrt(mpf_class(s, bits)), at(a, bits);
  if (sgn(a) <= 0) return Rational(mpf_class(root - at, bits));
  return Rational(mpf_class(mpf_class(abs(Rational(a * a - s)), bits) / (at + root), bits));
}

// |(l^ - r^) - (l - r)| / u, rounded up; if l is a root, from 256 bits of it.
template <class Real>
Decimal6 absolute_error(Real computed_lhs, Real computed_rhs, const ExactComparison& exact_sides) {
  const Rational computed = exact(computed_lhs) - exact(computed_rhs), den = rational(exact_sides.rhs.under);
  const Rational l = rational(exact_sides.lhs.over), r = rational(exact_sides.rhs.over);
  const Rational difference =
      exact_sides.is_rooted ? distance_to_root(computed * den + r, l) : Rational(abs(computed * den - (l - r)));
  return round_up(Rational(difference / den * Rational(mpz_class(1) << std::numeric_limits<Real>::digits)));
}

template <class Real>
std::optional<SideErrors> side_errors(const Kernel& kernel, const Implementation<Real>& implementation,
                                      const Query<Real>& q) {
  if (kernel.exposes != Exposure::sides || !has_comparisons(formulae_of(kernel)) || !is_valid(q)) return std::nullopt;
  const Reply<Real> reply = ask(implementation, q);
  if (!reply.has_bits || reply.verdicts[0] == Verdict::unanswered) return std::nullopt;
  // Every oracle agrees about the query; the kernel's own formulae follow.
  AskedSphereTriangle<Real> asked(q, Opinion::second);
  asked.truth();
  const ExactSides& own = *asked.sides(kernel);
  const Sides<Real> sides = sides_at(reply.answers, 0);
  SideErrors all;
  all.absolute.resize(comparison_count);
  all.relative.resize(comparison_count);
  for (std::size_t k = 0; k < comparison_count; ++k) {
    const ExactComparison exact = own.comparison(k);
    const SideError relative(sides.lhs[k], sides.rhs[k], exact);
    if (exact.is_undefined || relative.kind() == SideError::Kind::range_event) continue;
    all.absolute[k] = absolute_error(sides.lhs[k], sides.rhs[k], exact);
    if (relative.kind() == SideError::Kind::finite) all.relative[k] = relative.rounded_up();
  }
  return all;
}

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
      const auto all = side_errors(kernel, implementation, q);
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
      return std::nullopt;  // wrong verdicts, which every test has
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
  std::optional<SideErrors> errors(const Kernel& kernel, const Implementation<float>& implementation,
                                   const Numbers<float>& q) const override {
    return side_errors<float>(kernel, implementation, q);
  }
  std::optional<SideErrors> errors(const Kernel& kernel, const Implementation<double>& implementation,
                                   const Numbers<double>& q) const override {
    return side_errors<double>(kernel, implementation, q);
  }
};

}  // namespace

const AimValues& sphere_triangle_aim_values() {
  static const SphereTriangleAims values;
  return values;
}

}  // namespace axiscert

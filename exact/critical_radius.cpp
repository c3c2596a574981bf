#include "exact/critical_radius.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace axiscert {
namespace {

// Floats that are not negative are ordered as their bits, and follow each other as integers do.
template <class Real>
using BitsOf = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;

template <class Real>
constexpr Real greatest = std::numeric_limits<Real>::max();

template <class Real>
Real ulp_of(Real x) {
  return x == greatest<Real> ? x - std::nextafter(x, Real(0)) : std::nextafter(x, greatest<Real>) - x;
}

template <class Real>
std::vector<Verdict> verdicts_at(const Implementation<Real>& kernel, Query<Real> query,
                                 const std::vector<BitsOf<Real>>& radii) {
  QueryBatch<Real> batch(radii.size());
  for (const auto radius : radii) {
    query.r = std::bit_cast<Real>(radius);
    batch.push_back(query);
  }
  std::vector<Verdict> verdicts(radii.size());
  kernel.verdicts(batch.columns(), verdicts.data());
  return verdicts;
}

constexpr int near = 32;  // floats to each side

template <class Real>
std::vector<BitsOf<Real>> probes(std::optional<Real> critical, std::optional<Real> exact_radius) {
  using Bits = BitsOf<Real>;
  using Limits = std::numeric_limits<Real>;
  constexpr Bits last = std::bit_cast<Bits>(greatest<Real>);
  std::vector<Bits> radii = {0, last};
  constexpr int least_exponent = Limits::min_exponent - Limits::digits;
  for (int e = least_exponent; e < Limits::max_exponent; ++e) {
    radii.push_back(std::bit_cast<Bits>(std::ldexp(Real(1), e)));
  }
  for (const auto& centre : {critical, exact_radius}) {
    if (!centre) continue;
    const Bits at = std::bit_cast<Bits>(*centre);
    const Bits end = at + std::min<Bits>(near, last - at);
    for (Bits radius = at - std::min<Bits>(near, at); radius <= end; ++radius) radii.push_back(radius);
  }
  std::sort(radii.begin(), radii.end());
  radii.erase(std::unique(radii.begin(), radii.end()), radii.end());
  return radii;
}

}  // namespace

template <class Real>
CriticalRadius<Real> critical_radius(const Implementation<Real>& kernel, const Query<Real>& query,
                                     const RadiusRange<Real>& range) {
  using Bits = BitsOf<Real>;
  const auto verdict_at = [&](Bits radius) { return verdicts_at(kernel, query, {radius}).front(); };
  Bits low = std::bit_cast<Bits>(range.least), high = std::bit_cast<Bits>(range.greatest);
  Verdict verdict = verdict_at(high);
  if (verdict != Verdict::contact) return {std::nullopt, verdict != Verdict::unanswered};
  while (low < high) {
    const Bits middle = low + (high - low) / 2;
    verdict = verdict_at(middle);
    if (verdict == Verdict::unanswered) return {std::nullopt, false};
    if (verdict == Verdict::contact) high = middle;
    else low = middle + 1;
  }
  return {std::bit_cast<Real>(low)};
}

template <class Real>
std::optional<Real> exact_critical_radius(const Rational& squared_distance) {
  const Real distance = nearest_sqrt<Real>(squared_distance);
  if (!std::isfinite(distance)) return std::nullopt;
  const Rational d = exact(distance);
  if (d * d >= squared_distance) return distance;
  if (distance == greatest<Real>) return std::nullopt;
  return std::nextafter(distance, greatest<Real>);
}

template <class Real>
Decimal6 radius_error_ulps(Real radius, Real from, const Rational& squared_distance) {
  if (radius == from) return {};
  return round_up(Rational(abs(exact(radius) - exact(from)) / exact(ulp_of(nearest_sqrt<Real>(squared_distance)))));
}

template <class Real>
CriticalRadiusError critical_radius_error(const Implementation<Real>& kernel, const Query<Real>& query,
                                          const Rational& squared_distance, const RadiusRange<Real>& range) {
  const Real distance = nearest_sqrt<Real>(squared_distance);
  if (!std::isfinite(distance) || distance < range.least || distance > range.greatest) return {};
  const auto critical = critical_radius(kernel, query, range);
  if (!critical.answered) return {std::nullopt, false};
  if (!critical.radius) return {std::numeric_limits<double>::infinity()};
  return {Rational(abs(exact(*critical.radius) - exact(distance)) / exact(ulp_of(distance))).get_d()};
}

template <class Real>
std::optional<RadiusReversal<Real>> radius_reversal(const Implementation<Real>& kernel, const Query<Real>& query,
                                                    std::optional<Real> critical, std::optional<Real> exact_radius) {
  const auto radii = probes(critical, exact_radius);
  const auto verdicts = verdicts_at(kernel, query, radii);
  std::optional<Real> contact;
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const Real radius = std::bit_cast<Real>(radii[i]);
    if (verdicts[i] == Verdict::contact) contact = radius;
    else if (contact && verdicts[i] == Verdict::separated) return RadiusReversal<Real>{*contact, radius};
  }
  return std::nullopt;
}

#define AXISCERT_INSTANTIATE(Real)                                                                                     \
  template CriticalRadius<Real> critical_radius(const Implementation<Real>&, const Query<Real>&,                       \
                                                const RadiusRange<Real>&);                                             \
  template std::optional<Real> exact_critical_radius<Real>(const Rational&);                                           \
  template Decimal6 radius_error_ulps(Real, Real, const Rational&);                                                    \
  template CriticalRadiusError critical_radius_error(const Implementation<Real>&, const Query<Real>&, const Rational&, \
                                                     const RadiusRange<Real>&);                                        \
  template std::optional<RadiusReversal<Real>> radius_reversal(const Implementation<Real>&, const Query<Real>&,        \
                                                               std::optional<Real>, std::optional<Real>);
AXISCERT_INSTANTIATE(float)
AXISCERT_INSTANTIATE(double)
#undef AXISCERT_INSTANTIATE

}  // namespace axiscert

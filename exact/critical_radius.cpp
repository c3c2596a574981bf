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
std::optional<Real> critical_radius(const Implementation<Real>& kernel, const Query<Real>& query) {
  using Bits = BitsOf<Real>;
  QueryBatch<Real> one(1);
  const auto contact_at = [&](Bits radius) {
    Query<Real> q = query;
    q.r = std::bit_cast<Real>(radius);
    one.clear();
    one.push_back(q);
    Verdict verdict;
    kernel.verdicts(one.columns(), &verdict);
    return verdict == Verdict::contact;
  };
  Bits low = 0, high = std::bit_cast<Bits>(greatest<Real>);
  if (!contact_at(high)) return std::nullopt;
  while (low < high) {
    const Bits middle = low + (high - low) / 2;
    if (contact_at(middle)) high = middle;
    else low = middle + 1;
  }
  return std::bit_cast<Real>(low);
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
std::optional<double> critical_radius_error(const Implementation<Real>& kernel, const Query<Real>& query,
                                            const Rational& squared_distance) {
  const Real distance = nearest_sqrt<Real>(squared_distance);
  if (!std::isfinite(distance)) return std::nullopt;
  const auto critical = critical_radius(kernel, query);
  if (!critical) return std::numeric_limits<double>::infinity();
  return Rational(abs(exact(*critical) - exact(distance)) / exact(ulp_of(distance))).get_d();
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

#define AXISCERT_INSTANTIATE(Real)                                                                              \
  template std::optional<Real> critical_radius(const Implementation<Real>&, const Query<Real>&);                \
  template std::optional<Real> exact_critical_radius<Real>(const Rational&);                                    \
  template Decimal6 radius_error_ulps(Real, Real, const Rational&);                                             \
  template std::optional<double> critical_radius_error(const Implementation<Real>&, const Query<Real>&,         \
                                                       const Rational&);                                        \
  template std::optional<RadiusReversal<Real>> radius_reversal(const Implementation<Real>&, const Query<Real>&, \
                                                               std::optional<Real>, std::optional<Real>);
AXISCERT_INSTANTIATE(float)
AXISCERT_INSTANTIATE(double)
#undef AXISCERT_INSTANTIATE

}  // namespace axiscert

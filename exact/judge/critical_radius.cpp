#include "exact/judge/critical_radius.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <type_traits>

namespace axiscert {
namespace {

// Non-negative floats are ordered as their bits, and their successors are those of the integers.
template <class Real>
using BitsOf = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;

template <class Real>
constexpr Real greatest = std::numeric_limits<Real>::max();

template <class Real>
Numbers<Real> with_radius(const QueryWithRadius<Real>& query, Real r) {
  Numbers<Real> numbers = query.numbers;
  numbers[query.column] = r;
  return numbers;
}

template <class Real>
std::vector<Verdict> verdicts_at(const Implementation<Real>& kernel, const QueryWithRadius<Real>& query,
                                 const std::vector<BitsOf<Real>>& radii) {
  QueryBatch<Real> batch(radii.size(), query.numbers.size());
  for (const auto radius : radii) batch.push_back(with_radius(query, std::bit_cast<Real>(radius)));
  std::vector<Verdict> verdicts(radii.size());
  kernel.verdicts(batch.columns(), verdicts.data());
  return verdicts;
}

constexpr int near = 32;  // floats on each side

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
Real ulp_of(Real x) {
  return x == greatest<Real> ? x - std::nextafter(x, Real(0)) : std::nextafter(x, greatest<Real>) - x;
}

template <class Real>
std::vector<CriticalRadius<Real>> critical_radii(const Implementation<Real>& kernel,
                                                 const std::vector<QueryWithRadius<Real>>& queries,
                                                 const RadiusRange<Real>& range) {
  using Bits = BitsOf<Real>;
  struct Search {
    std::size_t query;
    Bits low, high, asked;
  };
  std::vector<CriticalRadius<Real>> found(queries.size());
  std::vector<Search> searches;
  const Bits least = std::bit_cast<Bits>(range.least), greatest = std::bit_cast<Bits>(range.greatest);
  for (std::size_t i = 0; i < queries.size(); ++i) searches.push_back({i, least, greatest, greatest});

  QueryBatch<Real> batch(queries.size(), queries.empty() ? 0 : queries.front().numbers.size());
  std::vector<Verdict> verdicts(queries.size());
  for (bool is_first = true; !searches.empty(); is_first = false) {
    batch.clear();
    for (Search& search : searches) {
      if (!is_first) search.asked = search.low + (search.high - search.low) / 2;
      batch.push_back(with_radius(queries[search.query], std::bit_cast<Real>(search.asked)));
    }
    kernel.verdicts(batch.columns(), verdicts.data());
    std::size_t left = 0;
    for (std::size_t i = 0; i < searches.size(); ++i) {
      Search search = searches[i];
      CriticalRadius<Real>& result = found[search.query];
      result.answered = verdicts[i] != Verdict::unanswered;
      const bool says_neither = verdicts[i] == Verdict::undecided || verdicts[i] == Verdict::invalid;
      if (says_neither && !result.not_decided) result.not_decided = verdicts[i];
      if (!result.answered || (is_first && verdicts[i] != Verdict::contact)) continue;
      if (verdicts[i] == Verdict::contact) search.high = search.asked;
      else search.low = search.asked + 1;
      if (search.low < search.high) searches[left++] = search;
      else result.radius = std::bit_cast<Real>(search.low);
    }
    searches.resize(left);
  }
  return found;
}

template <class Real>
CriticalRadius<Real> critical_radius(const Implementation<Real>& kernel, const QueryWithRadius<Real>& query,
                                     const RadiusRange<Real>& range) {
  return critical_radii(kernel, std::vector{query}, range).front();
}

template <class Real>
Decimal6 radius_error_ulps(Real radius, Real from, const Rational& squared_distance) {
  if (radius == from) return {};
  return round_up(Rational(abs(exact(radius) - exact(from)) / exact(ulp_of(nearest_sqrt<Real>(squared_distance)))));
}

template <class Real>
std::optional<RadiusReversal<Real>> radius_reversal(const Implementation<Real>& kernel,
                                                    const QueryWithRadius<Real>& query, std::optional<Real> critical,
                                                    std::optional<Real> exact_radius) {
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

template <class Real>
RadiusRange<Real> radii_within(const Limits& limits) {
  constexpr Real max = std::numeric_limits<Real>::max(), infinity = std::numeric_limits<Real>::infinity();
  RadiusRange<Real> range;
  range.least = limits.least_radius > max ? infinity : static_cast<Real>(std::abs(limits.least_radius));
  if (range.least < limits.least_radius) range.least = std::nextafter(range.least, infinity);
  if (limits.greatest_radius == 0) return range;
  range.greatest = static_cast<Real>(std::min(limits.greatest_radius, double(max)));
  if (range.greatest > limits.greatest_radius) range.greatest = std::nextafter(range.greatest, Real(0));
  return range;
}

#define AXISCERT_INSTANTIATE(Real)                                                                         \
  template RadiusRange<Real> radii_within<Real>(const Limits&);                                            \
  template Real ulp_of(Real);                                                                              \
  template CriticalRadius<Real> critical_radius(const Implementation<Real>&, const QueryWithRadius<Real>&, \
                                                const RadiusRange<Real>&);                                 \
  template std::vector<CriticalRadius<Real>> critical_radii(                                               \
      const Implementation<Real>&, const std::vector<QueryWithRadius<Real>>&, const RadiusRange<Real>&);   \
  template Decimal6 radius_error_ulps(Real, Real, const Rational&);                                        \
  template std::optional<RadiusReversal<Real>> radius_reversal(                                            \
      const Implementation<Real>&, const QueryWithRadius<Real>&, std::optional<Real>, std::optional<Real>);
AXISCERT_INSTANTIATE(float)
AXISCERT_INSTANTIATE(double)
#undef AXISCERT_INSTANTIATE

}  // namespace axiscert

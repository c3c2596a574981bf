#include "exact/critical_radius.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace axiscert {

template <class Real>
std::optional<double> critical_radius_error(const Implementation<Real>& kernel, const Query<Real>& query,
                                            const Rational& squared_distance) {
  const Real distance = nearest_sqrt<Real>(squared_distance);
  if (!std::isfinite(distance)) return std::nullopt;
  using Bits = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;
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
  // Non-negative floats are ordered as their bits.
  Bits low = 0, high = std::bit_cast<Bits>(std::numeric_limits<Real>::max());
  if (!contact_at(high)) return std::numeric_limits<double>::infinity();
  while (low < high) {
    const Bits middle = low + (high - low) / 2;
    if (contact_at(middle)) high = middle;
    else low = middle + 1;
  }
  const Real greatest = std::numeric_limits<Real>::max();
  const Real ulp = distance == greatest ? distance - std::nextafter(distance, Real(0))
                                        : std::nextafter(distance, greatest) - distance;
  const Real critical = std::bit_cast<Real>(low);
  return Rational(abs(exact(critical) - exact(distance)) / exact(ulp)).get_d();
}
template std::optional<double> critical_radius_error<float>(const Implementation<float>&, const Query<float>&,
                                                            const Rational&);
template std::optional<double> critical_radius_error<double>(const Implementation<double>&, const Query<double>&,
                                                             const Rational&);

}  // namespace axiscert

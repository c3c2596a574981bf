#include "fuzz/certify/margin_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "fuzz/text/number_text.h"

namespace axiscert {
namespace {

constexpr int decade_of_nothing = -400;  // below that of every number

// The powers of ten from 10^-323, the least that is not rounded to 0, to the greatest, each to the nearest double.
constexpr int least_power = -323;
std::vector<double> powers_of_ten() {
  std::vector<double> powers;
  for (int e = least_power; e <= std::numeric_limits<double>::max_exponent10; ++e)
    powers.push_back(parse_number<double>(fmt::format("1e{}", e)));
  return powers;
}

// The exponent of a number's shortest decimal. Such a decimal is on the same side of 10^e as the number is of the
// double nearest to 10^e, or both are at it, since rounding is monotone. A size that is infinite belongs to the
// greatest decade.
int scene_decade(double size) {
  if (size == 0) return decade_of_nothing;
  static const std::vector<double> powers = powers_of_ten();
  const auto above = std::upper_bound(powers.begin(), powers.end(), size);
  return least_power - 1 + static_cast<int>(above - powers.begin());
}

}  // namespace

SceneMeasure::SceneMeasure(const Predicate& predicate)
    : oracles_(oracles_of(predicate)), columns_(predicate.entries[0].columns), centre_(columns_.size()) {
  const std::optional<CriticalLength> length = oracles_.critical_length();
  if (!length || !length->centre) return;
  for (const ColumnGroup& group : groups_of(predicate.entries[0])) {
    for (std::size_t k = 0; k < group.size && group.size == 3; ++k)
      if (columns_[group.first + k].role == Role::coordinate) centre_[group.first + k] = *length->centre + k;
  }
}

template <class Real>
double SceneMeasure::size(const Numbers<Real>& query) const {
  double size = 0;
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    double x = static_cast<double>(query[k]);
    if (centre_[k]) x -= static_cast<double>(query[*centre_[k]]);
    size = std::max(size, std::abs(x));
  }
  return size;
}
template double SceneMeasure::size(const Numbers<float>&) const;
template double SceneMeasure::size(const Numbers<double>&) const;

template <class Real>
MarginScene SceneMeasure::of(const Numbers<Real>& query) const {
  return {oracles_.is_degenerate(query), scene_decade(size(query))};
}
template MarginScene SceneMeasure::of(const Numbers<float>&) const;
template MarginScene SceneMeasure::of(const Numbers<double>&) const;

}  // namespace axiscert

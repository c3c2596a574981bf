#include "fuzz/shrink/query_size.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>

namespace axiscert {

BinaryDigits binary_digits(double x) {
  int exponent = 0;
  const double fraction = std::frexp(std::fabs(x), &exponent);
  const auto digits = static_cast<std::uint64_t>(std::ldexp(fraction, 53));
  const int zeros = std::countr_zero(digits);
  return {digits >> zeros, exponent - 53 + zeros};
}

namespace {

template <class Real>
QuerySize size_in(const Numbers<Real>& v) {
  QuerySize size;
  Numbers<Real> seen(v.size());
  for (std::size_t k = 0; k < v.size(); ++k) {
    size.negatives += std::signbit(v[k]);
    if (v[k] == 0) continue;
    const auto width = static_cast<int>(std::bit_width(binary_digits(v[k]).digits));
    size.bits += width;
    size.exponents += std::abs(std::ilogb(v[k]));
    size.places += static_cast<int>(k);
    const auto known = seen.begin() + size.magnitudes;
    if (std::find(seen.begin(), known, std::fabs(v[k])) == known) {
      *known = std::fabs(v[k]);
      ++size.magnitudes;
    }
    ++size.nonzero;
  }
  return size;
}

}  // namespace

QuerySize size_of(const Numbers<float>& q) { return size_in(q); }
QuerySize size_of(const Numbers<double>& q) { return size_in(q); }

}  // namespace axiscert

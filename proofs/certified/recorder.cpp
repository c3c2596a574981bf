#include "proofs/certified/recorder.h"

#include <bit>
#include <cmath>

namespace axiscert::proofs::certified {

template <>
float as_number<float>(Index node) {
  return std::bit_cast<float>(0x7fc00000u | node);
}
template <>
double as_number<double>(Index node) {
  return std::bit_cast<double>(0x7ff8000000000000ull | node);
}

template <class Real>
Index node_of(Real x) {
  if (!std::isnan(x)) return recorder->number(static_cast<double>(x));
  if constexpr (sizeof(Real) == 4) return std::bit_cast<std::uint32_t>(x) & 0x3fffffu;
  else return static_cast<Index>(std::bit_cast<std::uint64_t>(x));
}
template Index node_of<float>(float x);
template Index node_of<double>(double x);

}  // namespace axiscert::proofs::certified

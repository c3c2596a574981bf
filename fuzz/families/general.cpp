// Triangles and centres anywhere in a cube, any radius up to the cube's size: what a uniform fuzzer asks.
#include "fuzz/family.h"

namespace axiscert {
namespace {

template <class Real>
Query<Real> general(Stream& random, std::uint64_t) {
  std::array<Real, coordinate_count> v;
  for (Real& x : v) x = random.symmetric<Real>();
  v[12] = random.unit<Real>() * 2;
  return from_coordinates(v);
}

}  // namespace

extern const Family general_family = {
    "general",
    "uniform coordinates in [-1, 1), radius in [0, 2): finds nothing, and shows that it does",
    1,
    false,
    general<float>,
    general<double>};

}  // namespace axiscert

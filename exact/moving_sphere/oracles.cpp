#include "exact/moving_sphere/trait.h"
#include "exact/trait/oracles_of.h"

namespace axiscert {

template class OraclesOf<moving_sphere::MovingSphereTrait>;

const Oracles& moving_sphere_oracles(std::size_t) {
  static const OraclesOf<moving_sphere::MovingSphereTrait> oracles;
  return oracles;
}

}  // namespace axiscert

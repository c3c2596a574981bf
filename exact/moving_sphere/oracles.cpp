#include "exact/judge/oracles_of.h"
#include "exact/moving_sphere/trait.h"

namespace axiscert {

template class OraclesOf<moving_sphere::MovingSphereTrait>;
template class OraclesOf<moving_sphere::MovingEndsTrait>;

const Oracles& moving_sphere_oracles(std::size_t entry) {
  static const OraclesOf<moving_sphere::MovingSphereTrait> of_displacements;
  static const OraclesOf<moving_sphere::MovingEndsTrait> of_ends;
  if (entry == MovingEnds::entry) return of_ends;
  return of_displacements;
}

}  // namespace axiscert

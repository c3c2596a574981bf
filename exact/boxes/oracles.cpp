#include "exact/boxes/trait.h"
#include "exact/boxes/triangle_trait.h"
#include "exact/trait/oracles_of.h"

namespace axiscert {
template class OraclesOf<boxes::MatrixTrait>;
template class OraclesOf<boxes::QuaternionTrait>;

const Oracles& box_box_oracles(std::size_t entry) {
  static const OraclesOf<boxes::MatrixTrait> of_matrices;
  static const OraclesOf<boxes::QuaternionTrait> of_quaternions;
  if (entry == boxes::QuaternionBoxes::entry) return of_quaternions;
  return of_matrices;
}

template class OraclesOf<boxes::CentreTrait>;
template class OraclesOf<boxes::MinmaxTrait>;
template class OraclesOf<boxes::OrientedTrait>;

const Oracles& box_triangle_oracles(std::size_t entry) {
  static const OraclesOf<boxes::CentreTrait> of_centres;
  static const OraclesOf<boxes::MinmaxTrait> of_corners;
  static const OraclesOf<boxes::OrientedTrait> oriented;
  if (entry == boxes::MinmaxEntry::entry) return of_corners;
  if (entry == boxes::OrientedEntry::entry) return oriented;
  return of_centres;
}

}  // namespace axiscert

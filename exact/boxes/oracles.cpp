#include "exact/boxes/trait.h"
#include "exact/boxes/triangle_trait.h"
#include "exact/judge/oracles_of.h"

namespace axiscert {
template class OraclesOf<boxes::MatrixTrait>;
template class OraclesOf<boxes::QuaternionTrait>;
template class OraclesOf<boxes::MinmaxPairTrait>;
template class OraclesOf<boxes::MixedTrait>;

const Oracles& box_box_oracles(std::size_t entry) {
  static const OraclesOf<boxes::MatrixTrait> of_matrices;
  static const OraclesOf<boxes::QuaternionTrait> of_quaternions;
  static const OraclesOf<boxes::MinmaxPairTrait> of_corners;
  static const OraclesOf<boxes::MixedTrait> of_both;
  if (entry == boxes::QuaternionBoxes::entry) return of_quaternions;
  if (entry == boxes::MinmaxBoxes::entry) return of_corners;
  if (entry == boxes::MixedBoxes::entry) return of_both;
  return of_matrices;
}

template class OraclesOf<boxes::CentreTrait>;
template class OraclesOf<boxes::MinmaxTrait>;
template class OraclesOf<boxes::OrientedTrait>;
template class OraclesOf<boxes::TurnedTriangleTrait>;

const Oracles& box_triangle_oracles(std::size_t entry) {
  static const OraclesOf<boxes::CentreTrait> of_centres;
  static const OraclesOf<boxes::MinmaxTrait> of_corners;
  static const OraclesOf<boxes::OrientedTrait> oriented;
  static const OraclesOf<boxes::TurnedTriangleTrait> turned;
  if (entry == boxes::MinmaxEntry::entry) return of_corners;
  if (entry == boxes::OrientedEntry::entry) return oriented;
  if (entry == boxes::TurnedEntry::entry) return turned;
  return of_centres;
}

}  // namespace axiscert

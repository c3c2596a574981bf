#include "exact/boxes/trait.h"
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

}  // namespace axiscert

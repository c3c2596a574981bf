#include "exact/boxes/box_oracles.h"

#include "exact/boxes/trait.h"
#include "exact/trait/oracles_of.h"

namespace axiscert {

template class OraclesOf<boxes::MatrixTrait>;
template class OraclesOf<boxes::QuaternionTrait>;

namespace boxes {

const Oracles& matrix_oracles() {
  static const OraclesOf<MatrixTrait> oracles;
  return oracles;
}

const Oracles& quaternion_oracles() {
  static const OraclesOf<QuaternionTrait> oracles;
  return oracles;
}

}  // namespace boxes
}  // namespace axiscert

// FCL's obbDisjoint, the test of its bounding volumes, in double. The description applies to FCL 0.7.0: 1e-6 is added
// to the entries of |R| in double as in float, so that edges crossing at a small angle are in contact 2e-3 apart.
#include "kernel/peers/boxes/fcl_placed.h"

namespace axiscert::peer {
namespace {

struct FclObb {
  using Real = double;

  int operator()(const Boxes<double>& q) const {
    const fcl::Matrix3<double> a = fcl_rotation(q.a), relative = a.transpose() * fcl_rotation(q.b);
    const fcl::Vector3<double> between = a.transpose() * (fcl_vector(q.b.centre) - fcl_vector(q.a.centre));
    return verdict_of(!fcl::obbDisjoint<double>(relative, between, fcl_vector(q.a.half), fcl_vector(q.b.half)));
  }
};

}  // namespace
}  // namespace axiscert::peer

const axiscert_kernel* axiscert_plugin(std::uint32_t index) {
  return axiscert::peer::boxes_kernel<axiscert::peer::FclObb>(
      index, {"fcl-obb", "FCL's obbDisjoint, double", AXISCERT_TOUCHING_IS_EITHER, AXISCERT_SOURCE});
}

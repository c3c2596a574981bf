// FCL's continuousCollide by conservative advancement, on a mesh with bounding volumes of the type OBBRSS. Tracker: fcl
// 120, 555.
#include "kernel/peers/moving_sphere/fcl_motion.h"

const axiscert_kernel* axiscert_plugin(std::uint32_t index) {
  using Motion = axiscert::peer::FclMotion<fcl::OBBRSS<double>, fcl::CCDC_CONSERVATIVE_ADVANCEMENT>;
  return axiscert::peer::sweep_kernel<Motion>(
      index, {"fcl-advance-obbrss", "FCL's continuousCollide by conservative advancement, OBBRSS, double",
              AXISCERT_TOUCHING_IS_EITHER, AXISCERT_SOURCE});
}

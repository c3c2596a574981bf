// FCL's continuousCollide by conservative advancement, on a mesh with bounding volumes of the type RSS. Tracker: fcl
// 120, 555.
#include "kernel/peers/moving_sphere/fcl_motion.h"

const axiscert_kernel* axiscert_plugin(std::uint32_t index) {
  using Motion = axiscert::peer::FclMotion<fcl::RSS<double>, fcl::CCDC_CONSERVATIVE_ADVANCEMENT>;
  return axiscert::peer::sweep_kernel<Motion>(
      index, {"fcl-advance-rss", "FCL's continuousCollide by conservative advancement, RSS, double",
              AXISCERT_TOUCHING_IS_EITHER, AXISCERT_SOURCE});
}

// FCL's continuousCollide as it is by default: it asks whether the two overlap at ten times, 0, 1/9, ..., 1, so it
// misses what happens between two of them, and a hit is late by up to a ninth of the motion.
#include "kernel/peers/moving_sphere/fcl_motion.h"

const axiscert_kernel* axiscert_plugin(std::uint32_t index) {
  using Motion = axiscert::peer::FclMotion<fcl::OBBRSS<double>, fcl::CCDC_NAIVE>;
  return axiscert::peer::sweep_kernel<Motion>(index, {"fcl-continuous", "FCL's continuousCollide as by default, double",
                                                      AXISCERT_TOUCHING_IS_EITHER, AXISCERT_SOURCE});
}

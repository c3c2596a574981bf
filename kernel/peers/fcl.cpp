// FCL in double, its default. Its behaviour and faults are described in fcl_detector.h.
#include "kernel/peers/fcl_detector.h"

const axiscert_kernel* axiscert_plugin(std::uint32_t index) {
  using Detector = axiscert::peer::FclDetector<double>;
  return axiscert::peer::kernel<Detector>(
      index, {"fcl", "FCL's sphereTriangleIntersect<double>", Detector::touching, AXISCERT_SOURCE});
}

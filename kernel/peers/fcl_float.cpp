// FCL's templates over float. Their behaviour and faults are described in fcl_detector.h.
#include "kernel/peers/fcl_detector.h"

const axiscert_kernel* axiscert_plugin(std::uint32_t index) {
  using Detector = axiscert::peer::FclDetector<float>;
  return axiscert::peer::kernel<Detector>(
      index, {"fcl-float", "FCL's sphereTriangleIntersect<float>", Detector::touching, AXISCERT_SOURCE});
}

// FCL's templates over float. What they do and get wrong: fcl_detector.h.
#include "kernel/peers/fcl_detector.h"

const axiscert_kernel* axiscert_plugin(std::uint32_t index) {
  using Detector = axiscert::peer::FclDetector<float>;
  return axiscert::peer::kernel<Detector>(
      index, {"fcl-float", "FCL's sphereTriangleIntersect<float>", Detector::touching, AXISCERT_SOURCE});
}

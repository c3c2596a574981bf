#include "kernel/moving_sphere/advance.h"
#include "kernel/moving_sphere/rounded.h"
#include "kernel/moving_sphere/segment.h"
#include "kernel/moving_sphere/twenty.h"

namespace axiscert {

std::vector<Kernel> moving_sphere_kernels() {
  using namespace moving_sphere;
  return {
      plain_kernel<MovingSphere, Twenty>("moving-sphere/twenty", "the sphere against the prism of the motion: 20 axes"),
      plain_kernel<MovingSphere, TwentyNonstrict>(
          "moving-sphere/twenty-nonstrict", "the same with >= in the sides: over the reals right for every query"),
      plain_verdict_kernel<MovingSphere, Rounded>(
          "moving-sphere/rounded", "the centre's path against face, cylinders and spheres, by roots of quadratics"),
      plain_verdict_kernel<MovingSphere, Segment>("moving-sphere/segment",
                                                  "the distance of the centre's path, a segment, from the triangle"),
      plain_verdict_kernel<MovingSphere, Advance<true>>(
          "moving-sphere/advance", "conservative advancement by the speed along the nearest direction, 32 steps"),
      plain_verdict_kernel<MovingSphere, Advance<false>>("moving-sphere/advance-by-length",
                                                         "the same by |D|, which takes more steps"),
  };
}

}  // namespace axiscert

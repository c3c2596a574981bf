// Wild Magic's sweep in float. Its faults are in sweep_faults_test.cpp.
#include "kernel/peers/moving_sphere/wildmagic.h"

const axiscert_kernel* axiscert_plugin(std::uint32_t index) {
  return axiscert::peer::sweep_kernel<axiscert::peer::WildMagicSweep<float>>(
      index, {"wildmagic-float", "Wild Magic's IntrTriangle3Sphere3<float>::Find, of Geometric Tools",
              AXISCERT_TOUCHING_IS_EITHER, AXISCERT_SOURCE});
}

// The twenty axes for kernel/permitted.
#include "kernel/moving_sphere/twenty.h"
#include "kernel/permitted/recording.h"

namespace axiscert::permitted {

Recorder moving_sphere_recorder(const Kernel& kernel) {
  Recorder found;
  put_recorder<MovingSphere, portable::Twenty>(kernel, found);
  put_recorder<MovingSphere, portable::TwentyNonstrict>(kernel, found);
  put_recorder<MovingEnds, portable::Twenty>(kernel, found);
  put_recorder<MovingEnds, portable::TwentyNonstrict>(kernel, found);
  return found;
}

}  // namespace axiscert::permitted

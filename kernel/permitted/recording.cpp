#include "kernel/permitted/recording.h"

namespace axiscert::permitted {

Recorder recorder_of(const Kernel& kernel) {
  for (const auto room : {sphere_triangle_recorder, moving_sphere_recorder, box_box_recorder}) {
    if (const Recorder found = room(kernel)) return found;
  }
  return {};
}

}  // namespace axiscert::permitted

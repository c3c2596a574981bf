// The fifteen axes of two boxes for kernel/permitted.
#include "kernel/boxes/projected.h"
#include "kernel/boxes/relative.h"
#include "kernel/permitted/recording.h"

namespace axiscert::permitted {

Recorder box_box_recorder(const Kernel& kernel) {
  Recorder found;
  put_recorder<boxes::MatrixBoxes, boxes::ProjectedFifteen>(kernel, found);
  put_recorder<boxes::MatrixBoxes, boxes::Textbook>(kernel, found);
  put_recorder<boxes::MatrixBoxes, boxes::Cofactor>(kernel, found);
  return found;
}

}  // namespace axiscert::permitted

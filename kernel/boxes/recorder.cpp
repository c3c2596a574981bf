// The axes of two boxes, and of a box and a triangle, for kernel/permitted.
#include "kernel/boxes/projected.h"
#include "kernel/boxes/relative.h"
#include "kernel/boxes/thirteen.h"
#include "kernel/permitted/recording.h"

namespace axiscert::permitted {

Recorder box_recorder(const Kernel& kernel) {
  Recorder found;
  put_recorder<boxes::MatrixBoxes, boxes::ProjectedFifteen>(kernel, found);
  put_recorder<boxes::MatrixBoxes, boxes::Textbook>(kernel, found);
  put_recorder<boxes::MatrixBoxes, boxes::Cofactor>(kernel, found);
  put_recorder<boxes::CentreEntry, boxes::TextbookThirteen>(kernel, found);
  put_recorder<boxes::CentreEntry, boxes::Thirteen>(kernel, found);
  put_recorder<boxes::MinmaxEntry, boxes::TextbookThirteen>(kernel, found);
  put_recorder<boxes::MinmaxEntry, boxes::Thirteen>(kernel, found);
  put_recorder<boxes::OrientedEntry, boxes::FramedThirteen>(kernel, found);
  put_recorder<boxes::OrientedEntry, boxes::Thirteen>(kernel, found);
  return found;
}

}  // namespace axiscert::permitted

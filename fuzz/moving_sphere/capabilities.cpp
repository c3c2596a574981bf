#include "fuzz/queries/capabilities.h"

namespace axiscert {

const Capabilities& moving_sphere_capabilities() {
  static const Capabilities all = {.moved_entries = {0}};  // the ends of a motion are not moved yet
  return all;
}

}  // namespace axiscert

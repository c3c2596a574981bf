#include "fuzz/queries/capabilities.h"

namespace axiscert {

const Capabilities& box_box_capabilities() {
  static const Capabilities all = {.moved_entries = {0, 1}};
  return all;
}

const Capabilities& box_triangle_capabilities() {
  static const Capabilities all = {.moved_entries = {0, 1, 2}};
  return all;
}

}  // namespace axiscert

// The host's arrays between guard pages, and the handler that says which of them a fault was at.
#pragma once

#include "kernel/plugin/shared_memory.h"

namespace axiscert::plugin {

// Area k lies at reserved + page + k * (area size + page): a page that cannot be touched on both sides of each.
struct Arrays {
  std::byte* reserved = nullptr;
  std::size_t page = 0, area_bytes = 0;
  struct {
    Placement placement;
    std::size_t size, real_size;
  } placed = {};  // of the call under way

  std::size_t slot() const { return area_bytes + page; }
  std::byte* area(std::size_t array) const { return reserved + page + array * slot(); }
  std::byte* first(std::size_t array) const {
    const std::size_t element = element_size(array, placed.real_size);
    return area(array) + array_offset(placed.placement, placed.size, element, area_bytes);
  }
};

// From here on a signal that kills the process says in `fault` what it was about, then kills it. Both are to outlive
// it.
void watch_for_faults(const Arrays& arrays, Fault& fault);

}  // namespace axiscert::plugin

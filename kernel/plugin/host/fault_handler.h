// The host's arrays between guard pages, and the handler that says which of them a fault was at.
#pragma once

#include "kernel/plugin/shared_memory.h"

namespace axiscert::plugin {

// The bytes on both sides of each area that cannot be touched: address space, no memory. A write that goes astray by
// less than that cannot reach another array.
inline constexpr std::size_t guard = std::size_t{16} << 20;

// Area k lies at reserved + guard + k * (area size + guard).
struct Arrays {
  Shape shape = {};
  std::byte* reserved = nullptr;
  std::size_t area_bytes = 0;
  struct {
    Placement placement;
    std::size_t size;
    std::size_t real;  // bytes of a number
  } placed = {};       // of the call under way

  std::size_t slot() const { return area_bytes + guard; }
  std::byte* area(std::size_t array) const { return reserved + guard + array * slot(); }
  std::byte* first(std::size_t array) const {
    return area(array) +
           array_offset(placed.placement, placed.size, entry_bytes(shape, array, placed.real), area_bytes);
  }
};

// From here on a signal that kills the process says in `fault` what it was about, then kills it. Both are to outlive
// it.
void watch_for_faults(const Arrays& arrays, Fault& fault);

}  // namespace axiscert::plugin

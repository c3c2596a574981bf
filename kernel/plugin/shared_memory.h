// What axiscert and the process that hosts a plug-in share: one memory file, and short messages over a socket.
//
// The file holds a control block and an area for every array of plugin.h. The host maps each area between pages that
// cannot be touched, the input ones read-only; axiscert maps the file as it is.
#pragma once

#include <cstddef>
#include <cstdint>

#include "kernel/names.h"
#include "kernel/query.h"

namespace axiscert::plugin {

inline constexpr int socket_fd = 3, memory_fd = 4;   // in the host
inline constexpr std::size_t batch_capacity = 1024;  // queries a call

// The arrays, in this order: the coordinates, verdict, comparisons, the left sides, the right sides.
inline constexpr std::size_t verdict_array = coordinate_count;
inline constexpr std::size_t comparisons_array = verdict_array + 1;
inline constexpr std::size_t lhs_array = comparisons_array + 1;
inline constexpr std::size_t rhs_array = lhs_array + comparison_count;
inline constexpr std::size_t array_count = rhs_array + comparison_count;

constexpr std::size_t element_size(std::size_t array, std::size_t real_size) {
  return array == verdict_array ? 1 : array == comparisons_array ? 2 : real_size;
}

// Where in its area each array of a call lies. At an end it is flush with the guard pages, so that one step beyond is
// caught at once; in the middle, `room` bytes are free on both sides. `shift` moves it up by so many elements.
enum class Anchor : std::uint32_t { begin, middle, end };
struct Placement {
  Anchor anchor = Anchor::end;
  std::uint32_t shift = 0;  // elements, at most 16; 0 at the end
};
inline constexpr std::size_t room = 1024;
constexpr std::size_t area_size(std::size_t page) {
  const std::size_t least = batch_capacity * sizeof(double) + 2 * room;
  return (least + page - 1) / page * page;
}
// In bytes from the area's begin.
constexpr std::size_t array_offset(Placement placement, std::size_t entries, std::size_t element, std::size_t area) {
  const std::size_t shift = placement.shift * element;
  switch (placement.anchor) {
    case Anchor::begin:
      return shift;
    case Anchor::middle:
      return room / 2 + shift;
    case Anchor::end:
      break;
  }
  return area - entries * element;
}

// One kernel of the plug-in, in the words of plugin.h; texts cut to fit.
struct Description {
  std::uint32_t abi, precision, exposes, touching;
  double limits[5];  // in the order of axiscert_limits
  char name[128], summary[256], conforms_to[64], formulae[64];
  bool has_run, has_conforms_to, has_formulae, is_truncated;
};
inline constexpr std::size_t most_kernels = 2;

enum class Access : std::uint8_t { unknown, read, write };

// Written by the host's signal handler.
struct Fault {
  std::int32_t signal;  // 0: none
  bool at_null, out_of_stack, in_arrays;
  Access access;
  std::uint32_t array;   // of in_arrays
  std::int64_t element;  // relative to the array's first
  std::uint64_t element_count;
};

struct Control {
  char load_error[512];        // empty where the plug-in was loaded
  std::uint32_t changed;       // floating-point modes that loading it left changed
  std::uint32_t kernel_count;  // as handed out, at most most_kernels + 1
  Description kernels[most_kernels];
  Fault fault;
};

struct Request {
  std::uint32_t kernel;  // of Control::kernels
  std::uint32_t size;
  std::uint32_t exposes;  // which arrays are asked for
  Placement placement;
};

// Floating-point modes that a call left changed.
inline constexpr std::uint32_t changed_rounding = 1, changed_flushing = 2, changed_traps = 4, changed_other = 8;

struct Reply {
  std::uint32_t changed;
  std::uint64_t nanoseconds;  // the call took
};

inline constexpr std::size_t file_size(std::size_t page) {
  return (sizeof(Control) + page - 1) / page * page + array_count * area_size(page);
}
inline constexpr std::size_t area_in_file(std::size_t array, std::size_t page) {
  return (sizeof(Control) + page - 1) / page * page + array * area_size(page);
}

}  // namespace axiscert::plugin

// The memory that axiscert shares with the process that hosts a plug-in or a program, and the short messages between
// them.
//
// The file holds a control block and an area for each array of plugin.h that the predicate and entry have. The host
// maps each area between pages that cannot be touched, the input ones read-only; axiscert maps the file as it is.
#pragma once

#include <cstddef>
#include <cstdint>

namespace axiscert::plugin {

inline constexpr int socket_fd = 3, memory_fd = 4;   // in the host
inline constexpr std::size_t batch_capacity = 1024;  // queries a call

// The number of arrays of each kind, in this order: the columns, verdict, comparisons, the left sides, the right sides,
// the measures.
struct Shape {
  std::size_t columns = 0, comparisons = 0, measures = 0;  // at most 64 each

  constexpr std::size_t verdict() const { return columns; }
  constexpr std::size_t bits() const { return columns + 1; }
  constexpr std::size_t lhs() const { return columns + 2; }
  constexpr std::size_t rhs() const { return lhs() + comparisons; }
  constexpr std::size_t measure() const { return rhs() + comparisons; }
  constexpr std::size_t arrays() const { return measure() + measures; }
};

// The size of one element of an array, in bytes; `real` is that of a number of the kernel's precision.
constexpr std::size_t entry_bytes(const Shape& shape, std::size_t array, std::size_t real) {
  return array == shape.verdict() ? sizeof(std::uint8_t) : array == shape.bits() ? sizeof(std::uint64_t) : real;
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
  std::uint32_t start, still, sides, may_decline;
  std::size_t size, least_size, limits_size, least_limits_size;  // bytes, as declared and as needed
  std::size_t column_count, measure_count;
  double limits[6];  // in the order of axiscert_limits
  char name[128], summary[256], predicate[64], entry[64], conforms_to[64], formulae[64];
  char source[512];  // the end of a longer one
  bool has_run, has_limits, has_conforms_to, has_formulae, is_truncated;
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

// For a program: the bytes before the queries of each batch (pipe_format.h), with a count of 0.
inline constexpr std::size_t longest_program_header = 1024;
struct ProgramHeader {
  std::uint32_t size;      // bytes; 0: it does not exist in this precision
  std::uint32_t measures;  // numbers that follow each reply
  char bytes[longest_program_header];
};

// Why a program gave no answers.
struct ProgramStop {
  std::uint8_t kind;      // a FindingKind
  std::uint32_t replies;  // that came before, each of them whole
  char detail[512];
};

struct Control {
  // Written by axiscert, for a program; binary32, binary64.
  ProgramHeader headers[most_kernels];
  ProgramStop stop;            // of a reply that says `stopped`
  char load_error[512];        // empty where the plug-in was loaded
  std::uint32_t changed;       // floating-point modes that loading it left changed
  std::uint32_t kernel_count;  // as handed out, at most most_kernels + 1
  Description kernels[most_kernels];
  Fault fault;
};

struct Request {
  std::uint32_t kernel;    // of Control::kernels; of a program, of Control::headers
  std::uint32_t size;      // queries; 0, of a program alone: it is started, and ended
  std::uint32_t exposes;   // which arrays are asked for
  std::uint32_t measures;  // number of measures that are asked for
  Placement placement;
  // For a program: the processor time that it may take for the answers, and in addition for a start. By the clock it
  // may take clock_to_processor times as much.
  double seconds = 0, start_seconds = 0;
};
inline constexpr double clock_to_processor = 20;  // for one that does not get, or use, a core
inline constexpr double program_start = 10;       // whole batches' time: an interpreter, and an engine to compile

// Floating-point modes that a call left changed.
inline constexpr std::uint32_t changed_rounding = 1, changed_flushing = 2, changed_traps = 4, changed_other = 8;

struct Reply {
  std::uint32_t changed;
  std::uint64_t nanoseconds;  // the call took
  bool stopped;               // of a program: it gave no answers; Control::stop says why
};

constexpr std::size_t area_in_file(std::size_t array, std::size_t page) {
  return (sizeof(Control) + page - 1) / page * page + array * area_size(page);
}
constexpr std::size_t file_size(const Shape& shape, std::size_t page) { return area_in_file(shape.arrays(), page); }

}  // namespace axiscert::plugin

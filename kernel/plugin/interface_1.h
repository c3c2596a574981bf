// Version 1 of the plug-in interface: the layout of plug-ins that were built for it. The host calls them by it, and
// reads their description into the structs of version 2.
#pragma once

#include <cstddef>
#include <cstdint>

namespace axiscert::plugin::interface_1 {

inline constexpr std::uint32_t number = 1;
// Version 1 has one predicate, sphere-triangle, in one entry.
inline constexpr std::size_t column_count = 13, comparison_count = 16;

struct Batch {
  std::size_t size;  // queries
  const void* coordinate[column_count];
};

struct Answers {
  std::uint8_t* verdict;
  std::uint16_t* comparisons;
  void* lhs[comparison_count];
  void* rhs[comparison_count];
  // Reserved: null.
  void* distance;
  void* closest_point[3];
  void* normal[3];
  std::uint8_t* feature;
};

struct Limits {
  double least_coordinate, greatest_coordinate, least_area, least_radius, greatest_radius;
};

struct Kernel {
  std::uint32_t abi, precision;
  const char* name;
  void (*run)(const Batch* batch, const Answers* answers);
  const char* summary;
  std::uint32_t exposes, touching;
  const char* conforms_to;
  const char* formulae;
  Limits limits;
  const void* reserved[4];
};

}  // namespace axiscert::plugin::interface_1

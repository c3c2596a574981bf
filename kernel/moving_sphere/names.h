// The comparisons of the twenty axes of a moving sphere, in their order. Clause and kind of each follow from its name.
#pragma once

#include <array>
#include <string_view>

#include "kernel/names.h"

namespace axiscert::moving_sphere {

// The seven axes of a sphere that stands still, at one end of the motion; the sweep's six follow.
#define AXISCERT_STILL_AXES(moment)                                                                                \
  moment ".plane.radius", moment ".plane.heading", moment ".vertex_a.radius", moment ".vertex_a.side_b",           \
      moment ".vertex_a.side_c", moment ".vertex_a.heading", moment ".vertex_b.radius", moment ".vertex_b.side_a", \
      moment ".vertex_b.side_c", moment ".vertex_b.heading", moment ".vertex_c.radius", moment ".vertex_c.side_a", \
      moment ".vertex_c.side_b", moment ".vertex_c.heading", moment ".edge_ab.radius", moment ".edge_ab.side_c",   \
      moment ".edge_ab.heading", moment ".edge_bc.radius", moment ".edge_bc.side_a", moment ".edge_bc.heading",    \
      moment ".edge_ca.radius", moment ".edge_ca.side_b", moment ".edge_ca.heading"

// clang-format off
inline constexpr std::array<std::string_view, 61> comparison_names = {
    AXISCERT_STILL_AXES("start"),
    AXISCERT_STILL_AXES("end"),
    "sweep.vertex_a.radius", "sweep.vertex_a.side_b", "sweep.vertex_a.side_c",
    "sweep.vertex_b.radius", "sweep.vertex_b.side_a", "sweep.vertex_b.side_c",
    "sweep.vertex_c.radius", "sweep.vertex_c.side_a", "sweep.vertex_c.side_b",
    "sweep.edge_ab.radius", "sweep.edge_ab.side",
    "sweep.edge_bc.radius", "sweep.edge_bc.side",
    "sweep.edge_ca.radius", "sweep.edge_ca.side",
};
// clang-format on
#undef AXISCERT_STILL_AXES

// Where the comparisons of each moment begin.
inline constexpr std::size_t start_axes = 0, end_axes = 23, sweep_axes = 46;

constexpr std::string_view clause_name(std::size_t comparison) {
  const std::string_view name = comparison_names[comparison];
  return name.substr(0, name.rfind('.'));
}
constexpr bool is_radius(std::size_t comparison) { return comparison_names[comparison].ends_with(".radius"); }

// Bits of the comparisons that are no radius: sides and headings.
inline constexpr ComparisonBits side_bits = [] {
  ComparisonBits bits = 0;
  for (std::size_t i = 0; i < comparison_names.size(); ++i) {
    if (!is_radius(i)) bits |= one_bit<ComparisonBits>(i);
  }
  return bits;
}();

// Bits of the headings.
inline constexpr ComparisonBits heading_bits = [] {
  ComparisonBits bits = 0;
  for (std::size_t i = 0; i < comparison_names.size(); ++i) {
    if (comparison_names[i].ends_with(".heading")) bits |= one_bit<ComparisonBits>(i);
  }
  return bits;
}();

// Bits of each axis: a radius and what follows it.
inline constexpr std::array<ComparisonBits, 20> clause_bits = [] {
  std::array<ComparisonBits, 20> bits{};
  std::size_t clause = 0;
  for (std::size_t i = 0; i < comparison_names.size(); ++i) {
    if (i > 0 && is_radius(i)) ++clause;
    bits[clause] |= one_bit<ComparisonBits>(i);
  }
  return bits;
}();

// Where the measures of each kind begin among the predicate's: a time, a feature, a normal of three and a point of
// three.
inline constexpr std::size_t time_measure = 0, feature_measure = 1, normal_measure = 2, point_measure = 5,
                             measure_count = 8;

}  // namespace axiscert::moving_sphere

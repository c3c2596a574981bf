// The vocabulary of sphere-triangle: seven axes, sixteen comparisons. Every name that a report shows is defined here,
// once.
#pragma once

#include "kernel/names.h"

namespace axiscert {

enum class Axis : std::uint8_t { plane, vertex_a, vertex_b, vertex_c, edge_ab, edge_bc, edge_ca };
template <>
inline constexpr std::size_t enum_count<Axis> = 7;
inline constexpr std::size_t axis_count = enum_count<Axis>;
inline constexpr EnumArray<Axis, std::string_view> axis_names = {"plane",   "vertex_a", "vertex_b", "vertex_c",
                                                                 "edge_ab", "edge_bc",  "edge_ca"};

// A comparison `lhs > rhs`. `vertex_a_side_b`: B lies beyond the plane through A with normal A - P.
// clang-format off
enum class Comparison : std::uint8_t {
  plane_radius,
  vertex_a_radius, vertex_a_side_b, vertex_a_side_c,
  vertex_b_radius, vertex_b_side_a, vertex_b_side_c,
  vertex_c_radius, vertex_c_side_a, vertex_c_side_b,
  edge_ab_radius, edge_ab_side_c,
  edge_bc_radius, edge_bc_side_a,
  edge_ca_radius, edge_ca_side_b,
};
// clang-format on
template <>
inline constexpr std::size_t enum_count<Comparison> = 16;
inline constexpr std::size_t comparison_count = enum_count<Comparison>;

struct ComparisonInfo {
  std::string_view name;
  Axis axis;
  bool is_radius;  // seven comparisons are; the other nine are side comparisons
};
inline constexpr EnumArray<Comparison, ComparisonInfo> comparisons = {{
    {"plane.radius", Axis::plane, true},
    {"vertex_a.radius", Axis::vertex_a, true},
    {"vertex_a.side_b", Axis::vertex_a, false},
    {"vertex_a.side_c", Axis::vertex_a, false},
    {"vertex_b.radius", Axis::vertex_b, true},
    {"vertex_b.side_a", Axis::vertex_b, false},
    {"vertex_b.side_c", Axis::vertex_b, false},
    {"vertex_c.radius", Axis::vertex_c, true},
    {"vertex_c.side_a", Axis::vertex_c, false},
    {"vertex_c.side_b", Axis::vertex_c, false},
    {"edge_ab.radius", Axis::edge_ab, true},
    {"edge_ab.side_c", Axis::edge_ab, false},
    {"edge_bc.radius", Axis::edge_bc, true},
    {"edge_bc.side_a", Axis::edge_bc, false},
    {"edge_ca.radius", Axis::edge_ca, true},
    {"edge_ca.side_b", Axis::edge_ca, false},
}};
constexpr const ComparisonInfo& info(Comparison c) { return comparisons[c]; }
constexpr std::string_view name(Comparison c) { return info(c).name; }

// Bit i is comparison i, or axis i: the bits of kernel/names.h in as few bytes as sixteen and seven take, where
// millions are kept.
using SignBits = std::uint16_t;
using AxisBits = std::uint8_t;

// For each axis, the comparisons that must all hold for it to separate.
inline constexpr EnumArray<Axis, ComparisonBits> axis_comparisons = [] {
  EnumArray<Axis, ComparisonBits> bits{};
  for (const Comparison c : enumerators<Comparison>) bits[info(c).axis] |= one_bit<ComparisonBits>(c);
  return bits;
}();
constexpr ComparisonBits comparisons_of(Axis axis) { return axis_comparisons[axis]; }

inline constexpr ComparisonBits side_comparisons = [] {
  ComparisonBits bits = 0;
  for (const Comparison c : enumerators<Comparison>) {
    if (!info(c).is_radius) bits |= one_bit<ComparisonBits>(c);
  }
  return bits;
}();

constexpr bool is_radius(Comparison c) { return !has_bit(side_comparisons, c); }

// Those that are lhs >= rhs.
constexpr ComparisonBits nonstrict_comparisons(Strictness strictness) {
  return strictness == Strictness::strict ? 0 : side_comparisons;
}

constexpr AxisBits axes_of(ComparisonBits bits) {
  AxisBits axes = 0;
  for (std::size_t i = 0; i < axis_count; ++i) {
    if ((bits & axis_comparisons[i]) == axis_comparisons[i]) axes |= one_bit<AxisBits>(i);
  }
  return axes;
}

// One separating axis suffices.
constexpr Verdict verdict_of(AxisBits axes) { return axes != 0 ? Verdict::separated : Verdict::contact; }

template <Strictness strictness, class T>
constexpr bool holds(Comparison which, const T& lhs, const T& rhs) {
  if (strictness == Strictness::strict || info(which).is_radius) return lhs > rhs;
  return strictness == Strictness::nonstrict ? lhs >= rhs : !(rhs > lhs);
}
template <class T>
constexpr bool holds(Strictness strictness, Comparison which, const T& lhs, const T& rhs) {
  switch (strictness) {
    case Strictness::strict:
      return holds<Strictness::strict>(which, lhs, rhs);
    case Strictness::nonstrict:
      return holds<Strictness::nonstrict>(which, lhs, rhs);
    case Strictness::not_less:
      return holds<Strictness::not_less>(which, lhs, rhs);
  }
  return false;
}

}  // namespace axiscert

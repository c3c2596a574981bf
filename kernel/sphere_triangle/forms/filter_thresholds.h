// The thresholds of the filter that is proved never to lie (docs/proofs.md). Written by
// proofs/write_thresholds.py out of the Coq theory: do not edit.
#pragma once

#include <array>

#include "kernel/sphere_triangle/names.h"

// clang-format off
namespace axiscert::filter {

// A comparison's sides are of this degree in the coordinates; lhs > rhs is certain where lhs - rhs, as computed, exceeds
// n u m^degree, as computed: u = 2^-24 or 2^-53, m the greatest magnitude of a translated coordinate or the radius.
struct Threshold {
  int n, degree;
};
// By comparison. The same for both precisions, with fused multiply-adds or without.
inline constexpr std::array<Threshold, comparison_count> published_thresholds = {{
    {2642, 6},  // plane.radius
    {16, 2},    // vertex_a.radius
    {29, 2},    // vertex_a.side_b
    {29, 2},    // vertex_a.side_c
    {16, 2},    // vertex_b.radius
    {29, 2},    // vertex_b.side_a
    {29, 2},    // vertex_b.side_c
    {16, 2},    // vertex_c.radius
    {29, 2},    // vertex_c.side_a
    {29, 2},    // vertex_c.side_b
    {13240, 6}, // edge_ab.radius
    {22412, 6}, // edge_ab.side_c
    {13240, 6}, // edge_bc.radius
    {22412, 6}, // edge_bc.side_a
    {13240, 6}, // edge_ca.radius
    {22412, 6}, // edge_ca.side_b
}};
inline constexpr std::array<Threshold, comparison_count> reduced_thresholds = {{
    {2642, 6},  // plane.radius
    {16, 2},    // vertex_a.radius
    {29, 2},    // vertex_a.side_b
    {29, 2},    // vertex_a.side_c
    {16, 2},    // vertex_b.radius
    {29, 2},    // vertex_b.side_a
    {29, 2},    // vertex_b.side_c
    {16, 2},    // vertex_c.radius
    {29, 2},    // vertex_c.side_a
    {29, 2},    // vertex_c.side_b
    {233, 4},   // edge_ab.radius
    {425, 4},   // edge_ab.side_c
    {233, 4},   // edge_bc.radius
    {425, 4},   // edge_bc.side_a
    {233, 4},   // edge_ca.radius
    {425, 4},   // edge_ca.side_b
}};

// The window of m, inclusive: inside it nothing overflows, and underflow is part of the thresholds.
template <class Real>
inline constexpr Real least_magnitude =
    sizeof(Real) == 4 ? static_cast<Real>(0x1p-19) : static_cast<Real>(0x1p-168);
template <class Real>
inline constexpr Real greatest_magnitude =
    sizeof(Real) == 4 ? static_cast<Real>(0x1p19) : static_cast<Real>(0x1p168);

}  // namespace axiscert::filter
// clang-format on

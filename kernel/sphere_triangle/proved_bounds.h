// Proved bounds on |(computed lhs - computed rhs) - (lhs - rhs)|, in u/16. Written by write_proofs: do not edit.
#pragma once

#include <array>

#include "kernel/sphere_triangle/names.h"

namespace axiscert {

// Where every exact coordinate of A - P, B - P and C - P is in [-1, 1] and r in [0, 1]; in either precision, subnormal
// numbers included. By set of formulae (published, reduced) and contraction (plain, fma): [2 * formulae + contraction].
// clang-format off
inline constexpr std::array<std::array<int, comparison_count>, 4> proved_sixteenths = {{
    // published, plain
    {21761, 128, 240, 240, 128, 240, 240, 128, 240, 240, 74837, 132161, 74837, 132161, 74837, 132161},
    // published, fma
    {18689, 112, 208, 208, 112, 208, 208, 112, 208, 208, 67705, 119260, 67705, 119260, 67705, 119260},
    // reduced, plain
    {21761, 128, 240, 240, 128, 240, 240, 128, 240, 240, 1761, 3073, 1761, 3073, 1761, 3073},
    // reduced, fma
    {18689, 112, 208, 208, 112, 208, 208, 112, 208, 208, 1569, 2593, 1569, 2593, 1569, 2593},
}};
// clang-format on

}  // namespace axiscert

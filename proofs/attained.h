// The greatest errors, in u, that searches attained on the scaled domain; the bounds are compared with them. Each was
// found by `axiscert search --kernel K --precision binary32` with the options in the row.
#pragma once

#include <array>
#include <string_view>

#include "proofs/bounds.h"

namespace axiscert::proofs {

struct Attained {
  std::string_view kernel;
  Kind kind;
  double u;
  std::string_view search;
};
inline constexpr auto attained_errors = std::to_array<Attained>({
    {"published", Kind::plane_radius, 367.6, "--evaluations 63438848 --seed 1"},
    {"published", Kind::vertex_radius, 7.982, "--evaluations 63438848 --seed 1"},
    {"published", Kind::vertex_side, 14.81, "--evaluations 63438848 --seed 1"},
    {"published", Kind::edge_radius, 1129, "--evaluations 63438848 --seed 1"},
    {"published", Kind::edge_side, 2031, "--evaluations 63438848 --seed 1"},
    {"reduced", Kind::edge_radius, 65.3, "--comparison edge_ab.radius --evaluations 30051328 --seed 2"},
    {"reduced", Kind::edge_side, 91.32, "--comparison edge_ab.side_c --evaluations 30051328 --seed 2"},
});

}  // namespace axiscert::proofs

// The greatest errors, in u, that searches attained on the scaled domain, rounded down; the bounds are compared with
// them. Each was found by `axiscert search --kernel K --precision binary32` with the options in the row; its query is
// in proofs/attained.jsonl, from which proofs/tests/attained_test.py computes it again.
#pragma once

#include <array>
#include <string_view>

#include "proofs/bounds.h"

namespace axiscert::proofs {

struct AttainedBound {
  std::string_view kernel;
  Kind kind;
  double u;
  std::string_view search;
};
inline constexpr auto attained_errors = std::to_array<AttainedBound>({
    {"published", Kind::plane_radius, 367.59, "--evaluations 63438848 --seed 1"},
    {"published", Kind::vertex_radius, 7.982, "--evaluations 63438848 --seed 1"},
    {"published", Kind::vertex_side, 14.813, "--evaluations 63438848 --seed 1"},
    {"published", Kind::edge_radius, 1129.19, "--evaluations 63438848 --seed 1"},
    {"published", Kind::edge_side, 2030.96, "--evaluations 63438848 --seed 1"},
    {"reduced", Kind::edge_radius, 65.302, "--comparison edge_ab.radius --evaluations 30051328 --seed 2"},
    {"reduced", Kind::edge_side, 91.323, "--comparison edge_ab.side_c --evaluations 30051328 --seed 2"},
});

}  // namespace axiscert::proofs

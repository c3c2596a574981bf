// The bounds as a header in kernel/, for code that relies on them.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

#include "proofs/bounds.h"
#include "proofs/emit.h"

namespace axiscert::proofs {

Files header_files() {
  std::string rows;
  for (const Form form : {Form::published, Form::reduced}) {
    for (const Contraction contraction : {Contraction::plain, Contraction::fma}) {
      std::vector<int> bounds;
      for (std::size_t k = 0; k < comparison_count; ++k) {
        bounds.push_back(bound({form, contraction, Precision::binary32, Domain::scaled}, static_cast<Comparison>(k)));
      }
      rows += fmt::format("    // {}, {}\n    {{{}}},\n", name(form), name(contraction), fmt::join(bounds, ", "));
    }
  }
  return {
      {"kernel/sphere_triangle/proved_bounds.h",
       fmt::format(
           R"(// Proved bounds on |(computed lhs - computed rhs) - (lhs - rhs)|, in u/16. Written by write_proofs: do not edit.
#pragma once

#include <array>

#include "kernel/sphere_triangle/names.h"

namespace axiscert {{

// Where every exact coordinate of A - P, B - P and C - P is in [-1, 1] and r in [0, 1]; in either precision, subnormal
// numbers included. By set of formulae (published, reduced) and contraction (plain, fma): [2 * formulae + contraction].
// clang-format off
inline constexpr std::array<std::array<int, comparison_count>, 4> proved_sixteenths = {{{{
{}}}}};
// clang-format on

}}  // namespace axiscert
)",
           rows)}};
}

}  // namespace axiscert::proofs

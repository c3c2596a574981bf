// CGAL's do_intersect of an Iso_cuboid_3 and a Triangle_3, in a kernel of its own. The description applies to CGAL 5.5:
// it is the thirteen axes of Akenine-Moller, over the kernel's numbers. Where two corners of a triangle are
// equal, the side of length 0 is taken for one along an axis, whose products are left out: contacts are invented, in
// Epick too.
#pragma once

#include <CGAL/intersections.h>

#include "kernel/peers/peer.h"

namespace axiscert::peer {

inline constexpr std::size_t cell_columns = 15;

// Kernel: one of CGAL's, over double.
template <class Kernel>
int intersects(const double* v) {
  const auto point = [&](std::size_t k) { return typename Kernel::Point_3(v[k], v[k + 1], v[k + 2]); };
  const typename Kernel::Iso_cuboid_3 cell(point(0), point(3));
  const typename Kernel::Triangle_3 triangle(point(6), point(9), point(12));
  return verdict_of(CGAL::do_intersect(cell, triangle));
}

template <class Kernel, std::floating_point Input>
void run_cells(const axiscert_batch* batch, const axiscert_answers* answers) {
  for (std::size_t i = 0; i < batch->count; ++i) {
    double v[cell_columns];
    bool is_query = true;
    for (std::size_t k = 0; k < cell_columns; ++k) {
      v[k] = static_cast<const Input*>(batch->column[k])[i];
      is_query = is_query && std::isfinite(v[k]);
    }
    is_query = is_query && v[0] <= v[3] && v[1] <= v[4] && v[2] <= v[5];
    answers->verdict[i] = static_cast<std::uint8_t>(is_query ? intersects<Kernel>(v) : int{AXISCERT_INVALID});
  }
}

template <class Kernel>
const axiscert_kernel* cells_kernel(std::uint32_t index, const Description& says) {
  return kernel_by_index<double>(index, [&]<class Input>(Input) {
    axiscert_kernel made = verdict_kernel<Input>(says, cell_columns, run_cells<Kernel, Input>);
    made.predicate = "box-triangle";
    made.entry = "minmax";
    return made;
  });
}

}  // namespace axiscert::peer

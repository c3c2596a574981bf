// The textbook as engines run it: axis by axis, until one separates. Its verdicts are the textbook's; the order and the
// early answer change the time alone.
#pragma once

#include "kernel/boxes/boxes.h"
#include "kernel/boxes/relative.h"

namespace axiscert::boxes {

// The order of RAPID's obb_disjoint: the first facet of each box, the others, then the edges.
struct EarlyTextbook {
  template <class Real>
  static bool separated(const BoxPair<Real>& q) {
    const Relative<Real> r = relative(q);
    const Matrix<Real> size = magnitudes(r.turn);
    const auto by_a = [&](std::size_t i) { return facet_sides_of_a(r, i, size).separate(); };
    const auto by_b = [&](std::size_t j) { return facet_sides_of_b(r, j, r.half_b[j], size).separate(); };
    if (by_a(0) || by_b(0) || by_a(1) || by_a(2) || by_b(1) || by_b(2)) return true;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        if (edge_sides(r, i, j, size, size).separate()) return true;
      }
    }
    return false;
  }
};

}  // namespace axiscert::boxes

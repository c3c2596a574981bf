// The formulae of the moving sphere as mutants are made of them (kernel/mutants/forms.h).
#pragma once

#include <array>

#include "kernel/moving_sphere/twenty.h"

namespace axiscert::mutants {

// The twenty axes make their zero themselves.
struct MotionForm {
  static const Predicate& predicate() { return moving_sphere_predicate(); }
  static std::string_view formulae() { return moving_sphere::TwentyNonstrict::name; }
  static constexpr std::size_t columns = 16;
  static constexpr ComparisonBits nonstrict = moving_sphere::TwentyNonstrict::nonstrict;
  static constexpr std::size_t plane_radius = 0, vertex_radius = 2, edge_radius = 14, edge_side = 56;
  static_assert(moving_sphere::comparison_names[plane_radius] == "start.plane.radius" &&
                moving_sphere::comparison_names[vertex_radius] == "start.vertex_a.radius" &&
                moving_sphere::comparison_names[edge_radius] == "start.edge_ab.radius" &&
                moving_sphere::comparison_names[edge_side] == "sweep.edge_ab.side");
  template <class N, class Sink>
  static void comparisons(const std::array<N, columns>& in, const N&, Sink&& sink) {
    const auto problem = MovingSphere::problem<N>([&](std::size_t k) { return in[k]; });
    moving_sphere::TwentyNonstrict::comparisons<N>(problem, sink);
  }
};

}  // namespace axiscert::mutants

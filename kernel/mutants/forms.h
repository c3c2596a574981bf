// The formulae that mutants are made of, in one form for all predicates: columns in, comparisons by their index out.
#pragma once

#include <array>

#include "kernel/moving_sphere/twenty.h"
#include "kernel/sphere_triangle/query.h"
#include "kernel/sphere_triangle/reference/formulae_types.h"

namespace axiscert::mutants {

// A form has
//   static const Predicate& predicate();
//   formulae()   as a kernel of that predicate claims them
//   columns      how many numbers a query has: three for each of A, B, C and P, then others, the radius last
//   nonstrict    the comparisons that are lhs >= rhs
//   plane_radius, edge_radius, edge_side, vertex_radius
//                comparisons of a plane, whose right side is rr (V.V), an edge and a vertex; their left sides are no
//                zero
//   comparisons(in, zero, sink)   the formulae over any number type: sink(i, lhs, rhs)

template <Formulae claimed>
struct TriangleForm {
  static const Predicate& predicate() { return sphere_triangle_predicate(); }
  static std::string_view formulae() { return name(claimed); }
  static constexpr std::size_t columns = coordinate_count;
  static constexpr ComparisonBits nonstrict = [] {
    ComparisonBits bits = 0;
    for (std::size_t i = 0; i < comparison_count; ++i) {
      if (!axiscert::comparisons[i].is_radius) bits |= one_bit<ComparisonBits>(i);
    }
    return bits;
  }();
  static constexpr std::size_t plane_radius = index_of(Comparison::plane_radius),
                               edge_radius = index_of(Comparison::edge_ab_radius),
                               edge_side = index_of(Comparison::edge_ab_side_c),
                               vertex_radius = index_of(Comparison::vertex_a_radius);
  template <class N, class Sink>
  static void comparisons(const std::array<N, columns>& in, const N& zero, Sink&& sink) {
    const portable::Problem<N> problem{
        {in[0], in[1], in[2]}, {in[3], in[4], in[5]}, {in[6], in[7], in[8]}, {in[9], in[10], in[11]}, in[12], zero};
    FormulaeType<claimed>::comparisons(
        problem, [&](Comparison which, const N& lhs, const N& rhs) { sink(index_of(which), lhs, rhs); });
  }
};

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

// What is done for the form of base number `base` (kernel/mutants/mutant.h): use(Form()).
template <class Use>
decltype(auto) with_form(std::size_t base, Use&& use) {
  if (base == 0) return use(TriangleForm<Formulae::published>());
  if (base == 1) return use(TriangleForm<Formulae::reduced>());
  return use(MotionForm());
}

}  // namespace axiscert::mutants

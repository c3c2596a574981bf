// The formulae of sphere-triangle as mutants are made of them (kernel/mutants/forms.h).
#pragma once

#include <array>

#include "kernel/sphere_triangle/forms/formulae_types.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert::mutants {

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

}  // namespace axiscert::mutants

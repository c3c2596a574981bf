// The formulae that mutants are made of, in one form for all predicates: columns in, comparisons by their index out.
#pragma once

#include "kernel/moving_sphere/mutant_form.h"
#include "kernel/sphere_triangle/forms/mutant_form.h"

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

// What is done for the form of base number `base` (kernel/mutants/mutant.h): use(Form()).
template <class Use>
decltype(auto) with_form(std::size_t base, Use&& use) {
  if (base == 0) return use(TriangleForm<Formulae::published>());
  if (base == 1) return use(TriangleForm<Formulae::reduced>());
  return use(MotionForm());
}

}  // namespace axiscert::mutants

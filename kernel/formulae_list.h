// Every set of formulae that a kernel can claim, one line each: the name, the type, and its kind, a statement about it
// over the reals. All number types (exact, unbounded, floating-point) are instantiated from this list.
#pragma once

#include <cstdint>
#include <string_view>

#include "kernel/base/enums.h"

// X(name, type, kind)
//   rung     sixteen comparisons whose signs are those of the published ones on every query, where they are defined
//   cell     the same, in plain arithmetic alone: a combination of the article's rewritings off its path
//   variant  sixteen comparisons whose signs may differ from the published ones
//   method   only a verdict, without comparisons
#define AXISCERT_FORMULAE(X)                                                       \
  X(published, portable::PublishedFormulae, rung)                                  \
  X(ladder_0, rungs::Ladder0, rung)                                                \
  X(ladder_1, rungs::Ladder1, rung)                                                \
  X(ladder_2, rungs::Ladder2, rung)                                                \
  X(ladder_3, rungs::Ladder3, rung)                                                \
  X(ladder_4, rungs::Ladder4, rung)                                                \
  X(ladder_5, rungs::Ladder5, rung)                                                \
  X(ladder_6, rungs::Ladder6, rung)                                                \
  X(ladder_7, rungs::Ladder7, rung)                                                \
  X(ladder_8, rungs::Ladder8, rung)                                                \
  X(ladder_9, rungs::Ladder9, rung)                                                \
  X(reduced, portable::ReducedFormulae, rung)                                      \
  X(reduced_along, portable::ReducedAlong, rung)                                   \
  X(reduced_determinant, portable::ReducedDeterminant, rung)                       \
  X(reduced_shared, portable::ReducedShared, rung)                                 \
  X(edges_world_multiplied_rooted_6, rungs::EdgesWorldMultipliedRooted6, cell)     \
  X(edges_world_divided_rooted_4, rungs::EdgesWorldDividedRooted4, cell)           \
  X(edges_world_divided_squared_4, rungs::EdgesWorldDividedSquared4, cell)         \
  X(edges_world_multiplied_rooted_4, rungs::EdgesWorldMultipliedRooted4, cell)     \
  X(edges_world_multiplied_squared_4, rungs::EdgesWorldMultipliedSquared4, cell)   \
  X(edges_centred_divided_rooted_6, rungs::EdgesCentredDividedRooted6, cell)       \
  X(edges_centred_divided_squared_6, rungs::EdgesCentredDividedSquared6, cell)     \
  X(edges_centred_multiplied_rooted_6, rungs::EdgesCentredMultipliedRooted6, cell) \
  X(edges_centred_divided_rooted_4, rungs::EdgesCentredDividedRooted4, cell)       \
  X(edges_centred_divided_squared_4, rungs::EdgesCentredDividedSquared4, cell)     \
  X(edges_centred_multiplied_rooted_4, rungs::EdgesCentredMultipliedRooted4, cell) \
  X(plane_divided_rooted, rungs::PlaneDividedRooted, cell)                         \
  X(plane_multiplied_rooted, rungs::PlaneMultipliedRooted, cell)                   \
  X(first_publication, rungs::FirstPublication, variant)                           \
  X(vertex_typo, rungs::VertexTypo, variant)                                       \
  X(segments, methods::Segments, variant)                                          \
  X(minkowski, methods::Minkowski, method)                                         \
  X(closest_point, methods::ClosestPoint, method)

namespace axiscert {

enum class FormulaeKind : std::uint8_t { rung, cell, variant, method };

enum class Formulae : std::uint8_t {
#define AXISCERT_NAME(name, type, kind) name,
  AXISCERT_FORMULAE(AXISCERT_NAME)
#undef AXISCERT_NAME
      none,  // a kernel that claims no formulae: only its verdicts are judged
};
// `none` has no place in an array of formulae.
template <>
inline constexpr std::size_t enum_count<Formulae> = index_of(Formulae::none);
inline constexpr std::size_t formulae_count = enum_count<Formulae>;

inline constexpr EnumArray<Formulae, FormulaeKind> formulae_kinds = {
#define AXISCERT_KIND(name, type, kind) FormulaeKind::kind,
    AXISCERT_FORMULAE(AXISCERT_KIND)
#undef AXISCERT_KIND
};
constexpr FormulaeKind kind_of(Formulae f) { return formulae_kinds[f]; }
// Whether each comparison has the published sign on every query, wherever it is defined.
constexpr bool has_published_signs(Formulae f) {
  return kind_of(f) == FormulaeKind::rung || kind_of(f) == FormulaeKind::cell;
}
constexpr bool has_comparisons(Formulae f) { return f != Formulae::none && kind_of(f) != FormulaeKind::method; }

// The name by which a kernel claims them, as ids spell it: Formulae::closest_point is "closest-point". That of
// Formulae::none is empty.
std::string_view name(Formulae formulae);
// Those that a kernel claims; none where it claims none, or those of another predicate.
struct Kernel;
Formulae formulae_of(const Kernel& kernel);

}  // namespace axiscert

#include "fuzz/sphere_triangle/formulae/choices.h"

#include <algorithm>

#include "kernel/sphere_triangle/forms/formulae_types.h"

namespace axiscert {
namespace {

// The operations of each kind of axis, by number: those of the same number are the same.
struct Operations {
  EnumArray<AxisKind, int> of;
};

constexpr int of_cell(const rungs::EdgeChoices& c) {
  return static_cast<int>(c.frame) + 2 * static_cast<int>(c.division) + 4 * static_cast<int>(c.root) +
         8 * static_cast<int>(c.degree);
}
template <class Edge>
struct EdgeNumber;
template <rungs::EdgeChoices choices>
struct EdgeNumber<rungs::EdgeCell<choices>> {
  static constexpr int value = of_cell(choices);
};
template <>
struct EdgeNumber<rungs::ScaledEdge> {
  static constexpr int value = 16;
};
template <>
struct EdgeNumber<rungs::DistributedEdge> {
  static constexpr int value = 17;
};

template <class F>
struct OperationsOf {
  static constexpr std::optional<Operations> value = std::nullopt;
};
template <rungs::PlaneForm plane, rungs::VertexForm vertex, class Edge>
struct OperationsOf<rungs::Rung<plane, vertex, Edge>> {
  static constexpr std::optional<Operations> value =
      Operations{{static_cast<int>(plane), static_cast<int>(vertex), EdgeNumber<Edge>::value}};
};
// The reduced forms, whose text is their own: planes from 100 on are theirs, edges from 18 on.
constexpr Operations published = *OperationsOf<rungs::Ladder9>::value;
constexpr Operations reduced(int plane, int edge) {
  return {{plane, static_cast<int>(rungs::VertexForm::distributed), edge}};
}
constexpr int published_plane = published.of[AxisKind::plane];
constexpr int normal_edge =
    of_cell({rungs::Frame::centred, rungs::Division::multiplied, rungs::Root::squared, rungs::EdgeDegree::four});

std::optional<Operations> operations_of(Formulae formulae) {
  switch (formulae) {
    case Formulae::published:
      return published;
    case Formulae::reduced:
      return reduced(published_plane, normal_edge);
    case Formulae::reduced_along:
      return reduced(published_plane, 18);
    case Formulae::reduced_determinant:
      return reduced(100, normal_edge);
    case Formulae::reduced_shared:
      return reduced(101, 19);
    default:
      break;
  }
  static constexpr EnumArray<Formulae, std::optional<Operations>> all = {
#define AXISCERT_OPERATIONS(name, type, kind) OperationsOf<type>::value,
      AXISCERT_FORMULAE(AXISCERT_OPERATIONS)
#undef AXISCERT_OPERATIONS
  };
  return formulae == Formulae::none ? std::nullopt : all[formulae];
}

}  // namespace

AxisBits axes_of_kind(AxisKind kind) {
  constexpr EnumArray<AxisKind, AxisBits> axes = {0b0000001, 0b0001110, 0b1110000};
  return axes[kind];
}

ComparisonBits comparisons_of_kind(AxisKind kind) {
  ComparisonBits bits = 0;
  for_each_bit(axes_of_kind(kind), [&](std::size_t axis) { bits |= axis_comparisons[axis]; });
  return bits;
}

EnumArray<AxisKind, bool> rewritten_kinds(const Kernel& from, const Kernel& to) {
  const auto a = operations_of(formulae_of(from)), b = operations_of(formulae_of(to));
  const bool is_known = a && b && from.arithmetic == to.arithmetic && from.strictness == to.strictness &&
                        from.is_reference && to.is_reference;
  EnumArray<AxisKind, bool> rewritten;
  for (const AxisKind kind : enumerators<AxisKind>) rewritten[kind] = !is_known || a->of[kind] != b->of[kind];
  return rewritten;
}

const std::vector<FactorialCell>& factorial_cells() {
  using enum Formulae;
  // By the four levels: frame, division, root, degree.
  static constexpr std::array<Formulae, edge_cell_count> edges = {
      ladder_4,
      edges_centred_divided_rooted_6,
      edges_world_multiplied_rooted_6,
      edges_centred_multiplied_rooted_6,
      ladder_5,
      edges_centred_divided_squared_6,
      ladder_7,
      ladder_8,
      edges_world_divided_rooted_4,
      edges_centred_divided_rooted_4,
      edges_world_multiplied_rooted_4,
      edges_centred_multiplied_rooted_4,
      edges_world_divided_squared_4,
      edges_centred_divided_squared_4,
      edges_world_multiplied_squared_4,
      reduced,
  };
  static constexpr std::array<Formulae, 4> planes = {plane_divided_rooted, plane_multiplied_rooted, ladder_2, ladder_3};
  static const std::vector<FactorialCell> all = [] {
    std::vector<FactorialCell> cells;
    for (std::size_t i = 0; i < edges.size(); ++i) cells.push_back({edges[i], static_cast<std::uint8_t>(i)});
    for (std::size_t i = 0; i < planes.size(); ++i) {
      cells.push_back({planes[i], static_cast<std::uint8_t>(i << index_of(Factor::plane_division))});
    }
    return cells;
  }();
  return all;
}

const FactorialCell* factorial_cell(const Kernel& kernel) {
  if (kernel.arithmetic != Arithmetic::plain || kernel.strictness != Strictness::strict) return nullptr;
  const auto& cells = factorial_cells();
  const auto found = std::ranges::find(cells, formulae_of(kernel), &FactorialCell::formulae);
  return found == cells.end() ? nullptr : &*found;
}

}  // namespace axiscert

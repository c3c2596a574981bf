// The exact step's verdict of the signs of margins, over the number types of exact_margins.h. proofs/certified records
// it as trees of what it asks.
#pragma once

#include <cstdint>

#include "kernel/sphere_triangle/certified/exact_margins.h"
#include "kernel/sphere_triangle/certified/exact_step.h"

namespace axiscert::certified {

// Whether V is needed: by the plane's axis, or by an edge whose side comparison is open.
constexpr bool needs_normal(KnownResults known) noexcept {
  constexpr std::uint64_t plane_and_edges = 0b1111 << KnownResults::plane_axis,
                          edges = 0b111 << KnownResults::edge_axis;
  const std::uint64_t fails = known.bits >> KnownResults::fails, sides = known.bits >> KnownResults::sides;
  return (~fails & (plane_and_edges ^ (sides & edges))) & plane_and_edges;
}

// `known` with the results added that signs of margins tell, where these are certain; they hold for the closed and the
// open sphere.
template <class Numbers>
KnownResults with_signs(const ExactMargins<Numbers>& m, KnownResults known) noexcept {
  const auto is_open = [](std::uint32_t axes, int axis) { return ((axes >> axis) & 1u) != 0; };
  const auto note = [&](int group, int axis, bool holds, bool fails) {
    known.bits |= std::uint64_t{holds} << (group + axis) | std::uint64_t{fails} << (KnownResults::fails + axis);
  };
  const auto note_radius = [&](int axis, const auto& margin) {
    note(KnownResults::radius, axis, margin.is_positive(), margin.is_negative());
  };
  note(KnownResults::sides, KnownResults::plane_axis, true, false);  // the plane has no sides
  const auto V = needs_normal(known) ? m.plane_normal() : typename ExactMargins<Numbers>::Normal{};
  for (int i = 0; i < 3; ++i) {
    const int vertex = KnownResults::vertex_axis + i, edge = KnownResults::edge_axis + i;
    if (is_open(known.open_radii(), vertex)) note_radius(vertex, m.vertex_radius(i));
    if (is_open(known.open_sides(), vertex)) {
      const auto away = m.vertex_side(i, m.next(i)), towards = m.vertex_side(i, m.last(i));
      note(KnownResults::sides, vertex, away.is_at_least_zero() && towards.is_at_least_zero(),
           away.is_negative() || towards.is_negative());
    }
    if (!is_open(known.open_radii() | known.open_sides(), edge)) continue;
    const auto along = m.along(i);
    const auto N = m.edge_normal(i, along);
    if (is_open(known.open_sides(), edge)) {
      const auto side = m.edge_side(N, V);
      note(KnownResults::sides, edge, side.is_at_most_zero(), side.is_positive());
    }
    if (is_open(known.open_radii(), edge)) note_radius(edge, m.edge_radius(N, along));
  }
  if (is_open(known.open_radii(), KnownResults::plane_axis)) note_radius(KnownResults::plane_axis, m.plane_radius(V));
  return known;
}

// Whether an axis of a test separates, asked in this order.
template <class Test>
bool some_axis_separates(const Test& test) noexcept {
  for (int i = 0; i < 3; ++i) {
    if (test.vertex_separates(i)) return true;
  }
  const auto V = test.normal();
  if (test.plane_separates(V)) return true;
  for (int i = 0; i < 3; ++i) {
    if (test.edge_separates(i, V)) return true;
  }
  return false;
}

// The reduced test (kernel/sphere_triangle/forms/reduced.h) with non-strict sides, which decides every triangle. For
// the open sphere the radii are non-strict too, on axes that have a normal: the distance is at least r > 0 iff some
// such axis has the whole triangle at distance r or farther (exact/sphere_triangle/oracles/signs.h, is_touching).
template <class Numbers, class Known = KnownResults>
class ExactTest {
 public:
  using Margins = ExactMargins<Numbers>;
  using Point = typename Margins::Point;
  using Normal = typename Margins::Normal;

  ExactTest(const typename Margins::One (&q)[13], bool open, Known known) noexcept
      : m_(q), open_(open), known_(known) {}

  // Zero where it is not needed.
  Normal normal() const noexcept { return needs_normal(known_) ? m_.plane_normal() : Normal{}; }

  bool vertex_separates(int i) const noexcept {
    const int axis = KnownResults::vertex_axis + i;
    const auto leads_away = [&](int to) { return !m_.vertex_side(i, to).is_negative(); };
    return !known_.has(KnownResults::fails, axis) &&
           (known_.has(KnownResults::radius, axis) || beyond(m_.vertex_radius(i))) &&
           (known_.has(KnownResults::sides, axis) || (leads_away(m_.next(i)) && leads_away(m_.last(i))));
  }
  bool plane_separates(const Normal& V) const noexcept {
    return !known_.has(KnownResults::fails, KnownResults::plane_axis) && !V.is_zero() && beyond(m_.plane_radius(V));
  }
  bool edge_separates(int i, const Normal& V) const noexcept {
    const int axis = KnownResults::edge_axis + i;
    if (known_.has(KnownResults::fails, axis)) return false;
    const Point along = m_.along(i);
    if (along.is_zero()) return false;
    const Normal N = m_.edge_normal(i, along);
    return (known_.has(KnownResults::sides, axis) || !m_.edge_side(N, V).is_positive()) &&
           (known_.has(KnownResults::radius, axis) || beyond(m_.edge_radius(N, along)));
  }

 private:
  template <class Number>
  bool beyond(const Number& margin) const noexcept {
    return open_ ? !margin.is_negative() : margin.is_positive();
  }

  Margins m_;
  bool open_;
  Known known_;
};

}  // namespace axiscert::certified

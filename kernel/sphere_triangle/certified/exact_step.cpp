#include "kernel/sphere_triangle/certified/exact_step.h"

#include <algorithm>
#include <iterator>

#include "kernel/sphere_triangle/certified/numbers/ball.h"
#include "kernel/sphere_triangle/certified/numbers/exact_margins.h"
#include "kernel/sphere_triangle/certified/numbers/widths.h"

namespace axiscert::certified {
namespace {

struct Balls {
  template <int>
  using Value = Ball;
};

// Whether V is needed: by the plane's axis, or by an edge whose side comparison is open.
bool needs_normal(KnownResults known) noexcept {
  constexpr std::uint64_t plane_and_edges = 0b1111 << KnownResults::plane_axis,
                          edges = 0b111 << KnownResults::edge_axis;
  const std::uint64_t fails = known.bits >> KnownResults::fails, sides = known.bits >> KnownResults::sides;
  return (~fails & (plane_and_edges ^ (sides & edges))) & plane_and_edges;
}

// The reduced test (kernel/sphere_triangle/formulae/reduced.h) with non-strict sides, which decides every triangle. For
// the open sphere the radii are non-strict too, on axes that have a normal: the distance is at least r > 0 iff some
// such axis has the whole triangle at distance r or farther (exact/sphere_triangle/filters/signs.h, is_touching).
template <class Numbers>
class Test {
 public:
  Test(const Query13<Numbers>& q, bool open, KnownResults known) noexcept : m_(q), open_(open), known_(known) {}

  bool separates() const noexcept {
    for (int i = 0; i < 3; ++i) {
      if (vertex_separates(i)) return true;
    }
    const Normal V = needs_normal(known_) ? m_.plane_normal() : Normal{};
    if (plane_separates(V)) return true;
    for (int i = 0; i < 3; ++i) {
      if (edge_separates(i, V)) return true;
    }
    return false;
  }

 private:
  using Margins = ExactMargins<Numbers>;
  using Point = typename Margins::Point;
  using Normal = typename Margins::Normal;

  template <class Number>
  bool beyond(const Number& margin) const noexcept {
    return open_ ? !margin.is_negative() : margin.is_positive();
  }
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

  Margins m_;
  bool open_;
  KnownResults known_;
};

template <class Numbers>
[[gnu::noinline]] bool separated_in(const Query13<Numbers>& q, bool open, KnownResults known) noexcept {
  return Test<Numbers>(q, open, known).separates();
}

// The numbers in units of 2^unit.
template <int bits>
[[gnu::noinline]] bool separated_in_units(const double (&q)[13], int unit, bool open, KnownResults known) noexcept {
  Query13<Integers<bits>> numbers;
  convert<bits>(q, unit, numbers);
  return separated_in<Integers<bits>>(numbers, open, known);
}

bool is_open(std::uint32_t axes, int axis) noexcept { return ((axes >> axis) & 1u) != 0; }

// `known` with the results added that are certain in ball arithmetic; they hold for the closed and the open sphere.
KnownResults with_balls(const double (&q)[13], KnownResults known) noexcept {
  Ball numbers[13];
  for (int i = 0; i < 13; ++i) numbers[i] = Ball(Dyadic(q[i]));
  const ExactMargins<Balls> m(numbers);
  const auto note = [&](int group, int axis, bool holds, bool fails) {
    known.bits |= std::uint64_t{holds} << (group + axis) | std::uint64_t{fails} << (KnownResults::fails + axis);
  };
  const auto note_radius = [&](int axis, const Ball& margin) {
    note(KnownResults::radius, axis, margin.is_positive(), margin.is_negative());
  };
  note(KnownResults::sides, KnownResults::plane_axis, true, false);  // the plane has no sides
  const Vector<Ball> V = needs_normal(known) ? m.plane_normal() : Vector<Ball>{};
  for (int i = 0; i < 3; ++i) {
    const int vertex = KnownResults::vertex_axis + i, edge = KnownResults::edge_axis + i;
    if (is_open(known.open_radii(), vertex)) note_radius(vertex, m.vertex_radius(i));
    if (is_open(known.open_sides(), vertex)) {
      const Ball away = m.vertex_side(i, m.next(i)), towards = m.vertex_side(i, m.last(i));
      note(KnownResults::sides, vertex, away.is_at_least_zero() && towards.is_at_least_zero(),
           away.is_negative() || towards.is_negative());
    }
    if (!is_open(known.open_radii() | known.open_sides(), edge)) continue;
    const Vector<Ball> along = m.along(i), N = m.edge_normal(i, along);
    if (is_open(known.open_sides(), edge)) {
      const Ball side = m.edge_side(N, V);
      note(KnownResults::sides, edge, side.is_at_most_zero(), side.is_positive());
    }
    if (is_open(known.open_radii(), edge)) note_radius(edge, m.edge_radius(N, along));
  }
  if (is_open(known.open_radii(), KnownResults::plane_axis)) note_radius(KnownResults::plane_axis, m.plane_radius(V));
  return known;
}

// Decides by balls and, where these do not suffice, by nonzero digits; for numbers so far apart that most digits are
// zero.
bool separated_by_digits(const double (&q)[13], bool open, KnownResults known) noexcept {
  known = with_balls(q, known);
  if (known.is_separated()) return true;
  if (known.is_contact()) return false;
  Query13<Digits> numbers;
  convert(q, numbers);
  return separated_in<Digits>(numbers, open, known);
}

}  // namespace

bool exactly_separated(const double (&query)[13], Question question, KnownResults known) noexcept {
  bool open = question == Question::open_sphere;
  if (open && query[12] == 0) return true;  // an open sphere of radius 0 is empty
  const int top = top_of(query);
  if (Query13<Integers<30>> numbers; fit<30>(query, top, numbers, open)) {
    return separated_in<Integers<30>>(numbers, open, known);
  }
  if (Query13<Integers<62>> numbers; fit<62>(query, top, numbers, open)) {
    return separated_in<Integers<62>>(numbers, open, known);
  }

  double q[13];
  std::copy(std::begin(query), std::end(query), q);
  Span span;
  for (int i = 0; i < 12; ++i) span.include(Dyadic(q[i]));
  const Dyadic r(q[12]);
  if (r.significand != 0 && !span.is_empty() && r.top() <= span.unit + negligible_radius(span.bits())) {
    q[12] = 0;
    open = false;
  } else {
    span.include(r);
  }
  const int unit = span.unit, bits = span.bits();
  if (bits <= 62) return separated_in_units<62>(q, unit, open, known);  // 1, 2, 3, 4 and 6 words by degree
  if (bits <= 94) return separated_in_units<94>(q, unit, open, known);  // 2, 3, 5, 6 and 9 words
  if (bits <= 126) return separated_in_units<126>(q, unit, open, known);
  return separated_by_digits(q, open, known);
}

}  // namespace axiscert::certified

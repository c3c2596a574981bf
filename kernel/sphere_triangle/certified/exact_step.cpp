#include "kernel/sphere_triangle/certified/exact_step.h"

#include <algorithm>
#include <iterator>

#include "kernel/sphere_triangle/certified/ball.h"
#include "kernel/sphere_triangle/certified/exact_test.h"
#include "kernel/sphere_triangle/certified/widths.h"

namespace axiscert::certified {
namespace {

struct Balls {
  template <int>
  using Value = Ball;
};

template <class Numbers>
[[gnu::noinline]] bool separated_in(const Query13<Numbers>& q, bool open, KnownResults known) noexcept {
  return some_axis_separates(ExactTest<Numbers>(q, open, known));
}

// The numbers in units of 2^unit.
template <int bits>
[[gnu::noinline]] bool separated_in_units(const double (&q)[13], int unit, bool open, KnownResults known) noexcept {
  Query13<Integers<bits>> numbers;
  convert<bits>(q, unit, numbers);
  return separated_in<Integers<bits>>(numbers, open, known);
}

// `known` with the results added that are certain in ball arithmetic.
KnownResults with_balls(const double (&q)[13], KnownResults known) noexcept {
  Ball numbers[13];
  for (int i = 0; i < 13; ++i) numbers[i] = Ball(Dyadic(q[i]));
  return with_signs(ExactMargins<Balls>(numbers), known);
}

// By nonzero digits, for numbers so far apart that most digits are zero.
bool separated_by_digits(const double (&q)[13], bool open, KnownResults known) noexcept {
  Query13<Digits> numbers;
  convert(q, numbers);
  return separated_in<Digits>(numbers, open, known);
}

// By the least integers that hold numbers of this span.
template <std::size_t i>
bool separated_in_size_for(const double (&q)[13], int unit, int bits, bool open, KnownResults known) noexcept {
  if constexpr (i == std::size(integer_sizes)) {
    return separated_by_digits(q, open, known);
  } else {
    constexpr int size = integer_sizes[i];
    if (integer_size_for(bits) == size) return separated_in_units<size>(q, unit, open, known);
    return separated_in_size_for<i + 1>(q, unit, bits, open, known);
  }
}

// Numbers that span more than `before_balls` bits are asked as balls first, which is quicker where these suffice, and
// those that span more than `widest` by digits.
bool separated(const double (&query)[13], Question question, KnownResults known, int before_balls,
               int widest) noexcept {
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
  if (bits > before_balls) {
    known = with_balls(q, known);
    if (known.is_separated()) return true;
    if (known.is_contact()) return false;
  }
  return bits <= widest ? separated_in_size_for<0>(q, unit, bits, open, known) : separated_by_digits(q, open, known);
}

}  // namespace

bool exactly_separated(const double (&query)[13], Question question, KnownResults known, int widest) noexcept {
  return separated(query, question, known, widest_integers<double>, widest);
}
bool separated_by_integers(const double (&query)[13], Question question) noexcept {
  return separated(query, question, {}, widest_integers<float>, widest_integers<float>);
}

}  // namespace axiscert::certified

// A number with its partial derivatives with respect to the thirteen numbers of a query: forward-mode differentiation
// of any formula that is a template over a number type.
#pragma once

#include <array>

#include "kernel/sphere_triangle/query.h"

namespace axiscert {

// `partials` are in the order of coordinates(q). Operations that are exact in Base are exact here. A root is
// differentiated as s' / (2 sqrt s), which must be an undefined value of Base at s = 0; |x| at x = 0 has the derivative
// from the right. Comparisons are those of the values, so that a branch is differentiated on the side where the query
// lies.
template <class Base>
struct Dual {
  Base value{};
  std::array<Base, coordinate_count> partials{};  // Base() is zero

  Dual() = default;
  explicit Dual(const Base& constant) : value(constant) {}
  // The query's number at `place`.
  static Dual variable(const Base& x, std::size_t place, const Base& one) {
    Dual result(x);
    result.partials[place] = one;
    return result;
  }

  friend Dual operator+(const Dual& a, const Dual& b) {
    return with(a.value + b.value, [&](std::size_t i) { return a.partials[i] + b.partials[i]; });
  }
  friend Dual operator-(const Dual& a, const Dual& b) {
    return with(a.value - b.value, [&](std::size_t i) { return a.partials[i] - b.partials[i]; });
  }
  friend Dual operator*(const Dual& a, const Dual& b) {
    return with(a.value * b.value, [&](std::size_t i) { return a.value * b.partials[i] + a.partials[i] * b.value; });
  }
  friend Dual operator/(const Dual& a, const Dual& b) {
    const Base quotient = a.value / b.value;
    return with(quotient, [&](std::size_t i) { return (a.partials[i] - quotient * b.partials[i]) / b.value; });
  }
  friend Dual square_root(const Dual& a) {
    using portable::square_root;
    const Base root = square_root(a.value), twice = root + root;
    return with(root, [&](std::size_t i) { return a.partials[i] / twice; });
  }
  friend Dual magnitude(const Dual& a) {
    const Base zero = a.value - a.value;
    return zero > a.value ? Dual(zero) - a : a;
  }
  friend bool operator>(const Dual& a, const Dual& b) { return a.value > b.value; }
  friend bool operator>=(const Dual& a, const Dual& b) { return a.value >= b.value; }

 private:
  template <class Partial>
  static Dual with(const Base& value, Partial&& partial) {
    Dual result(value);
    for (std::size_t i = 0; i < coordinate_count; ++i) result.partials[i] = partial(i);
    return result;
  }
};

// A query whose thirteen numbers are the variables. `convert` converts a Real to a Base, exactly.
template <class Base, class Real, class Convert>
portable::Problem<Dual<Base>> dual_problem(const Query<Real>& q, Convert&& convert) {
  const auto x = coordinates(q);
  const Base one = convert(Real(1));
  std::array<Dual<Base>, coordinate_count> variables;
  for (std::size_t i = 0; i < coordinate_count; ++i) variables[i] = Dual<Base>::variable(convert(x[i]), i, one);
  const auto dual = from_coordinates(variables);
  return {dual.a, dual.b, dual.c, dual.p, dual.r, Dual<Base>(convert(Real(0)))};
}

}  // namespace axiscert

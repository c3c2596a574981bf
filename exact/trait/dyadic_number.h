// A number of finitely many binary digits by CGAL, as a number type of the formulae (kernel/formulae_kernel.h): what
// finite floats become by +, - and *. exact/numbers/binary_number.h is another one for the same purpose, in which the
// formulae are evaluated: what is computed in one of them checks what is computed in the other.
#pragma once

#include <CGAL/Mpzf.h>

#include <utility>

namespace axiscert {

struct DyadicNumber {
  CGAL::Mpzf value;

  DyadicNumber() = default;
  explicit DyadicNumber(double x) : value(x) {}  // finite
  explicit DyadicNumber(CGAL::Mpzf x) : value(std::move(x)) {}

  friend DyadicNumber operator+(const DyadicNumber& a, const DyadicNumber& b) {
    return DyadicNumber(a.value + b.value);
  }
  friend DyadicNumber operator-(const DyadicNumber& a, const DyadicNumber& b) {
    return DyadicNumber(a.value - b.value);
  }
  friend DyadicNumber operator*(const DyadicNumber& a, const DyadicNumber& b) {
    return DyadicNumber(a.value * b.value);
  }
  friend DyadicNumber magnitude(const DyadicNumber& a) {
    return DyadicNumber(a.value.sign() == CGAL::NEGATIVE ? -a.value : a.value);
  }
  friend bool operator>(const DyadicNumber& a, const DyadicNumber& b) { return a.value > b.value; }
  friend bool operator>=(const DyadicNumber& a, const DyadicNumber& b) { return !(a.value < b.value); }
};

}  // namespace axiscert

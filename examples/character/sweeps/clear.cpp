#include "examples/character/sweeps/clear.h"

#include "exact/numbers/enclosed.h"
#include "exact/trait/exact_number.h"
#include "kernel/moving_sphere/twenty.h"

namespace axiscert::character {
namespace {

// An enclosure as a number type of the formulae: a comparison holds where it is certain.
struct Certain {
  EnclosedNumber<double> x{0, 0};

  Certain() = default;
  explicit Certain(double value) : x{value, 0} {}
  explicit Certain(const EnclosedNumber<double>& enclosed) : x(enclosed) {}

  bool is_zero() const { return x.value == 0 && x.error == 0; }
  friend Certain operator+(const Certain& a, const Certain& b) { return Certain(a.x + b.x); }
  friend Certain operator-(const Certain& a, const Certain& b) { return Certain(a.x - b.x); }
  // A product with an exact zero is one, as it is on floors that are at right angles to an axis.
  friend Certain operator*(const Certain& a, const Certain& b) {
    return a.is_zero() || b.is_zero() ? Certain() : Certain(a.x * b.x);
  }
  friend bool operator>(const Certain& a, const Certain& b) { return a.x.low() > b.x.high(); }
  friend bool operator>=(const Certain& a, const Certain& b) { return a.x.low() >= b.x.high(); }
};

template <class T>
MovingQuery<T> as_numbers(const MovingQuery<float>& q) {
  const Numbers<float> numbers = q;
  return MovingSphere::problem<T>([&](std::size_t k) { return T(double(numbers[k])); });
}

bool separates(ComparisonBits holds) { return verdict_of(moving_sphere_predicate(), holds) == Verdict::separated; }

}  // namespace

Clearance clearance_by_enclosures(const MovingQuery<float>& q) {
  ComparisonBits possible = 0;
  const auto see = [&](std::size_t i, const Certain& lhs, const Certain& rhs) {
    if (!(lhs.x.high() < rhs.x.low())) possible |= one_bit<ComparisonBits>(i);  // NaN: possible
  };
  const ComparisonBits certain = bits_of<moving_sphere::TwentyNonstrict, Certain>(as_numbers<Certain>(q), see);
  if (separates(certain)) return Clearance::clear;
  return separates(possible) ? Clearance::open : Clearance::contact;
}

bool is_clear_by_rationals(const MovingQuery<float>& q) {
  const auto ignore = [](std::size_t, const ExactNumber&, const ExactNumber&) {};
  return separates(bits_of<moving_sphere::TwentyNonstrict, ExactNumber>(as_numbers<ExactNumber>(q), ignore));
}

bool is_clear(const MovingQuery<float>& q) {
  const Clearance quick = clearance_by_enclosures(q);
  return quick == Clearance::open ? is_clear_by_rationals(q) : quick == Clearance::clear;
}

}  // namespace axiscert::character

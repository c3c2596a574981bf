#include "exact/moving_sphere/motion_distance.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Mpzf.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/squared_distance_3.h>

#include <boost/operators.hpp>
#include <utility>

// The distance of two triangles, degenerate ones included, was compared with least_distance() in this version alone.
static_assert(CGAL_VERSION_NR >= 1050500000 && CGAL_VERSION_NR < 1050600000, "axiscert is tested with CGAL 5.5");

namespace axiscert::moving_sphere {
namespace {

// over / under, of binary numbers, which have no common divisors to look for. Most of what CGAL computes on the way is
// whole, and is then computed as that; CGAL::Quotient multiplies denominators that are 1.
class Fraction : boost::ordered_field_operators1<Fraction>, boost::ordered_field_operators2<Fraction, int> {
 public:
  Fraction() = default;
  Fraction(int x) : over_(x) {}
  Fraction(double x) : over_(x) {}
  // A denominator of 1 is not copied.
  Fraction(const Fraction& other) : over_(other.over_), is_whole_(other.is_whole_) {
    if (!is_whole_) under_ = other.under_;
  }
  Fraction& operator=(const Fraction& other) {
    over_ = other.over_;
    is_whole_ = other.is_whole_;
    if (!is_whole_) under_ = other.under_;
    return *this;
  }
  Fraction(Fraction&&) = default;
  Fraction& operator=(Fraction&&) = default;
  ~Fraction() = default;

  Fraction& operator+=(const Fraction& other) { return add(other, other.over_); }
  Fraction& operator-=(const Fraction& other) { return add(other, -other.over_); }
  Fraction& operator*=(const Fraction& other) {
    over_ = over_ * other.over_;
    multiply_under(other);
    return *this;
  }
  Fraction& operator/=(const Fraction& other) {
    CGAL_assertion(other.over_.sign() != CGAL::ZERO);
    under_ = is_whole_ ? other.over_ : under_ * other.over_;
    is_whole_ = false;
    if (!other.is_whole_) over_ = over_ * other.under_;
    return *this;
  }
  Fraction operator-() const {
    Fraction result = *this;
    result.over_ = -over_;
    return result;
  }
  friend bool operator==(const Fraction& a, const Fraction& b) { return (a - b).sign() == CGAL::ZERO; }
  friend bool operator<(const Fraction& a, const Fraction& b) { return (a - b).sign() == CGAL::NEGATIVE; }
  friend bool operator==(const Fraction& a, int b) { return a == Fraction(b); }
  friend bool operator<(const Fraction& a, int b) { return a < Fraction(b); }
  friend bool operator>(const Fraction& a, int b) { return Fraction(b) < a; }

  CGAL::Sign sign() const { return is_whole_ ? over_.sign() : over_.sign() * under_.sign(); }

 private:
  // Adds `over` over the denominator of `other`.
  Fraction& add(const Fraction& other, const CGAL::Mpzf& over) {
    if (is_whole_ && other.is_whole_) {
      over_ = over_ + over;
    } else {
      const CGAL::Mpzf own = other.is_whole_ ? over_ : over_ * other.under_;
      over_ = own + (is_whole_ ? over : over * under_);
      multiply_under(other);
    }
    return *this;
  }
  void multiply_under(const Fraction& other) {
    if (other.is_whole_) return;
    under_ = is_whole_ ? other.under_ : under_ * other.under_;
    is_whole_ = false;
  }

  CGAL::Mpzf over_, under_;
  bool is_whole_ = true;  // the denominator is 1; else it is `under`, which is not 0 and may be negative
};

}  // namespace
}  // namespace axiscert::moving_sphere

namespace CGAL {

template <>
class Algebraic_structure_traits<axiscert::moving_sphere::Fraction>
    : public Algebraic_structure_traits_base<axiscert::moving_sphere::Fraction, Field_tag> {
 public:
  using Is_exact = Tag_true;
  using Is_numerical_sensitive = Tag_false;
};
template <>
class Real_embeddable_traits<axiscert::moving_sphere::Fraction>
    : public INTERN_RET::Real_embeddable_traits_base<axiscert::moving_sphere::Fraction, Tag_true> {
 public:
  using Fraction = axiscert::moving_sphere::Fraction;
  struct Sgn : public CGAL::cpp98::unary_function<Fraction, ::CGAL::Sign> {
    ::CGAL::Sign operator()(const Fraction& x) const { return x.sign(); }
  };
};

}  // namespace CGAL

namespace axiscert::moving_sphere {
namespace {

using SweptKernel = CGAL::Exact_predicates_exact_constructions_kernel;

template <class K>
typename K::FT swept_distance(const GivenMotion& q, double until = 1) {
  const auto point = [](const portable::Vec3<double>& v) { return typename K::Point_3(v.x, v.y, v.z); };
  const typename K::Point_3 from = point(q.p);
  typename K::Vector_3 way = q.to_is_end ? point(q.to) - from : point(q.to) - CGAL::ORIGIN;
  if (until != 1) way = way * typename K::FT(until);
  const typename K::Point_3 to = from + way;
  return CGAL::squared_distance(typename K::Triangle_3(point(q.a), point(q.b), point(q.c)),
                                typename K::Triangle_3(from, to, to));
}

}  // namespace

Rational swept_squared_distance(const GivenMotion& q) {
  const SweptKernel::FT distance = swept_distance<SweptKernel>(q);  // outlives the reference into it
  return CGAL::exact(distance);
}

// Intervals would never decide: the triangle of a path has two equal corners, and CGAL asks whether its sides are
// parallel.
int swept_distance_order(const GivenMotion& q, double until) {
  const Fraction r(q.r), distance = swept_distance<CGAL::Simple_cartesian<Fraction>>(q, until);
  return static_cast<int>((distance - r * r).sign());
}

}  // namespace axiscert::moving_sphere

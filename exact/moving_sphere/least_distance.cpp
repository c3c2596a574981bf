#include "exact/moving_sphere/least_distance.h"

#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace axiscert::moving_sphere {
namespace {

using Integer = mpz_class;
using Vector = portable::Vec3<Integer>;
using portable::cross;
using portable::dot;

// The triangle seen from P, and D, all times 2^-exponent, which makes them integers.
struct IntegerMotion {
  std::array<Vector, 3> vertex;
  Vector d;
  int exponent;
};

// The exponent of a finite number's last bit, as if each had 53.
int last_bit(double x) {
  int exponent = 0;
  std::frexp(x, &exponent);
  return exponent - std::numeric_limits<double>::digits;
}

IntegerMotion integer_motion(const MovingQuery<double>& q) {
  IntegerMotion motion{{}, {}, std::numeric_limits<int>::max()};
  for (const auto& v : {q.a, q.b, q.c, q.p, q.d}) {
    for (const double x : {v.x, v.y, v.z}) {
      if (x != 0) motion.exponent = std::min(motion.exponent, last_bit(x));
    }
  }
  const auto integer = [&](double x) {
    if (x == 0) return Integer(0);
    int exponent = 0;
    const double fraction = std::frexp(x, &exponent);
    Integer whole(std::ldexp(fraction, std::numeric_limits<double>::digits));
    const int up = exponent - std::numeric_limits<double>::digits - motion.exponent;
    mpz_mul_2exp(whole.get_mpz_t(), whole.get_mpz_t(), static_cast<mp_bitcnt_t>(up));
    return whole;
  };
  const auto vector = [&](const portable::Vec3<double>& v) { return Vector{integer(v.x), integer(v.y), integer(v.z)}; };
  const Vector p = vector(q.p);
  motion.vertex = {vector(q.a) - p, vector(q.b) - p, vector(q.c) - p};
  motion.d = vector(q.d);
  return motion;
}

Rational quotient(const Integer& numerator, const Integer& denominator) {
  Rational q(numerator, denominator);
  q.canonicalize();
  return q;
}

// The times in [0, 1] at which all gates are open.
class Interval {
 public:
  // The gate value + slope t >= 0.
  void pass(const Integer& value, const Integer& slope) {
    if (empty_) return;
    if (slope == 0) {
      empty_ = value < 0;
      return;
    }
    const Rational zero = quotient(-value, slope);
    if (slope > 0) low_ = std::max(low_, zero);
    else high_ = std::min(high_, zero);
    empty_ = low_ > high_;
  }
  bool is_empty() const { return empty_; }

  // The least of (a t^2 - 2 b t + c) / divisor, which is nowhere negative, over a non-empty interval. If a is 0 so is
  // b.
  Rational least(const Integer& a, const Integer& b, const Integer& c, const Integer& divisor) const {
    if (a == 0) return quotient(c, divisor);
    const Rational t = std::max(low_, std::min(high_, quotient(b, a)));
    return ((a * t - 2 * b) * t + c) / divisor;
  }

 private:
  Rational low_ = 0, high_ = 1;
  bool empty_ = false;
};

class LeastOver {
 public:
  explicit LeastOver(const IntegerMotion& motion) : motion_(motion), d_(motion.d) {
    normal_ = cross(at(1) - at(0), at(2) - at(0));
    for (std::size_t i = 0; i < 3; ++i) {
      vertex(at(i), at(i + 1), at(i + 2));
      edge(at(i), at(i + 1));
    }
    face();
  }
  LeastDistance result() const {
    LeastDistance found{*least_, crosses_the_face()};
    // Squares of lengths: times 2^(2 exponent).
    const int twice = 2 * motion_.exponent;
    if (twice >= 0) mpq_mul_2exp(found.squared.get_mpq_t(), found.squared.get_mpq_t(), static_cast<mp_bitcnt_t>(twice));
    else mpq_div_2exp(found.squared.get_mpq_t(), found.squared.get_mpq_t(), static_cast<mp_bitcnt_t>(-twice));
    return found;
  }

 private:
  const Vector& at(std::size_t i) const { return motion_.vertex[i % 3]; }

  void offer(Rational squared) {
    if (!least_ || squared < *least_) least_ = std::move(squared);
  }

  // Nearest is the vertex where it is beyond neither of its edges' planes: A_t.AB >= 0 and A_t.AC >= 0.
  void vertex(const Vector& a, const Vector& b, const Vector& c) {
    Interval open;
    for (const Vector& along : {b - a, c - a}) open.pass(dot(a, along), -dot(d_, along));
    if (!open.is_empty()) offer(open.least(dot(d_, d_), dot(a, d_), dot(a, a), 1));
  }

  // Nearest is a point inside the edge where the foot is on it, and outside the face.
  void edge(const Vector& a, const Vector& b) {
    const Vector along = b - a, n = cross(a, along), m = cross(d_, along);
    const Integer e = dot(along, along);
    if (e == 0) return;
    Interval open;
    open.pass(-dot(a, along), dot(d_, along));
    open.pass(dot(b, along), -dot(d_, along));
    open.pass(-dot(n, normal_), dot(m, normal_));
    if (!open.is_empty()) offer(open.least(dot(m, m), dot(n, m), dot(n, n), e));
  }

  void face() {
    const Integer v = dot(normal_, normal_);
    if (v == 0) return;
    Interval open;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector along = at(i + 1) - at(i);
      open.pass(dot(cross(at(i), along), normal_), -dot(cross(d_, along), normal_));
    }
    const Integer offset = dot(at(0), normal_), m = dot(d_, normal_);
    if (!open.is_empty()) offer(open.least(m * m, offset * m, offset * offset, v));
  }

  bool crosses_the_face() const {
    const Integer offset = dot(at(0), normal_), m = dot(d_, normal_);
    const int forwards = sgn(m);
    if (forwards == 0 || forwards * sgn(offset) <= 0 || abs(offset) >= abs(m)) return false;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector along = at(i + 1) - at(i);
      const Integer side = m * dot(cross(at(i), along), normal_) - offset * dot(cross(d_, along), normal_);
      if (forwards * sgn(side) <= 0) return false;
    }
    return true;
  }

  const IntegerMotion& motion_;
  const Vector& d_;
  Vector normal_;
  std::optional<Rational> least_;
};

}  // namespace

LeastDistance least_distance(const MovingQuery<double>& q) {
  IntegerMotion motion = integer_motion(q);
  if (motion.exponent == std::numeric_limits<int>::max()) motion.exponent = 0;  // all numbers are 0
  return LeastOver(motion).result();
}

}  // namespace axiscert::moving_sphere

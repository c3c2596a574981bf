#include "fuzz/sphere_triangle/capability_parts.h"

#include <mpfr.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "exact/judge/side_error.h"
#include "exact/numbers/rational.h"
#include "exact/sphere_triangle/measures/input_class.h"
#include "exact/sphere_triangle/measures/nearest_place.h"
#include "exact/sphere_triangle/oracles/exact_truth.h"
#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "fuzz/confirm/witness.h"
#include "fuzz/queries/capabilities.h"
#include "fuzz/text/number_text.h"
#include "kernel/formulae_list.h"
#include "kernel/sphere_triangle/names.h"

namespace axiscert {
namespace {

class SphereTriangleClasses final : public InputClasses {
 public:
  std::vector<std::string_view> of(const Numbers<float>& q) const override { return names<float>(q); }
  std::vector<std::string_view> of(const Numbers<double>& q) const override { return names<double>(q); }

 private:
  template <class Real>
  static std::vector<std::string_view> names(const Query<Real>& q) {
    std::vector<std::string_view> all;
    for (const InputClass which : input_classes(q, squared_distance(q))) all.push_back(input_class_names[which]);
    return all;
  }
};

}  // namespace

const InputClasses& sphere_triangle_input_classes() {
  static const SphereTriangleClasses classes;
  return classes;
}

const NearestFeatures& sphere_triangle_nearest_features() {
  static constexpr NearestFeatures features = {
      [](const Numbers<double>& q) { return nearest_place(query_from(q)).features; }};
  return features;
}

// The sizes in a query of sphere-triangle with which a kernel may compare an absolute number.

namespace {

constexpr std::array<Quantity, 19> size_names = {{{"the distance d", 1},
                                                  {"r", 1},
                                                  {"|d - r|", 1},
                                                  {"|d^2 - r^2|", 2},
                                                  {"|AB x AC|", 2},
                                                  {"the shortest edge", 1},
                                                  {"the edge next to P", 1},
                                                  {"the longest edge", 1},
                                                  {"the distance from P to the nearest vertex", 1},
                                                  {"the distance from P to the farthest vertex", 1},
                                                  {"the greatest coordinate", 1, true},
                                                  {"the least determinant of P with an edge and the normal", 4},
                                                  {"AP . (AB x AC)", 3},
                                                  {"(AP . V)^2 - r^2 V^2, with V = AB x AC", 6},
                                                  {"the distance to the plane", 1},
                                                  {"AB", 1},
                                                  {"BC", 1},
                                                  {"CA", 1},
                                                  {"FAB + FBC + FCA - ABC, of areas and the foot F of P", 2}}};

double length_of(const Vec3<double>& v) { return std::sqrt(dot(v, v)); }

double squared_distance_to(const Vec3<double>& u, const Vec3<double>& v) {
  const Vec3<double> w = v - u;
  const double along = -dot(u, w), whole = dot(w, w);
  const double t = along <= 0 ? 0 : along >= whole ? 1 : along / whole;
  const Vec3<double> nearest = u + w * t;
  return dot(nearest, nearest);
}

// By how much the areas of the triangles of the foot of P and an edge exceed that of ABC; 0 where the foot is in it,
// but for rounding. The vertices are seen from P.
double excess_of_areas(const std::array<Vec3<double>, 3>& v, const Vec3<double>& normal) {
  const double squared = dot(normal, normal);
  if (squared == 0) return 0;
  const Vec3<double> foot = normal * (dot(v[0], normal) / squared);
  double excess = -std::sqrt(squared);
  for (std::size_t i = 0; i < 3; ++i) excess += length_of(cross(v[i] - foot, v[(i + 1) % 3] - foot));
  return excess > 0x1p-40 * std::sqrt(squared) ? excess / 2 : 0;
}

std::vector<double> values_of(const Query<double>& q) {
  const Rational exact_square = squared_distance(q), radius = exact(q.r);
  const double dd = nearest<double>(exact_square), d = std::sqrt(dd);
  const double gap = std::abs(nearest<double>(Rational(exact_square - radius * radius)));
  const std::array<Vec3<double>, 3> v = {q.a - q.p, q.b - q.p, q.c - q.p};
  const Vec3<double> normal = cross(v[1] - v[0], v[2] - v[0]);
  std::array<double, 3> edges, vertices, sides;
  std::size_t next_to = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t to = (i + 1) % 3, last = next_to;
    edges[i] = length_of(v[to] - v[i]);
    vertices[i] = length_of(v[i]);
    sides[i] = dot(cross(v[i], v[to]), normal);
    if (squared_distance_to(v[i], v[to]) < squared_distance_to(v[last], v[(last + 1) % 3])) next_to = i;
  }
  double greatest = 0;
  for (const auto& point : {q.a, q.b, q.c, q.p}) {
    greatest = std::max({greatest, std::abs(point.x), std::abs(point.y), std::abs(point.z)});
  }
  const double offset = dot(v[0], normal), ee = dot(normal, normal);
  const auto [least_edge, greatest_edge] = std::minmax_element(edges.begin(), edges.end());
  const auto [least_vertex, greatest_vertex] = std::minmax_element(vertices.begin(), vertices.end());
  return {d,
          q.r,
          d + q.r > 0 ? gap / (d + q.r) : 0,
          gap,
          std::sqrt(ee),
          *least_edge,
          edges[next_to],
          *greatest_edge,
          *least_vertex,
          *greatest_vertex,
          greatest,
          *std::min_element(sides.begin(), sides.end()),
          std::abs(offset),
          std::abs(offset * offset - q.r * q.r * ee),
          ee > 0 ? std::abs(offset) / std::sqrt(ee) : 0,
          edges[0],
          edges[1],
          edges[2],
          excess_of_areas(v, normal)};
}

}  // namespace

const Quantities& sphere_triangle_quantities() {
  static constexpr Quantities quantities = {
      size_names, [](std::size_t, const Numbers<double>& q) { return values_of(query_from(q)); }};
  return quantities;
}

namespace {

long bit_length(const mpz_class& x) { return sgn(x) == 0 ? 0 : static_cast<long>(mpz_sizeinbase(x.get_mpz_t(), 2)); }

// The value lhs / denominator or sqrt(lhs) / denominator, minus `rhs` / denominator, to 17 significant digits. A dyadic
// value without a root is held exactly before it is printed, so it is rounded once. Elsewhere 64 bits are kept beyond
// twice the operands' own: the difference of a root of b bits and a rational is zero or at least 2^-2b of them.
std::string digits_of(const Rational& lhs, bool rooted, const Rational& rhs, const Rational& denominator) {
  const Rational difference = lhs - rhs;
  if (rooted && sgn(rhs) >= 0 && lhs == rhs * rhs) return "0";
  const Rational& widest = rooted ? lhs : difference;
  const long bits = bit_length(widest.get_num()) + bit_length(widest.get_den()) + bit_length(rhs.get_num()) +
                    bit_length(rhs.get_den()) + bit_length(denominator.get_num()) + bit_length(denominator.get_den());
  mpfr_t value;
  mpfr_init2(value, 2 * bits + 64);
  if (rooted) {
    mpfr_set_q(value, lhs.get_mpq_t(), MPFR_RNDN);
    mpfr_sqrt(value, value, MPFR_RNDN);
    mpfr_sub_q(value, value, rhs.get_mpq_t(), MPFR_RNDN);
    mpfr_div_q(value, value, denominator.get_mpq_t(), MPFR_RNDN);
  } else {
    mpfr_set_q(value, Rational(difference / denominator).get_mpq_t(), MPFR_RNDN);
  }
  char* text = nullptr;
  mpfr_asprintf(&text, "%.17Rg", value);
  const std::string digits = text;
  mpfr_free_str(text);
  mpfr_clear(value);
  return digits;
}

// 2^(e - p + 1) for 2^e <= |x| < 2^(e + 1), and never below the least subnormal number.
template <class Real>
Rational unit_in_last_place(const Rational& x) {
  using Limits = std::numeric_limits<Real>;
  long exponent = Limits::min_exponent - 1;
  if (sgn(x) != 0) {
    // 2^(bits - 1) < |x| < 2^(bits + 1): one comparison decides which half.
    const Rational magnitude = abs(x);
    const long bits = bit_length(magnitude.get_num()) - bit_length(magnitude.get_den());
    const Rational power =
        bits < 0 ? Rational(1, mpz_class(1) << static_cast<unsigned long>(-bits)) : Rational(mpz_class(1) << bits);
    exponent = std::max(exponent, magnitude < power ? bits - 1 : bits);
  }
  exponent -= Limits::digits - 1;
  return exponent < 0 ? Rational(1, mpz_class(1) << static_cast<unsigned long>(-exponent))
                      : Rational(mpz_class(1) << exponent);
}

// Below this, binary64 has fewer than six digits: the result is 1e-300, which is still rounded up and negligible beside
// any ulp.
constexpr double least_error = 1e-300;

ErrorNumber error_number(const Decimal6& d) {
  const double value = d.value();
  if (d.is_zero()) return {};
  return std::isfinite(value) ? ErrorNumber{std::max(value, least_error)} : ErrorNumber{value, d.text()};
}

// Empty if the computed side is not finite.
template <class Real>
std::optional<ErrorNumber> error_ulps(double computed, const Rational& exact_side) {
  if (!std::isfinite(computed)) return std::nullopt;
  return error_number(
      round_up(Rational(abs(Rational(exact(computed) - exact_side)) / unit_in_last_place<Real>(exact_side))));
}

template <class Real>
SidesRecord sides_of(const ExactComparison& sides, const std::optional<ShownSides>& computed, std::size_t i) {
  SidesRecord record;
  const Rational lhs = rational(sides.lhs.over), rhs = rational(sides.rhs.over),
                 denominator = rational(sides.rhs.under);
  const bool has_sizes = !sides.is_undefined && !sides.is_times_root;
  if (has_sizes) {
    record.exact = {digits_of(lhs, sides.is_rooted, 0, denominator), digits_of(rhs, false, 0, denominator),
                    digits_of(lhs, sides.is_rooted, rhs, denominator)};
  }
  if (!computed) return record;
  const auto l = static_cast<Real>(computed->lhs[i]), r = static_cast<Real>(computed->rhs[i]);
  record.computed = {format_number(l), format_number(r)};
  if (!has_sizes) return record;
  if (!sides.is_rooted) record.lhs_ulps = error_ulps<Real>(computed->lhs[i], lhs / denominator);
  record.rhs_ulps = error_ulps<Real>(computed->rhs[i], rhs / denominator);
  const SideError error(l, r, sides);
  if (error.kind() == SideError::Kind::finite) record.error_u = error_number(error.rounded_up());
  return record;
}

ComparisonBits worth_showing(const Judgement& judgement, ComparisonBits largest_errors) {
  ComparisonBits which = largest_errors;
  for (const Flip& flip : judgement.flips()) {
    if (flip.level == Level::axis) which |= comparisons_of(static_cast<Axis>(flip.index));
    if (flip.level == Level::comparison) which |= comparisons_of(comparisons[flip.index].axis);
  }
  return which == 0 && judgement.verdict_flip ? ComparisonBits{0xFFFF} : which;
}

class SphereTriangleSides final : public WitnessSides {
 public:
  std::optional<NamedValues<SidesRecord>> of(const Numbers<float>& q, const Kernel& kernel, const Examination& found,
                                             ComparisonBits largest_errors) const override {
    return sides<float>(q, kernel, found, largest_errors);
  }
  std::optional<NamedValues<SidesRecord>> of(const Numbers<double>& q, const Kernel& kernel, const Examination& found,
                                             ComparisonBits largest_errors) const override {
    return sides<double>(q, kernel, found, largest_errors);
  }

 private:
  template <class Real>
  static std::optional<NamedValues<SidesRecord>> sides(const Query<Real>& q, const Kernel& kernel,
                                                       const Examination& found, ComparisonBits largest_errors) {
    if (found.truth.verdict == Verdict::invalid || !has_comparisons(formulae_of(kernel))) return std::nullopt;
    const ExactSides exact = exact_sides(formulae_of(kernel), q);
    NamedValues<SidesRecord> all;
    const ComparisonBits which = worth_showing(found.judgement, largest_errors);
    for (std::size_t i = 0; i < comparison_count; ++i) {
      if (has_bit(which, i)) {
        all.put(comparisons[i].name) = sides_of<Real>(exact.comparison(i), found.sides, i);
      }
    }
    return all;
  }
};

}  // namespace

const WitnessSides& sphere_triangle_witness_sides() {
  static const SphereTriangleSides sides;
  return sides;
}

}  // namespace axiscert

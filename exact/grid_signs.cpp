// Why the signs are the published ones. A, B, C are relative to the centre, N1 = A x B, N2 = B x C, N3 = C x A, and
// V = N1 + N2 + N3. All sixteen comparisons depend on the six dot products of A, B, C and on rr alone: by Binet and
// Cauchy, (a x b).(c x d) = (a.c)(b.d) - (a.d)(b.c), the dot products of N1, N2, N3 are cofactors of the matrix of
// those, and d^2 = (A.V)^2 = det(A, B, C)^2 is its determinant.
//
// vertex.*      as published
// plane.radius  as published: d^2 > rr |V|^2
// edge.radius   |N1|^2 > rr e with e = |AB|^2. The published pair has e times as much on both sides, e |N1|^2 > rr e e:
//               no sign changes where e > 0. Where e = 0, A = B and N1 = 0: 0 and 0, a tie, in both pairs.
// edge.side     0 > N1.V. The published lhs is -e (N1.V): the same where e > 0; where e = 0, N1 = 0, and both tie.
//
// kernel/rungs/reduced.h has the last two as formulae. Each comparison is homogeneous, so that a power of two common to
// all differences and the radius changes no sign.
#include "exact/grid_signs.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <type_traits>

#include "exact/wide_integer.h"

namespace axiscert {
namespace {

// Let |x| <= M = 2^n for the nine coordinates of A, B, C and for r. Then |A|, |B|, |C| <= sqrt(3) M, |N| <= 3 M^2, and
// with all partial sums
// - degree 2: |a.b| <= 3 M^2, e = (aa + bb) - 2 ab <= 12 M^2, so with a sign 2n + 5 bits;
// - degree 4: N.N <= 9 M^4, N.V <= 27 M^4, |V|^2 <= 81 M^4, rr e <= 12 M^4, |N|^2 - rr e <= 12 M^4: 4n + 8 bits;
// - degree 6: d^2 <= 27 M^6 by partial sums <= 81 M^6, rr |V|^2 <= 81 M^6, and so their difference: 6n + 8 bits.
// A product of two numbers is exact in the sum of their words, whatever they are.
constexpr bool fits(int n, int words) {
  return 2 * n + 5 <= 64 * words && 4 * n + 8 <= 128 * words && 6 * n + 8 <= 192 * words;
}
static_assert(fits(grid_bits(1), 1) && fits(grid_bits(2), 2) && fits(grid_bits(3), 3) && fits(grid_bits(4), 4));

// A, B, C relative to the centre, and r.
template <class Integer>
using Centred = std::array<Integer, 10>;

template <std::size_t words>
Signs signs_in(const Centred<std::conditional_t<(words <= 2), std::int64_t, Int128>>& q) {
  using enum Comparison;
  using Degree2 = WideInteger<words>;
  using Degree4 = WideInteger<2 * words>;
  using Degree6 = WideInteger<3 * words>;
  // A coordinate has n bits and a sign, and half as many words hold 32 (words + words % 2) >= n + 1.
  using Coordinate = WideInteger<(words + 1) / 2>;
  const auto product = [](const Coordinate& x, const Coordinate& y) AXISCERT_WORDS_INLINE {
    if constexpr (words % 2 == 0) return x * y;
    else return Degree2(x * y);
  };
  const auto dot = [&](std::size_t u, std::size_t v) AXISCERT_WORDS_INLINE {
    const auto term = [&](std::size_t i)
                          AXISCERT_WORDS_INLINE { return product(Coordinate(q[u + i]), Coordinate(q[v + i])); };
    return (term(0) + term(1)) + term(2);
  };
  const Degree2 aa = dot(0, 0), ab = dot(0, 3), ac = dot(0, 6), bb = dot(3, 3), bc = dot(3, 6), cc = dot(6, 6);
  const Degree2 rr = product(Coordinate(q[9]), Coordinate(q[9]));

  const Degree4 n11 = aa * bb - ab * ab, n22 = bb * cc - bc * bc, n33 = cc * aa - ac * ac;
  const Degree4 n12 = ab * bc - ac * bb, n23 = bc * ac - ab * cc, n31 = ac * ab - bc * aa;
  const Degree4 n1v = n11 + n12 + n31, n2v = n12 + n22 + n23, n3v = n31 + n23 + n33;
  const Degree4 vv = n1v + n2v + n3v;
  const Degree6 dd = cc * n11 + ac * n12 + bc * n31;

  Signs signs{0, 0};
  const auto emit = [&](Comparison which, const auto& difference) AXISCERT_WORDS_INLINE {
    const auto i = static_cast<unsigned>(which);
    const bool zero = difference.is_zero();
    signs.strict |= static_cast<ComparisonBits>(static_cast<unsigned>(!zero && !difference.is_negative()) << i);
    signs.ties |= static_cast<ComparisonBits>(static_cast<unsigned>(zero) << i);
  };
  emit(plane_radius, dd - rr * vv);
  emit(vertex_a_radius, aa - rr);
  emit(vertex_a_side_b, ab - aa);
  emit(vertex_a_side_c, ac - aa);
  emit(vertex_b_radius, bb - rr);
  emit(vertex_b_side_a, ab - bb);
  emit(vertex_b_side_c, bc - bb);
  emit(vertex_c_radius, cc - rr);
  emit(vertex_c_side_a, ac - cc);
  emit(vertex_c_side_b, bc - cc);
  const Degree4 zero(std::int64_t{0});
  emit(edge_ab_radius, n11 - rr * (aa + bb - (ab + ab)));
  emit(edge_ab_side_c, zero - n1v);
  emit(edge_bc_radius, n22 - rr * (bb + cc - (bc + bc)));
  emit(edge_bc_side_a, zero - n2v);
  emit(edge_ca_radius, n33 - rr * (cc + aa - (ac + ac)));
  emit(edge_ca_side_b, zero - n3v);
  return signs;
}

// The numbers without their signs as they are stored, which orders them by magnitude.
template <class Real>
using Magnitude = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;
template <class Real>
Magnitude<Real> magnitude(Real x) {
  return std::bit_cast<Magnitude<Real>>(x) & (~Magnitude<Real>{0} >> 1);
}

// The exponent of a magnitude's last place, 2^exponent.
template <class Real>
int unit_exponent(Magnitude<Real> magnitude) {
  using Limits = std::numeric_limits<Real>;
  return std::max(static_cast<int>(magnitude >> (Limits::digits - 1)), 1) + (Limits::min_exponent - Limits::digits - 1);
}

// The exponent of the least bit that is set in any of the numbers, which are not all zero.
template <class Real>
int least_set_bit(const std::array<Real, coordinate_count>& numbers) {
  constexpr Magnitude<Real> hidden = Magnitude<Real>{1} << (std::numeric_limits<Real>::digits - 1);
  int least = std::numeric_limits<Real>::max_exponent;
  for (const Real x : numbers) {
    const Magnitude<Real> stored = magnitude(x);
    if (stored == 0) continue;
    const Magnitude<Real> significand = stored < hidden ? stored : ((stored & (hidden - 1)) | hidden);
    least = std::min(least, unit_exponent<Real>(stored) + std::countr_zero(significand));
  }
  return least;
}

template <class Integer>
struct Grid {
  Centred<Integer> centred;
  int bits;  // of the greatest magnitude
};

int bit_width(std::uint64_t x) { return static_cast<int>(std::bit_width(x)); }
int bit_width(UInt128 x) {
  const auto high = static_cast<std::uint64_t>(x >> 64);
  return high != 0 ? 64 + bit_width(high) : bit_width(static_cast<std::uint64_t>(x));
}
int trailing_zeros(std::uint64_t x) { return std::countr_zero(x); }
int trailing_zeros(UInt128 x) {
  const auto low = static_cast<std::uint64_t>(x);
  return low != 0 ? std::countr_zero(low) : 64 + std::countr_zero(static_cast<std::uint64_t>(x >> 64));
}

// 2^e, a normal number.
double power_of_two(int e) { return std::bit_cast<double>(static_cast<std::uint64_t>(e + 1023) << 52); }

// An integer below 2^(bits of Integer - 2): in two words, its multiple of 2^63 and the rest, both of which are exact.
template <class Integer>
Integer integer_from(double x) {
  const auto whole = [](double y) { return static_cast<std::int64_t>(y); };
  if constexpr (sizeof(Integer) == 8) {
    return whole(x);
  } else {
    const std::int64_t high = whole(x * 0x1p-63);
    return Int128{high} * (Int128{1} << 63) + whole(x - static_cast<double>(high) * 0x1p63);
  }
}

// In units of 2^unit: the numbers are multiples of it, and below 2^(bits of Integer - 2) of it, so that differences do
// not overflow. A number that is not zero is in [2^unit, 2^(unit + 126)), and unit in [-1074, 1023]; so both halves of
// the scaling give numbers between 2^-537 and 2^639, where no binary64 loses a bit. What powers of two the differences
// have in common is then taken out: they may have fewer bits than the numbers that they were made of.
template <class Integer, class Real>
Grid<Integer> grid(const std::array<Real, coordinate_count>& numbers, int unit) {
  using Unsigned = std::conditional_t<sizeof(Integer) == 8, std::uint64_t, UInt128>;
  const double scale = power_of_two(-(unit / 2)), rest = power_of_two(unit / 2 - unit);
  const auto integer = [&](std::size_t i) AXISCERT_WORDS_INLINE {
    return integer_from<Integer>((static_cast<double>(numbers[i]) * scale) * rest);
  };
  const std::array<Integer, 3> p = {integer(9), integer(10), integer(11)};
  Grid<Integer> result;
  Unsigned all = 0;
  words::for_each_index<10>([&](auto i) AXISCERT_WORDS_INLINE {
    const Integer x = i < 9 ? integer(i) - p[i % 3] : integer(12);
    result.centred[i] = x;
    all |= static_cast<Unsigned>(x < 0 ? -x : x);
  });
  const int common = all == 0 ? 0 : trailing_zeros(all);
  for (Integer& x : result.centred) x >>= common;
  result.bits = bit_width(all) - common;
  return result;
}

// Calls with_grid(grid) with the narrowest integers that hold the numbers, or returns nothing.
template <class Real, class WithGrid>
auto on_grid(const Query<Real>& q, WithGrid&& with_grid) -> decltype(with_grid(Grid<std::int64_t>{})) {
  constexpr int digits = std::numeric_limits<Real>::digits;
  const auto numbers = coordinates(q);
  Magnitude<Real> greatest = 0, least = ~Magnitude<Real>{0};  // least: of those that are not zero, less 1
  words::for_each_index<coordinate_count>([&](auto i) AXISCERT_WORDS_INLINE {
    const Magnitude<Real> stored = magnitude(numbers[i]);
    greatest = std::max(greatest, stored);
    least = std::min<Magnitude<Real>>(least, stored - 1u);
  });
  if (greatest == 0) return with_grid(Grid<std::int64_t>{{}, 0});
  const int top = unit_exponent<Real>(greatest) + digits;  // all magnitudes are below 2^top
  const int unit = unit_exponent<Real>(least + 1u);
  if (top - unit <= 62) return with_grid(grid<std::int64_t>(numbers, unit));
  const int finest = least_set_bit(numbers);
  if (top - finest <= 126) return with_grid(grid<Int128>(numbers, finest));
  return std::nullopt;
}

template <class To, class From>
Centred<To> converted(const Centred<From>& from) {
  Centred<To> to;
  for (std::size_t i = 0; i < to.size(); ++i) to[i] = static_cast<To>(from[i]);
  return to;
}

std::optional<Signs> signs_of(const Grid<std::int64_t>& grid) {
  if (grid.bits <= grid_bits(1)) return signs_in<1>(grid.centred);
  if (grid.bits <= grid_bits(2)) return signs_in<2>(grid.centred);
  static_assert(grid_bits(3) >= 63);
  return signs_in<3>(converted<Int128>(grid.centred));
}

std::optional<Signs> signs_of(const Grid<Int128>& grid) {
  if (grid.bits <= grid_bits(2)) return signs_of({converted<std::int64_t>(grid.centred), grid.bits});
  if (grid.bits <= grid_bits(3)) return signs_in<3>(grid.centred);
  if (grid.bits <= grid_bits(4)) return signs_in<4>(grid.centred);
  return std::nullopt;
}

}  // namespace

template <class Real>
std::optional<Signs> grid_signs(const Query<Real>& q) {
  return on_grid(q, [](const auto& grid) { return signs_of(grid); });
}
template std::optional<Signs> grid_signs<float>(const Query<float>&);
template std::optional<Signs> grid_signs<double>(const Query<double>&);

template <class Real>
std::optional<int> bits_on_grid(const Query<Real>& q) {
  return on_grid(q, [](const auto& grid) -> std::optional<int> { return grid.bits; });
}
template std::optional<int> bits_on_grid<float>(const Query<float>&);
template std::optional<int> bits_on_grid<double>(const Query<double>&);

}  // namespace axiscert

// Proof that the signs are the published ones. All sixteen comparisons depend on the six dot products of A, B, C and on
// rr alone (exact/sphere_triangle/oracles/gram.h).
//
// vertex.*      as published
// plane.radius  as published: d^2 > rr |V|^2
// edge.radius   |N1|^2 > rr e with e = |AB|^2. The published pair has e times as much on both sides, e |N1|^2 > rr e e:
//               no sign changes where e > 0. Where e = 0, A = B and N1 = 0: 0 and 0, a tie, in both pairs.
// edge.side     0 > N1.V. The published lhs is -e (N1.V): the same where e > 0; where e = 0, N1 = 0, and both tie.
//
// kernel/sphere_triangle/forms/reduced.h implements the last two. Each comparison is homogeneous, so that a power of
// two common to all differences and the radius changes no sign.
#include "exact/sphere_triangle/oracles/grid_signs.h"

#include <cmath>

#include "exact/sphere_triangle/oracles/grid.h"

namespace axiscert {
namespace {

static_assert(fits_in_words(grid_bits(1), 1) && fits_in_words(grid_bits(2), 2) && fits_in_words(grid_bits(3), 3) &&
              fits_in_words(grid_bits(4), 4));

template <class Numbers>
Signs signs_in(const CentredNumbers<typename Numbers::GivenInteger>& q) {
  using enum Comparison;
  const Gram<Numbers> g(q);
  Signs signs{0, 0};
  const auto emit = [&](Comparison which, const auto& difference) AXISCERT_WORDS_INLINE {
    const auto i = static_cast<unsigned>(which);
    const bool zero = difference.is_zero();
    signs.strict |= static_cast<SignBits>(static_cast<unsigned>(!zero && !difference.is_negative()) << i);
    signs.ties |= static_cast<SignBits>(static_cast<unsigned>(zero) << i);
  };
  using Degree4 = typename Numbers::Degree4;
  emit(plane_radius, g.dd - g.rr * g.vv);
  emit(vertex_a_radius, g.aa - g.rr);
  emit(vertex_a_side_b, g.ab - g.aa);
  emit(vertex_a_side_c, g.ac - g.aa);
  emit(vertex_b_radius, g.bb - g.rr);
  emit(vertex_b_side_a, g.ab - g.bb);
  emit(vertex_b_side_c, g.bc - g.bb);
  emit(vertex_c_radius, g.cc - g.rr);
  emit(vertex_c_side_a, g.ac - g.cc);
  emit(vertex_c_side_b, g.bc - g.cc);
  const Degree4 zero(std::int64_t{0});
  emit(edge_ab_radius, g.n11 - g.rr * g.edge2(g.aa, g.ab, g.bb));
  emit(edge_ab_side_c, zero - g.n1v);
  emit(edge_bc_radius, g.n22 - g.rr * g.edge2(g.bb, g.bc, g.cc));
  emit(edge_bc_side_a, zero - g.n2v);
  emit(edge_ca_radius, g.n33 - g.rr * g.edge2(g.cc, g.ac, g.aa));
  emit(edge_ca_side_b, zero - g.n3v);
  return signs;
}

template <class Integer>
struct Grid {
  CentredNumbers<Integer> centred;  // in units of 2^unit
  int bits = 0;                     // bits of the greatest magnitude
  int unit = 0;
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

// An integer below 2^(bits of Integer - 2): if two words are needed, its multiple of 2^63 and the remainder, both of
// which are exact.
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

// The query in units of 2^unit: the numbers are multiples of the unit, and below 2^(bits of Integer - 2) units, so that
// differences do not overflow. A number that is not zero is in [2^unit, 2^(unit + 126)), and unit in [-1074, 1023]; so
// both halves of the scaling give numbers between 2^-537 and 2^639, where no binary64 loses a bit. Powers of two that
// all differences have in common are then divided out: the differences may have fewer bits than the numbers they were
// made from.
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
  result.unit = unit + common;
  return result;
}

// Calls with_grid(grid) with the narrowest integers that hold the numbers, or returns an empty value if none do.
template <class Real, class WithGrid>
auto on_grid(const Query<Real>& q, WithGrid&& with_grid) -> decltype(with_grid(Grid<std::int64_t>{})) {
  constexpr int digits = std::numeric_limits<Real>::digits;
  const auto numbers = coordinates(q);
  Magnitude<Real> greatest = 0, least = ~Magnitude<Real>{0};  // least: of those that are not zero, minus 1
  words::for_each_index<coordinate_count>([&](auto i) AXISCERT_WORDS_INLINE {
    const Magnitude<Real> stored = magnitude(numbers[i]);
    greatest = std::max(greatest, stored);
    least = std::min<Magnitude<Real>>(least, stored - 1u);
  });
  if (greatest == 0) return with_grid(Grid<std::int64_t>{});
  const int top = unit_exponent<Real>(greatest) + digits;  // all magnitudes are below 2^top
  const int unit = unit_exponent<Real>(least + 1u);
  if (top - unit <= 62) return with_grid(grid<std::int64_t>(numbers, unit));
  const int finest = least_set_bit(numbers);
  if (top - finest <= 126) return with_grid(grid<Int128>(numbers, finest));
  return std::nullopt;
}

template <class To, class From>
CentredNumbers<To> converted(const CentredNumbers<From>& from) {
  CentredNumbers<To> to;
  for (std::size_t i = 0; i < to.size(); ++i) to[i] = static_cast<To>(from[i]);
  return to;
}

std::optional<Signs> signs_of(const Grid<std::int64_t>& grid) {
  if (grid.bits <= grid_bits(1)) return signs_in<FixedWords<1>>(grid.centred);
  if (grid.bits <= grid_bits(2)) return signs_in<FixedWords<2>>(grid.centred);
  static_assert(grid_bits(3) >= 63);
  return signs_in<FixedWords<3>>(converted<Int128>(grid.centred));
}

std::optional<Signs> signs_of(const Grid<Int128>& grid) {
  if (grid.bits <= grid_bits(2)) return signs_of({converted<std::int64_t>(grid.centred), grid.bits});
  if (grid.bits <= grid_bits(3)) return signs_in<FixedWords<3>>(grid.centred);
  if (grid.bits <= grid_bits(4)) return signs_in<FixedWords<4>>(grid.centred);
  return std::nullopt;
}

// The signs of a query whose radius is positive, but so small that it cannot change a comparison between nonzero
// numbers: the signs are those with the radius 0, except that a tie of a radius comparison at radius 0 remains a tie
// only if its other side is zero as well. With differences of at most n bits in units of 2^k, the lhs of a radius
// comparison in the forms above is an integer, A.A, |N|^2 or d^2, and its rhs is rr times 1, e <= 12 2^(2n) or |V|^2 <=
// 81 2^(4n). So for r < 2^-(2n + 4) units the rhs is below 1: less than any lhs but zero. Mesh queries include spheres
// with the least positive radius.
template <class Real>
std::optional<Signs> signs_at_tiny_radius(const Query<Real>& q) {
  if (q.r == 0) return std::nullopt;
  Query<Real> at_zero = q;
  at_zero.r = 0;
  return on_grid(at_zero, [&](const auto& grid) -> std::optional<Signs> {
    if (std::ilogb(q.r) + 1 > grid.unit - 2 * grid.bits - 4) return std::nullopt;
    std::optional<Signs> signs = signs_of(grid);
    if (!signs) return std::nullopt;
    const AxisBits without_normal = axes_without_normal(*signs);
    for (std::size_t i = 0; i < comparison_count; ++i) {
      const bool is_side = has_bit(side_comparisons, i);
      const bool is_zero = has_bit(without_normal, comparisons[i].axis);
      if (!is_side && !is_zero) signs->ties &= static_cast<SignBits>(~one_bit<SignBits>(i));
    }
    return signs;
  });
}

}  // namespace

template <class Real>
std::optional<Signs> grid_signs(const Query<Real>& q) {
  if (const auto few = on_grid(q, [](const auto& grid) { return signs_of(grid); })) return few;
  return signs_at_tiny_radius(q);
}
template std::optional<Signs> grid_signs<float>(const Query<float>&);
template std::optional<Signs> grid_signs<double>(const Query<double>&);

template <class Real>
Signs integer_signs(const Query<Real>& q) {
  const auto few = grid_signs(q);
  return few ? *few : signs_in<AnyGrid<Real>>(on_any_grid(q).centred);
}
template Signs integer_signs<float>(const Query<float>&);
template Signs integer_signs<double>(const Query<double>&);

template <class Real>
std::optional<int> bits_on_grid(const Query<Real>& q) {
  return on_grid(q, [](const auto& grid) -> std::optional<int> { return grid.bits; });
}
template std::optional<int> bits_on_grid<float>(const Query<float>&);
template std::optional<int> bits_on_grid<double>(const Query<double>&);

}  // namespace axiscert

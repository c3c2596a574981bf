// Boxes without a special place, of small integers, and of numbers of every size.
#include <bit>
#include <limits>

#include "fuzz/boxes/parts.h"

namespace axiscert::boxes {
namespace {

struct General {
  template <class Pair>
  static Pair make(Stream& random, std::uint64_t position) {
    return anywhere<Pair>(random, position);
  }
};

// Integers of up to 2, 5 or 40 in turn: half of the queries overlap, and many touch.
struct Lattice {
  template <class Pair>
  static Pair make(Stream& random, std::uint64_t position) {
    using Real = RealOf<Pair>;
    const std::int64_t bound = lattice_bound(position);
    Pair q{};
    const auto fill = [&](auto& box) {
      for (Real* x : {&box.centre.x, &box.centre.y, &box.centre.z}) {
        *x = static_cast<Real>(random.integer(-bound, bound));
      }
      for (Real& s : box.half) s = static_cast<Real>(random.integer(0, bound));
      turn_by_quarters(random, box);
    };
    fill(q.a);
    fill(q.b);
    return q;
  }
};

// B at half or at twice the distance of touching, then every length times a power of two: from that which leaves one
// bit of a subnormal to that at which numbers below 32 just remain finite.
struct Scale {
  template <class Pair>
  static Pair make(Stream& random, std::uint64_t position) {
    using Real = RealOf<Pair>;
    using Limits = std::numeric_limits<Real>;
    Pair q = anywhere<Pair>(random, position);
    solve_tangent(q, random.coin() ? Rational(2) : Rational(1, 2));
    constexpr int least = Limits::min_exponent - Limits::digits, greatest = Limits::max_exponent - 5;
    const int power = least + static_cast<int>(position % static_cast<unsigned>(greatest - least + 1));
    scale_by_power(q.a, power);
    scale_by_power(q.b, power);
    return q;
  }
};

// A finite pattern of bits: every exponent equally likely. Infinities and NaNs are mapped to [1, 2).
template <class Real>
Real finite_pattern(Stream& random) {
  using Word = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;
  constexpr Word above_fraction = Word{1} << (std::numeric_limits<Real>::digits - 1),
                 exponent = (~Word{0} >> 1) & ~(above_fraction - 1), top = (~Word{0} >> 1) + 1;
  Word pattern;
  if constexpr (sizeof(Real) == 4) pattern = random.word();
  else pattern = random.bits();
  if ((pattern & exponent) == exponent) pattern ^= top >> 1;
  return std::bit_cast<Real>(pattern);
}

// Centres and half extents of any bits; the rotations are those of general, and every fourth time of any bits too.
struct Bits {
  template <class Pair>
  static Pair make(Stream& random, std::uint64_t position) {
    using Real = RealOf<Pair>;
    Pair q = anywhere<Pair>(random, position);
    const auto fill = [&](auto& box) {
      for (Real* x : {&box.centre.x, &box.centre.y, &box.centre.z}) *x = finite_pattern<Real>(random);
      for (Real& s : box.half) s = std::abs(finite_pattern<Real>(random));
      if (position % 4 == 3) fill_turn(random, box);
    };
    fill(q.a);
    fill(q.b);
    return q;
  }

 private:
  template <class Real>
  static void fill_turn(Stream& random, OrientedBox<Real>& box) {
    for (Vec3<Real>& v : box.axis) {
      for (Real* x : {&v.x, &v.y, &v.z}) *x = finite_pattern<Real>(random);
    }
  }
  template <class Real>
  static void fill_turn(Stream& random, TurnedBox<Real>& box) {
    for (Real& x : box.q) x = finite_pattern<Real>(random);
  }
};

constexpr Family costly(Family family) {
  family.cost = 20;
  return family;
}

}  // namespace

extern const Family box_box_general_family = matrix_family<General>(
    "box-box/general", box_box_situation::everyday,
    "any two rotations, rounded; half extents 0.5 to 1.5, centres up to 2 apart in each coordinate");
extern const Family box_box_lattice_family =
    matrix_family<Lattice>("box-box/lattice", box_box_situation::small_integers,
                           "small integers and signed permutations: nothing is rounded", true);
extern const Family box_box_scale_family = matrix_family<Scale>(
    "box-box/scale", box_box_situation::units,
    "clear queries (half or twice the distance of touching), lengths times every power of two in turn");
extern const Family box_box_bits_family = costly(matrix_family<Bits>(
    "box-box/bits", box_box_situation::no_rotation,
    "uniform finite bit patterns for centres and half extents, every fourth time for the axes too"));

extern const Family box_box_general_turned_family = turned_family<General>(
    "box-box/general_turned", box_box_situation::everyday, "general, as quaternions of integers");
extern const Family box_box_lattice_turned_family =
    turned_family<Lattice>("box-box/lattice_turned", box_box_situation::small_integers,
                           "small integers and quarter turns as quaternions", true);

}  // namespace axiscert::boxes

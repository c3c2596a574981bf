// Two boxes along the axes, each by two corners: anywhere, of small integers, touching, and decided by one axis,
// clearly.
#include "fuzz/boxes/clear.h"
#include "fuzz/boxes/upright.h"

namespace axiscert::boxes {
namespace {

constexpr int upright_attempts = 24;

// Boxes of ordinary size, along the axes.
template <class Real>
BoxPair<Real> upright_boxes(Stream& random, std::uint64_t position) {
  auto q = of_ordinary_size<BoxPair<Real>>(random, position);
  for (auto* box : {&q.a, &q.b}) box->axis = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  return q;
}

struct UprightAnywhere {
  template <class Pair>
  static Pair make(Stream& random, std::uint64_t position) {
    using Real = RealOf<Pair>;
    BoxPair<Real> q = upright_boxes<Real>(random, position);
    place_beside(random, q);
    return by_corners(q);
  }
};

// Integers of up to 2, 5 or 40 in turn.
struct UprightLattice {
  template <class Pair>
  static Pair make(Stream& random, std::uint64_t position) {
    using Real = RealOf<Pair>;
    const std::int64_t bound = lattice_bound(position);
    Pair q{};
    for (CornersBox<Real>* box : {&q.a, &q.b}) {
      for (const auto& [low, high] : {std::pair(&box->low.x, &box->high.x), std::pair(&box->low.y, &box->high.y),
                                      std::pair(&box->low.z, &box->high.z)}) {
        *low = static_cast<Real>(random.integer(-bound, bound));
        *high = *low + static_cast<Real>(random.integer(0, bound));
      }
    }
    return q;
  }
};

// On each axis in turn a corner of B has the coordinate of one of A, every other time but for up to two ulps; on the
// other two they overlap.
struct UprightTouching {
  template <class Pair>
  static Pair make(Stream& random, std::uint64_t position) {
    using Real = RealOf<Pair>;
    Pair q = by_corners(upright_boxes<Real>(random, position / 6));
    const std::size_t axis = position / 2 % 3;
    const bool is_above = random.coin();
    const std::array<Real*, 3> low = {&q.b.low.x, &q.b.low.y, &q.b.low.z},
                               high = {&q.b.high.x, &q.b.high.y, &q.b.high.z};
    const std::array<Real, 3> low_a = {q.a.low.x, q.a.low.y, q.a.low.z}, high_a = {q.a.high.x, q.a.high.y, q.a.high.z};
    for (std::size_t k = 0; k < 3; ++k) {
      const Real size = *high[k] - *low[k], room = high_a[k] - low_a[k] + size;
      *low[k] = low_a[k] - size + room * (Real(0.125) + random.unit<Real>() * Real(0.75));
      *high[k] = *low[k] + size;
      const int ulps = position % 2 == 1 ? static_cast<int>(random.integer(-2, 2)) : 0;
      if (k != axis) continue;
      if (is_above) {
        *low[k] = step_ulps(high_a[k], ulps);
        *high[k] = *low[k] + size;
      } else {
        *high[k] = step_ulps(low_a[k], ulps);
        *low[k] = *high[k] - size;
      }
    }
    return q;
  }
};

// Boxes where the wish is met, each as `change` leaves it; a box of one axis is one of the three.
template <class Real, class Change>
CornersPair<Real> decided_uprights(Stream& random, std::uint64_t position, const ClearWish& wish,
                                   const Change& change) {
  return by_corners(best_of(random, upright_attempts, [&](Stream& from) {
    BoxPair<Real> q = upright_boxes<Real>(from, position);
    change(from, q);
    return placed_box(from, q, wish);
  }));
}

struct UprightOneAxis {
  template <class Pair>
  static Pair make(Stream& random, std::uint64_t position) {
    using Real = RealOf<Pair>;
    return decided_uprights<Real>(random, position, wish_in_turn<Real>(random, position / 3, position % 3),
                                  [](Stream&, BoxPair<Real>&) {});
  }
};

// B is 2^-10 to 2^10 times as large as A, in turn: so many digits of the smaller one its corners keep.
struct UprightSpans {
  template <class Pair>
  static Pair make(Stream& random, std::uint64_t position) {
    using Real = RealOf<Pair>;
    constexpr int most = 10, count = 2 * most + 1;
    const std::uint64_t round = position / count;
    const int power = static_cast<int>(position % count) - most;
    const double smaller = std::ldexp(1.0, -std::abs(power));
    ClearWish wish{round % 3, round % 2 == 0 ? Side::apart : Side::in_contact};
    wish.enough = smaller / 32;
    if (random.coin()) wish.most = smaller / 2;
    return decided_uprights<Real>(random, position, wish, [&](Stream&, BoxPair<Real>& q) {
      for (Real& s : q.b.half) s = std::ldexp(s, power);
    });
  }
};

// In turn A without one extent, B as well, and a rod.
struct UprightPlates {
  template <class Pair>
  static Pair make(Stream& random, std::uint64_t position) {
    using Real = RealOf<Pair>;
    const std::uint64_t kind = position % 3, round = position / 3;
    const ClearWish wish{round % 3, round % 2 == 0 ? Side::apart : Side::in_contact, 0.25, 0.01};
    return decided_uprights<Real>(random, position, wish, [&](Stream& from, BoxPair<Real>& q) {
      const auto of_a = from.below(3), of_b = from.below(3);
      q.a.half[of_a] = 0;
      if (kind == 1) q.b.half[of_b] = 0;
      if (kind == 2) q.a.half[next(of_a)] = 0;
    });
  }
};

// A base of images in other units of length.
template <class Real>
Numbers<Real> unit_uprights(Stream& random, std::uint64_t base) {
  const Side side = (base + base / 3) % 3 == 2 ? Side::in_contact : Side::apart;
  return numbers_of(decided_uprights<Real>(random, 0, {base % 3, side}, [](Stream&, BoxPair<Real>&) {}));
}

template <class Real>
TurnedPair<Real> beside_upright(Stream& random, std::uint64_t position) {
  auto q = of_ordinary_size<TurnedPair<Real>>(random, position);
  q.a.q = {1, 0, 0, 0};
  turn(q.b, random_turn(random));
  place_beside(random, q);
  return q;
}

struct MixedAnywhere {
  template <class Pair>
  static Pair make(Stream& random, std::uint64_t position) {
    return with_corners(beside_upright<RealOf<Pair>>(random, position));
  }
};

// B on the ray from A's centre at the farthest place of contact, but for up to two ulps.
struct MixedTangent {
  template <class Pair>
  static Pair make(Stream& random, std::uint64_t position) {
    auto q = beside_upright<RealOf<Pair>>(random, position);
    solve_tangent(q);
    nudge(random, 2, q);
    return with_corners(q);
  }
};

// Integers of up to 2, 5 or 40 in turn, B turned by quarter turns.
struct MixedLattice {
  template <class Pair>
  static Pair make(Stream& random, std::uint64_t position) {
    using Real = RealOf<Pair>;
    const std::int64_t bound = lattice_bound(position);
    const auto place = [&] {
      const auto x = random.integer(-bound, bound), y = random.integer(-bound, bound),
                 z = random.integer(-bound, bound);
      return Vec3<Real>{static_cast<Real>(x), static_cast<Real>(y), static_cast<Real>(z)};
    };
    const auto extents = [&] {
      const auto x = random.integer(0, bound), y = random.integer(0, bound), z = random.integer(0, bound);
      return Vec3<Real>{static_cast<Real>(x), static_cast<Real>(y), static_cast<Real>(z)};
    };
    Pair q{};
    q.a.low = place();
    q.a.high = q.a.low + extents();
    q.b.centre = place();
    const Vec3<Real> half = extents();
    q.b.half = {half.x, half.y, half.z};
    turn_by_quarters(random, q.b);
    return q;
  }
};

template <class Real>
MixedPair<Real> decided_mixed(Stream& random, std::uint64_t position, const ClearWish& wish) {
  return with_corners(best_of(random, upright_attempts, [&](Stream& from) {
    auto q = of_ordinary_size<TurnedPair<Real>>(from, position);
    q.a.q = {1, 0, 0, 0};
    turn_quickly(q.b, random_turn(from));
    return placed_box(from, q, wish);
  }));
}

struct MixedOneAxis {
  template <class Pair>
  static Pair make(Stream& random, std::uint64_t position) {
    using Real = RealOf<Pair>;
    const ClearWish wish = wish_in_turn<Real>(random, position / axis_count, position % axis_count);
    return decided_mixed<Real>(random, position, wish);
  }
};

template <class Real>
Numbers<Real> unit_mixed(Stream& random, std::uint64_t base) {
  const Side side = (base + base / axis_count) % 3 == 2 ? Side::in_contact : Side::apart;
  return numbers_of(decided_mixed<Real>(random, 0, {base % axis_count, side}));
}

}  // namespace

extern const Family box_box_general_minmax_family = upright_family<UprightAnywhere>(
    "box-box/general_minmax", box_box_situation::everyday, "general, both along the axes, by two corners");
extern const Family box_box_lattice_minmax_family =
    upright_family<UprightLattice>("box-box/lattice_minmax", box_box_situation::small_integers,
                                   "small integers, by two corners: nothing is rounded", true);
extern const Family box_box_touching_minmax_family = upright_family<UprightTouching>(
    "box-box/touching_minmax", box_box_situation::touching,
    "a coordinate of a corner of B is one of A's on each axis in turn; every other one up to 2 ulps");
extern const Family box_box_one_axis_minmax_family = upright_family<UprightOneAxis>(
    "box-box/one_axis_minmax", box_box_situation::everyday, "one_axis, both along the axes, by two corners");
extern const Family box_box_units_minmax_family =
    family_of_units<MinmaxBoxes, unit_uprights<float>, unit_uprights<double>>(
        "box-box/units_minmax", box_box_situation::units, "units, both along the axes, by two corners");
extern const Family box_box_spans_minmax_family =
    upright_family<UprightSpans>("box-box/spans_minmax", box_box_situation::sizes,
                                 "B is 2^-10 to 2^10 times as large as A, by two corners; one axis decides, clearly");
extern const Family box_box_plates_minmax_family =
    upright_family<UprightPlates>("box-box/plates_minmax", box_box_situation::flat,
                                  "one or two extents are 0, by two corners; one axis decides, clearly");

extern const Family box_box_general_mixed_family =
    upright_family<MixedAnywhere, MixedBoxes>("box-box/general_mixed", box_box_situation::everyday,
                                              "general, A along the axes by two corners, B by a quaternion");
extern const Family box_box_lattice_mixed_family = upright_family<MixedLattice, MixedBoxes>(
    "box-box/lattice_mixed", box_box_situation::small_integers,
    "small integers, A by two corners, B by quarter turns as quaternions: nothing is rounded", true);
extern const Family box_box_tangent_mixed_family =
    upright_family<MixedTangent, MixedBoxes>("box-box/tangent_mixed", box_box_situation::touching,
                                             "tangent, A along the axes by two corners, B by a quaternion");
extern const Family box_box_one_axis_mixed_family = upright_family<MixedOneAxis, MixedBoxes>(
    "box-box/one_axis_mixed", box_box_situation::everyday, "one_axis, A by two corners, B by a quaternion");
extern const Family box_box_units_mixed_family = family_of_units<MixedBoxes, unit_mixed<float>, unit_mixed<double>>(
    "box-box/units_mixed", box_box_situation::units, "units, A by two corners, B by a quaternion");

}  // namespace axiscert::boxes

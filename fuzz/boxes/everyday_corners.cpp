// Crates of a game by two corners, in metres: on one another, on a floor, and beside crates and walls. A body's
// farthest points in a direction lie on the other's, or as far from there as a solver leaves them: then the direction
// decides.
#include "fuzz/boxes/everyday.h"
#include "fuzz/boxes/upright.h"

namespace axiscert::boxes {
namespace {

constexpr Quaternion straight = {1, 0, 0, 0};

// A is along the world's axes: in turn a crate, a floor 64 m wide, and a crate or a wall of 3 to 50 m. B is a crate or
// a character, on the first two and beside the third: along the axes too or, `is_turned`, at any yaw and tilted by what
// a solver leaves, where a facet of B decides every other time.
template <class Real>
TurnedPair<Real> crates(Stream& random, std::uint64_t position, bool is_turned) {
  constexpr std::uint64_t kinds = 3;
  const std::uint64_t kind = position / gap_count % kinds;
  TurnedPair<Real> q{};
  const Real x = random.unit<Real>(), y = random.unit<Real>(), z = random.unit<Real>();
  const bool is_wall = random.coin(), is_first = random.coin(), is_behind = random.coin(), by_own = random.coin();
  set_crate(random, q.a.half);
  set_body(random, q.b.half);
  if (kind == 1) q.a.half = {32, Real(0.5), 32};
  if (kind == 2 && is_wall)
    q.a.half = {Real(1.5) + Real(23.5) * x * x, Real(1.25) + Real(0.75) * y, Real(0.05) + Real(0.15) * z};
  q.a.centre = rounded_arrow<Real>(scenes::place(random, position / (kinds * gap_count)));
  const Quaternion yaw = any_yaw(random), left = disturbance(random);
  turn(q.a, straight);
  turn(q.b, is_turned ? unit_quaternion<Real>(product(yaw, left)) : straight);

  const double gap = gap_in_turn(random, position);
  const std::size_t axis = kind < 2 ? 1 : is_first ? 0 : 2;
  const Arrow side = unit_facet(box_in_doubles(is_turned && by_own ? q.b : q.a), axis);
  lay_on(random, q, kind == 2 && is_behind ? side * -1.0 : side, gap);
  return q;
}

struct UprightCrates {
  template <class Pair>
  static Pair make(Stream& random, std::uint64_t position) {
    const auto q = crates<RealOf<Pair>>(random, position, false);
    Pair pair = {corners_of_upright(q.a), corners_of_upright(q.b)};
    in_any_order(random, pair);
    return pair;
  }
};

struct MixedCrates {
  template <class Pair>
  static Pair make(Stream& random, std::uint64_t position) {
    return with_corners(crates<RealOf<Pair>>(random, position, true));
  }
};

}  // namespace

extern const Family box_box_crates_minmax_family = in_metres(upright_family<UprightCrates>(
    "box-box/crates_minmax", box_box_situation::everyday,
    "metres: crates and characters along the axes, by two corners, on one another, on a floor and at walls, half "
    "within 1 cm of touching"));
extern const Family box_box_crates_mixed_family = in_metres(upright_family<MixedCrates, MixedBoxes>(
    "box-box/crates_mixed", box_box_situation::everyday,
    "metres: crates and characters by quaternions on crates, floors and at walls by two corners, half within 1 cm of "
    "touching"));

}  // namespace axiscert::boxes

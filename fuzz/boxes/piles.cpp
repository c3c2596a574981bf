// Boxes as an engine has them at rest: crates in stacks, walls and piles, and on a floor, in metres. A rotation is a
// quaternion that was brought to length 1 in floats, as after a step; a matrix is made of it in floats.
#include <algorithm>

#include "fuzz/boxes/everyday.h"

namespace axiscert::boxes {
namespace {

// The world is 128 m wide and 32 m high.
template <class Real>
Vec3<Real> place_in_world(Stream& random) {
  const Real x = random.symmetric<Real>(), y = random.unit<Real>(), z = random.symmetric<Real>();
  return {x * 64, y * 32, z * 64};
}

// The gap that a solver leaves between two crates: sunk in by up to a hundredth of a metre, seldom apart by as much.
template <class Real>
Real left_between(Stream& random) {
  const auto power = static_cast<int>(random.integer(7, 14));
  const bool is_apart = random.below(8) == 0;
  const Real by = std::ldexp(Real(1), -power);
  return is_apart ? by : -by;
}

// In turn: a crate on another, on a floor 64 m wide, beside another in a wall, and two crates above one another with
// one between them.
struct Stack {
  template <class Pair>
  static Pair make(Stream& random, std::uint64_t position) {
    using Real = RealOf<Pair>;
    Pair q{};
    set_crate(random, q.a.half);
    const bool is_alike = random.coin();
    if (is_alike) q.b.half = q.a.half;
    else set_crate(random, q.b.half);
    q.a.centre = place_in_world<Real>(random);
    const Quaternion yaw = any_yaw(random);
    const std::uint64_t kind = position % 4;
    Quaternion of_a = product(yaw, disturbance(random)), of_b = product(yaw, disturbance(random));
    if (kind == 1) {
      q.a.half = {32, Real(0.5), 32};
      q.a.centre.y = Real(-0.5);
      of_a = {1, 0, 0, 0};
    }
    turn_in_floats(q.a, unit_quaternion<Real>(of_a));
    turn_in_floats(q.b, unit_quaternion<Real>(of_b));
    const Real x = random.symmetric<Real>(), z = random.symmetric<Real>(), by = left_between<Real>(random);
    const Real quarter = std::min(q.a.half[0], q.b.half[0]) / 4;
    q.b.centre = {q.a.centre.x + x * quarter, q.a.centre.y + (q.a.half[1] + q.b.half[1] + by),
                  q.a.centre.z + z * quarter};
    if (kind == 1) q.b.centre.x = q.a.centre.x + x * 16;
    if (kind == 2) {
      // Along A's own first axis, which is level but for the disturbance.
      place(q, of_a, {Rational(static_cast<double>(q.a.half[0] + q.b.half[0] + by)), 0, 0});
    }
    if (kind == 3) q.b.centre.y += q.a.half[1] * 2;
    return q;
  }
};

// Crates that lean on each other at any angle, where they touch in the direction of their centres, then sunk in or
// apart.
struct Pile {
  template <class Pair>
  static Pair make(Stream& random, std::uint64_t) {
    using Real = RealOf<Pair>;
    Pair q{};
    set_crate(random, q.a.half);
    set_crate(random, q.b.half);
    q.a.centre = place_in_world<Real>(random);
    turn_in_floats(q.a, unit_quaternion<Real>(random_turn(random)));
    turn_in_floats(q.b, unit_quaternion<Real>(random_turn(random)));
    const Real x = random.symmetric<Real>(), y = random.symmetric<Real>(), z = random.symmetric<Real>();
    q.b.centre = q.a.centre + Vec3<Real>{x, y, z};
    solve_tangent(q, 1 + Rational(static_cast<double>(left_between<Real>(random))));
    return q;
  }
};

// Orthogonal columns of any length: M(q) of small integers, and its columns once or twice as long. Integers alone.
struct IntScaled {
  template <class Pair>
  static Pair make(Stream& random, std::uint64_t position) {
    using Real = RealOf<Pair>;
    Pair q{};
    const auto fill = [&](OrientedBox<Real>& box) {
      std::array<Real, 4> turn;
      for (Real& x : turn) x = static_cast<Real>(random.integer(-1, 1));
      if (turn[0] == 0 && turn[1] == 0 && turn[2] == 0 && turn[3] == 0) turn[0] = 1;
      box.axis = turn_of(turn).column;
      for (Vec3<Real>& v : box.axis) v = v * static_cast<Real>(1 + random.below(2));
      for (Real& s : box.half) s = static_cast<Real>(random.integer(0, 3));
    };
    fill(q.a);
    fill(q.b);
    const std::int64_t far = std::array<std::int64_t, 3>{4, 12, 24}[position % 3];
    for (Real* x : {&q.b.centre.x, &q.b.centre.y, &q.b.centre.z}) *x = static_cast<Real>(random.integer(-far, far));
    return q;
  }
};

}  // namespace

extern const Family box_box_stack_family = in_metres(matrix_family<Stack>(
    "box-box/stack", box_box_situation::everyday,
    "crates in metres as a solver leaves them: on another, on a floor, in a wall, and one between"));
extern const Family box_box_pile_family =
    in_metres(matrix_family<Pile>("box-box/pile", box_box_situation::everyday,
                                  "crates in metres that lean on each other at any angle, sunk in by up to 1 cm"));
extern const Family box_box_int_scaled_family = matrix_family<IntScaled>(
    "box-box/int_scaled", box_box_situation::no_rotation,
    "integer columns at right angles that are not of length 1: the textbook is wrong by itself");
extern const Family box_box_stack_turned_family =
    in_metres(turned_family<Stack>("box-box/stack_turned", box_box_situation::everyday, "stack, as quaternions"));
extern const Family box_box_pile_turned_family =
    in_metres(turned_family<Pile>("box-box/pile_turned", box_box_situation::everyday, "pile, as quaternions"));

}  // namespace axiscert::boxes

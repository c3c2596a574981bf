// Two boxes of a game, in metres: crates on ramps and planks, fallen beams, and crates, characters and doors at walls.
// One body's farthest points in a direction lie on the other's, or as far from there as a solver leaves them: then the
// direction decides.
#include "fuzz/boxes/everyday.h"

namespace axiscert::boxes {
namespace {

// On a plank or a slab of 10 to 50 m that rises by 5 to 45 degrees, in turn: along it but for a small yaw, at any yaw
// on it, and upright. What lies on it is flush with it every other time, else tilted by what a solver leaves.
struct Ramp {
  template <class Pair>
  static Pair make(Stream& random, std::uint64_t position) {
    using Real = RealOf<Pair>;
    constexpr std::uint64_t kinds = 3;
    const std::uint64_t kind = position / gap_count % kinds;
    Pair q{};
    const bool is_slab = random.coin(), rises = random.coin(), is_flush = random.coin();
    const Real x = random.unit<Real>(), y = random.unit<Real>(), z = random.unit<Real>();
    if (is_slab) q.a.half = {5 + 20 * x, Real(0.1) + Real(0.4) * y, 5 + 20 * z};
    else q.a.half = {1 + 4 * x, Real(0.01) + Real(0.09) * y, Real(0.5) + z};
    set_crate(random, q.b.half);
    q.a.centre = rounded_arrow<Real>(scenes::place(random, position / (kinds * gap_count)));

    const Quaternion yaw = any_yaw(random), of_crate = any_yaw(random), left = disturbance(random);
    const auto slope = static_cast<double>(random.integer(90, 848));  // the tangent of half the angle times 2048
    const Quaternion frame = product(yaw, {2048, 0, 0, rises ? slope : -slope});
    turn_in_floats(q.a, unit_quaternion<Real>(frame));
    const Quaternion yawed = kind == 0 ? product(frame, {left[0], 0, left[2], 0}) : product(frame, of_crate);
    const Quaternion on_it = is_flush ? yawed : product(kind == 0 ? frame : yawed, left);
    turn_in_floats(q.b, unit_quaternion<Real>(kind == 2 ? of_crate : on_it));
    const double gap = gap_in_turn(random, position);
    lay_on(random, q, unit_facet(box_in_doubles(q.a), 1), gap);
    in_any_order(random, q);
    return q;
  }
};

// Beams 2 to 6 m long on one another, each turned about its length so that an edge is up: two edges cross, at 2^-3 to
// 2^-14 or, every fourth time, at any angle.
struct Beams {
  template <class Pair>
  static Pair make(Stream& random, std::uint64_t position) {
    using Real = RealOf<Pair>;
    Pair q{};
    for (auto* half : {&q.a.half, &q.b.half}) {
      const Real x = random.unit<Real>(), y = random.unit<Real>(), z = random.unit<Real>();
      *half = {1 + 2 * x, Real(0.03) + Real(0.12) * y, Real(0.03) + Real(0.12) * z};
    }
    q.a.centre = rounded_arrow<Real>(scenes::place(random, position / gap_count));
    const auto rolled = [&] {
      const auto w = static_cast<double>(random.integer(2048, 8192)),
                 x = static_cast<double>(random.integer(512, 2048));
      return Quaternion{w, x, 0, 0};
    };
    const Quaternion yaw = any_yaw(random), apart = any_yaw(random), roll_a = rolled(), roll_b = rolled();
    const double nearly = std::ldexp(1.0, static_cast<int>(random.integer(4, 15)));
    const Quaternion across = random.below(4) == 0 ? apart : Quaternion{nearly, 0, 1, 0};
    turn_in_floats(q.a, unit_quaternion<Real>(product(yaw, roll_a)));
    turn_in_floats(q.b, unit_quaternion<Real>(product(product(yaw, across), roll_b)));
    const double gap = gap_in_turn(random, position);
    const Arrow both = cross(box_in_doubles(q.a).axis[0], box_in_doubles(q.b).axis[0]);
    const Arrow up = scenes::at_unit_length(both);
    lay_on(random, q, up.y < 0 ? up * -1.0 : up, gap);
    in_any_order(random, q);
    return q;
  }
};

// All upright on one floor, along the world's axes every other time. In turn at a wall of 3 to 50 m: a crate or a
// character along it, exactly or but for a small yaw; one at any yaw; one whose side meets the wall's end; and the leaf
// of a door there.
struct Corridor {
  template <class Pair>
  static Pair make(Stream& random, std::uint64_t position) {
    using Real = RealOf<Pair>;
    constexpr std::uint64_t kinds = 4;
    const std::uint64_t kind = position / gap_count % kinds;
    Pair q{};
    const Real x = random.unit<Real>(), y = random.unit<Real>(), z = random.unit<Real>();
    q.a.half = {Real(1.5) + Real(23.5) * x * x, Real(1.25) + Real(0.75) * y, Real(0.05) + Real(0.15) * z};
    set_body(random, q.b.half);
    if (kind == 3) q.b.half = {Real(0.45), 1, Real(0.02)};
    q.a.centre = rounded_arrow<Real>(scenes::place(random, position / (kinds * gap_count)));

    const bool is_aligned = random.coin(), is_along = random.coin(), is_behind = random.coin(),
               by_first = random.coin();
    const Quaternion any = any_yaw(random), of_body = any_yaw(random), left = disturbance(random);
    const Quaternion yaw = is_aligned ? Quaternion{1, 0, 0, 0} : any;
    const Quaternion along = is_along ? yaw : product(yaw, {left[0], 0, left[2], 0});
    turn_in_floats(q.a, unit_quaternion<Real>(yaw));
    turn_in_floats(q.b, unit_quaternion<Real>(kind == 0 ? along : of_body));
    const double gap = gap_in_turn(random, position);
    const Arrow of_wall = unit_facet(box_in_doubles(q.a), kind == 3 ? 0 : 2);
    const Arrow side = kind == 2 ? unit_facet(box_in_doubles(q.b), by_first ? 0 : 2) : of_wall;
    lay_on(random, q, is_behind ? side * -1.0 : side, gap);
    q.b.centre.y = q.a.centre.y + (q.b.half[1] - q.a.half[1]);
    in_any_order(random, q);
    return q;
  }
};

}  // namespace

extern const Family box_box_ramp_family =
    in_metres(matrix_family<Ramp>("box-box/ramp", box_box_situation::everyday,
                                  "metres: crates on inclined planks and slabs of up to 50 m, along them, yawed or "
                                  "upright, half within 1 cm of resting"));
extern const Family box_box_beams_family = in_metres(matrix_family<Beams>(
    "box-box/beams", box_box_situation::everyday,
    "metres: beams on one another, edge on edge, most of them nearly along, half within 1 cm of touching"));
extern const Family box_box_corridor_family = in_metres(matrix_family<Corridor>(
    "box-box/corridor", box_box_situation::everyday,
    "metres: crates, characters and doors on a level floor at a wall of up to 50 m, half within 1 cm of touching"));
extern const Family box_box_ramp_turned_family =
    in_metres(turned_family<Ramp>("box-box/ramp_turned", box_box_situation::everyday, "ramp, as quaternions"));
extern const Family box_box_beams_turned_family =
    in_metres(turned_family<Beams>("box-box/beams_turned", box_box_situation::everyday, "beams, as quaternions"));
extern const Family box_box_corridor_turned_family = in_metres(
    turned_family<Corridor>("box-box/corridor_turned", box_box_situation::everyday, "corridor, as quaternions"));

}  // namespace axiscert::boxes

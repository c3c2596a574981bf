// Two boxes that one axis decides, clearly: each of the fifteen in turn, of ordinary boxes, in other units of length,
// of very different sizes, without a thickness, and aligned or nearly so.
#include "fuzz/boxes/clear.h"

namespace axiscert::boxes {

extern const std::array<ImageGroup, 2> symmetric_groups;  // symmetric.cpp
namespace {

constexpr int box_attempts = 24;

// Ordinary boxes, each turned by any rotation, where the wish is met.
template <class Pair>
Pair decided_boxes(Stream& random, std::uint64_t position, const ClearWish& wish) {
  return best_of(random, box_attempts, [&](Stream& from) {
    Pair q = of_ordinary_size<Pair>(from, position);
    turn_quickly(q.a, random_turn(from));
    turn_quickly(q.b, random_turn(from));
    return placed_box(from, q, wish);
  });
}

struct OneAxis {
  template <class Pair>
  static Pair make(Stream& random, std::uint64_t position) {
    const ClearWish wish = wish_in_turn<RealOf<Pair>>(random, position / axis_count, position % axis_count);
    return decided_boxes<Pair>(random, position, wish);
  }
};

// B is 2^-20 to 2^20 times as large as A, in turn. Every other round is decided by a part of the larger box where the
// axis allows it, the others by one of the smaller. Half of the rounds are tiny.
struct Spans {
  template <class Pair>
  static Pair make(Stream& random, std::uint64_t position) {
    constexpr int most = 20, count = 2 * most + 1;
    const std::uint64_t round = position / count;
    const int power = static_cast<int>(position % count) - most;
    const double smaller = std::ldexp(1.0, -std::abs(power));
    ClearWish wish{round % axis_count, round % 2 == 0 ? Side::apart : Side::in_contact};
    wish.enough = smaller / 32;
    if (random.coin()) wish.most = smaller / 2;
    Pair q = best_of(random, box_attempts, [&](Stream& from) {
      Pair made = of_ordinary_size<Pair>(from, position);
      for (auto& s : made.b.half) s = std::ldexp(s, power);
      turn_quickly(made.a, random_turn(from));
      turn_quickly(made.b, random_turn(from));
      return placed_box(from, made, wish);
    });
    const int unit = unit_in_turn<RealOf<Pair>>(round, power);
    scale_by_power(q.a, unit);
    scale_by_power(q.b, unit);
    return q;
  }
};

// In turn A without one half extent, or with one of a 2^-10th; then B as well; then a rod, which has two such. Any axis
// decides that such boxes have: an edge that is 0 spans no facet.
struct Plates {
  template <class Pair>
  static Pair make(Stream& random, std::uint64_t position) {
    using Real = RealOf<Pair>;
    const std::uint64_t kind = position % 6, round = position / 6;
    const Real thickness = kind % 2 == 0 ? Real(0) : Real(0x1p-10);
    const Side side = round % 3 == 2 ? Side::in_contact : Side::apart;
    return best_of(random, box_attempts, [&](Stream& from) {
      Pair q = of_ordinary_size<Pair>(from, position);
      const auto of_a = from.below(3), of_b = from.below(3), axis = from.below(axis_count);
      q.a.half[of_a] *= thickness;
      if (kind / 2 == 1) q.b.half[of_b] *= thickness;
      if (kind / 2 == 2) q.a.half[next(of_a)] *= thickness;
      turn_quickly(q.a, random_turn(from));
      turn_quickly(q.b, random_turn(from));
      return placed_box(from, q, {axis, side, 0.25, 0.01});
    });
  }
};

// Two bars on an edge that cross at an angle of 2^-k, k from 5 to 19 in turn, and up to 2^10 times as long as wide:
// the product of their edges decides, which is as short as the angle. Each of the nine products in turn.
template <class Pair>
Pair crossing(Stream& random, std::uint64_t position) {
  constexpr Quaternion on_an_edge = {33461, 13860, 0, 0};  // 45 degrees
  // The long edge is the last, the one before it or the first.
  static constexpr std::array<Quaternion, 3> cycle = {{{1, 1, 1, 1}, {1, -1, -1, -1}, {1, 0, 0, 0}}};
  const int flatness = 5 + static_cast<int>(position % 15);
  const std::uint64_t of_a = position / 30 % 3, of_b = position / 90 % 3;
  const std::size_t long_a = 2 - of_a, long_b = 2 - of_b;
  const ClearWish wish{edges(long_a, long_b), position / 15 % 2 == 0 ? Side::apart : Side::in_contact, 0.25,
                       std::ldexp(1.0, -flatness - 2)};
  return best_of(random, box_attempts, [&](Stream& from) {
    Pair q = of_ordinary_size<Pair>(from, position);
    const auto longer = static_cast<int>(from.integer(0, 10)), shorter = static_cast<int>(from.integer(0, 3));
    q.a.half[long_a] = std::ldexp(q.a.half[long_a], longer);
    q.b.half[long_b] = std::ldexp(q.b.half[long_b], longer - shorter);
    const Quaternion frame = random_turn(from);
    const double yaw = std::ldexp(2.0 + from.unit<double>(), flatness);
    turn_quickly(q.a, product(product(frame, on_an_edge), cycle[of_a]));
    turn_quickly(q.b, product(product(product(frame, {yaw, 0, 0, 1}), on_an_edge), cycle[of_b]));
    return placed_box(from, q, wish);
  });
}

// Both upright: axes along the world's third, and about it turned anyhow or not at all.
template <class Pair>
Pair upright_pair(Stream& random, std::uint64_t position) {
  const ClearWish wish{position % 6, position / 6 % 3 == 2 ? Side::in_contact : Side::apart};
  const auto yaw_of = [](Stream& from, bool any) {
    const auto w = static_cast<double>(from.integer(-3000, 3000)), z = static_cast<double>(from.integer(1, 3000));
    return any ? Quaternion{w, 0, 0, z} : Quaternion{1, 0, 0, 0};
  };
  return best_of(random, box_attempts, [&](Stream& from) {
    Pair q = of_ordinary_size<Pair>(from, position);
    turn_quickly(q.a, yaw_of(from, position / 18 % 2 == 0));
    turn_quickly(q.b, yaw_of(from, position / 36 % 2 == 0));
    return placed_box(from, q, wish);
  });
}

// B turned against A by a quarter turn or none, and from there by 2^-k about any axis, k from 4 to 25 in turn.
template <class Pair>
Pair nearly_aligned(Stream& random, std::uint64_t position) {
  static constexpr std::array<Quaternion, 4> quarter = {{{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 0, 1, 0}, {1, 0, 0, 1}}};
  const ClearWish wish{position % 6, position / 6 % 2 == 0 ? Side::in_contact : Side::apart};
  const double flatness = std::ldexp(1.0, 4 + static_cast<int>(position % 22));
  return best_of(random, box_attempts, [&](Stream& from) {
    Pair q = of_ordinary_size<Pair>(from, position);
    const Quaternion frame = random_turn(from), by = quarter[from.below(4)];
    const double x = from.symmetric<double>(), y = from.symmetric<double>(), z = from.symmetric<double>();
    turn_quickly(q.a, frame);
    turn_quickly(q.b, product(product(frame, by), {flatness, x, y, z}));
    return placed_box(from, q, wish);
  });
}

struct Aligned {
  template <class Pair>
  static Pair make(Stream& random, std::uint64_t position) {
    if (position % 2 == 0) return crossing<Pair>(random, position / 2);
    return position % 4 == 1 ? upright_pair<Pair>(random, position / 4) : nearly_aligned<Pair>(random, position / 4);
  }
};

// The scenes of one_axis, with quaternions of any length: in turn that of both boxes, of A and of B is integers times
// 2^-36 to 2^4. One in three has a half turn, whose w is 0 or small; every other one is negated.
struct Lengths {
  template <class Pair>
  static Pair make(Stream& random, std::uint64_t position) {
    using Real = RealOf<Pair>;
    constexpr int least = -36, count = 41;
    const std::uint64_t round = position / axis_count, which = round / count % 3;
    const ClearWish wish{position % axis_count, round % 3 == 2 ? Side::in_contact : Side::apart};
    const Real times = std::ldexp(Real(1), least + static_cast<int>(round % count));
    return best_of(random, box_attempts, [&](Stream& from) {
      Pair q = of_ordinary_size<Pair>(from, position);
      turn_at_length(from, which != 2 ? times : Real(1), q.a);
      turn_at_length(from, which != 1 ? times : Real(1), q.b);
      return placed_box(from, q, wish);
    });
  }

 private:
  template <class Real>
  static void turn_at_length(Stream& random, Real times, TurnedBox<Real>& box) {
    Quaternion turned = random_turn(random);
    const auto kind = random.below(6);
    if (kind == 0) turned[0] = 0;
    if (kind == 1) turned[0] = std::ldexp(turned[0], -12);
    if (turned[1] == 0 && turned[2] == 0 && turned[3] == 0) turned[1] = 1;
    turn(box, turned);
    if (random.coin()) times = -times;
    for (Real& x : box.q) x *= times;
  }
};

// B is 8 to 64 long and hardly turned, its vector part 2^-k of w, k from 6 to 24 in turn; A is an ordinary box beside
// its end. Without that turn the verdict is the other one.
struct Slight {
  template <class Pair>
  static Pair make(Stream& random, std::uint64_t position) {
    using Real = RealOf<Pair>;
    const double part = std::ldexp(1.0, -6 - static_cast<int>(position % 19));
    const Side side = position / 19 % 2 == 0 ? Side::apart : Side::in_contact;
    return best_of(random, 4 * box_attempts, [&](Stream& from) {
      Pair q = of_ordinary_size<Pair>(from, position);
      const auto longest = from.below(3), axis = next(longest) + from.below(2);
      q.b.half[longest] = std::ldexp(q.b.half[longest], static_cast<int>(from.integer(4, 6)));
      turn_quickly(q.a, random_turn(from));
      const double x = from.symmetric<double>(), y = from.symmetric<double>(), z = from.symmetric<double>();
      const double w = from.coin() ? 1 : -1;
      q.b.q = {static_cast<Real>(w), static_cast<Real>(x * part), static_cast<Real>(y * part),
               static_cast<Real>(z * part)};
      Attempt<Pair> made = placed_box(from, q, {facet_of_b(axis % 3), side, part / 4, part / 8});
      Pair straight = made.query;
      straight.b.q = {1, 0, 0, 0};
      const ClearScene scene = scene_of(BoxPair<double>{box_in_doubles(straight.a), box_in_doubles(straight.b)});
      const double gap = gap_at(scene, arrow_of(straight.b.centre) - arrow_of(straight.a.centre));
      if ((gap > 0) == (side == Side::apart)) made.worth = 0;
      return made;
    });
  }
};

// A base of images in other units of length.
template <class Pair>
Numbers<RealOf<Pair>> unit_boxes(Stream& random, std::uint64_t base) {
  const Side side = (base + base / axis_count) % 3 == 2 ? Side::in_contact : Side::apart;
  return numbers_of(decided_boxes<Pair>(random, 0, {base % axis_count, side}));
}

constexpr std::array<ImageGroup, 4> unit_groups_of_boxes = {
    unit_group_of(box_box_predicate, "box-box/units"), unit_group_of(box_box_predicate, "box-box/units_turned"),
    unit_group_of(box_box_predicate, "box-box/units_minmax"), unit_group_of(box_box_predicate, "box-box/units_mixed")};

}  // namespace

extern const Family box_box_one_axis_family = matrix_family<OneAxis>(
    "box-box/one_axis", box_box_situation::everyday,
    "each of the fifteen axes in turn alone separates, or is least, clearly; every fourth round by 2^-7 or less");
extern const Family box_box_units_family =
    family_of_units<MatrixBoxes, unit_boxes<BoxPair<float>>, unit_boxes<BoxPair<double>>>(
        "box-box/units", box_box_situation::units,
        "clear boxes, and times seven powers of two, 2^-10 to 2^15 or 2^-160 to 2^164; their axes stay");
extern const Family box_box_spans_family = matrix_family<Spans, 2>(
    "box-box/spans", box_box_situation::sizes,
    "B is 2^-20 to 2^20 times as large as A, half of the scenes tiny; each axis in turn decides, clearly");
extern const Family box_box_plates_family = matrix_family<Plates>(
    "box-box/plates", box_box_situation::flat, "one or two half extents are 0 or 2^-10; any axis decides, clearly");
extern const Family box_box_aligned_family = matrix_family<Aligned>(
    "box-box/aligned", box_box_situation::parallel,
    "bars that cross at 2^-5 to 2^-19, upright boxes, and boxes turned by 2^-4 to 2^-25; one axis decides");

extern const Family box_box_one_axis_turned_family = turned_family<OneAxis>(
    "box-box/one_axis_turned", box_box_situation::everyday, "one_axis, as quaternions of integers");
extern const Family box_box_units_turned_family =
    family_of_units<QuaternionBoxes, unit_boxes<TurnedPair<float>>, unit_boxes<TurnedPair<double>>>(
        "box-box/units_turned", box_box_situation::units, "units, as quaternions of integers");
extern const Family box_box_spans_turned_family =
    turned_family<Spans, 2>("box-box/spans_turned", box_box_situation::sizes, "spans, as quaternions of integers");
extern const Family box_box_plates_turned_family =
    turned_family<Plates>("box-box/plates_turned", box_box_situation::flat, "plates, as quaternions of integers");
extern const Family box_box_aligned_turned_family =
    turned_family<Aligned>("box-box/aligned_turned", box_box_situation::parallel, "aligned, as quaternions");
extern const Family box_box_lengths_turned_family =
    turned_family<Lengths>("box-box/lengths_turned", box_box_situation::quaternions,
                           "one_axis, with quaternions about 2^-25 to 2^15 long, of half turns, and negated");
extern const Family box_box_slight_turned_family =
    turned_family<Slight>("box-box/slight_turned", box_box_situation::quaternions,
                          "a long box turned by 2^-6 to 2^-24 of w, whose turn alone decides at its end");

}  // namespace axiscert::boxes

namespace axiscert {

std::span<const ImageGroup* const> box_box_image_groups() {
  static const ImageGroup* const all[] = {&boxes::unit_groups_of_boxes[0], &boxes::unit_groups_of_boxes[1],
                                          &boxes::unit_groups_of_boxes[2], &boxes::unit_groups_of_boxes[3],
                                          &boxes::symmetric_groups[0],     &boxes::symmetric_groups[1]};
  return all;
}

}  // namespace axiscert

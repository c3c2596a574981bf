// Boxes that stand on each other: rotations that differ by a small yaw, or by a crossing of edges at a small angle.
// Here the textbook's edge axes are nearly 0, and an epsilon invents contacts.
#include "fuzz/boxes/parts.h"

namespace axiscert::boxes {
namespace {

// How the pair stands in the world.
using Frame = Quaternion (*)(Stream& random, std::uint64_t position);

Quaternion turned_anyhow(Stream& random, std::uint64_t) { return random_turn(random); }
// The world's third axis is up. In turn, two at a time, along the world's axes and turned about the vertical alone.
Quaternion upright(Stream& random, std::uint64_t position) {
  const auto w = static_cast<double>(random.integer(-3000, 3000)), z = static_cast<double>(random.integer(1, 3000));
  return position / 2 % 2 == 0 ? Quaternion{1, 0, 0, 0} : Quaternion{w, 0, 0, z};
}

// B on A's third facet, yawed by 2^-k for a k of `least` to `most`, sunk in by so much; sideways up to `part` of the
// way to where it would stand beside A.
template <class Pair>
Pair standing(Stream& random, std::uint64_t position, int least, int most, const Rational& part, const Rational& sunk,
              Frame frame_of = turned_anyhow) {
  Pair q = of_ordinary_size<Pair>(random, position);
  const Quaternion frame = frame_of(random, position);
  const double yaw = std::ldexp(2.0, static_cast<int>(random.integer(least, most)));
  turn(q.a, frame);
  turn(q.b, product(frame, {yaw, 0, 0, 1}));
  const auto sideways = [&](std::size_t k) { return offset(random, part * (exact(q.a.half[k]) + exact(q.b.half[k]))); };
  const Rational x = sideways(0), y = sideways(1);
  place(q, frame, {x, y, exact(q.a.half[2]) + exact(q.b.half[2]) - sunk});
  return q;
}

struct StackedBoxes {
  template <class Pair>
  static Pair make(Stream& random, std::uint64_t position) {
    Pair q = standing<Pair>(random, position, 1, 11, Rational(1, 4), 0);
    nudge(random, 8, q);
    return q;
  }
};
template <Frame frame>
struct RestingIn {
  template <class Pair>
  static Pair make(Stream& random, std::uint64_t position) {
    const auto power = static_cast<unsigned long>(random.integer(6, 14));
    return standing<Pair>(random, position, 7, 23, Rational(3, 4), Rational(1, 1ul << power), frame);
  }
};
using RestingBoxes = RestingIn<turned_anyhow>;
using Level = RestingIn<upright>;

// Both stand on an edge, up to 24 long, and the two edges cross at an angle of 2^-5 to 2^-17: in turn apart by 2^-8 to
// 2^-20 and in contact by as much. 13860 / 33461 is the tangent of half of 45 degrees to nine digits.
struct CrossedEdges {
  template <class Pair>
  static Pair make(Stream& random, std::uint64_t position) {
    constexpr Quaternion on_an_edge = {33461, 13860, 0, 0};
    Pair q = of_ordinary_size<Pair>(random, position);
    const auto longer = static_cast<int>(random.below(4));
    q.a.half[0] = std::ldexp(q.a.half[0], longer);
    q.b.half[0] = std::ldexp(q.b.half[0], longer);
    q.a.half[2] = q.a.half[1];  // square, so that the highest edge is above the middle
    q.b.half[2] = q.b.half[1];
    const Quaternion frame = random_turn(random);
    const auto flatness = static_cast<int>(random.integer(6, 18));
    const double yaw = std::ldexp(1.0, flatness);
    turn(q.a, product(frame, on_an_edge));
    turn(q.b, product(product(frame, {yaw, 0, 0, 1}), on_an_edge));
    // So far apart sideways that the edges cross within a quarter of A's middle.
    const Rational x = offset(random, Rational(1, 4)), y = offset(random, Rational(1, 4ul << flatness));
    const auto power = static_cast<unsigned long>(random.integer(8, 20));
    const Rational gap(position / 2 % 2 == 0 ? 1 : -1, 1ul << power);
    // The height at which edges meet, above A's centre: both extents along the third axis of the frame.
    const Point up = exact_axes(frame)[2];
    const ExactPair exact = exactly(q);
    Rational height = 0;
    for (const ExactBox* box : {&exact.a, &exact.b}) {
      for (std::size_t k = 0; k < 3; ++k) height += box->half[k] * abs(Rational(dot(up, box->axis[k])));
    }
    place(q, frame, {x, y, height + gap});
    return q;
  }
};

}  // namespace

extern const Family box_box_stacked_family = matrix_family<StackedBoxes, 2>(
    "box-box/stacked", box_box_situation::touching,
    "B stands on A, yawed by 2^-1 to 2^-11, touching but for roundings and up to eight ulps");
extern const Family box_box_resting_family = matrix_family<RestingBoxes, 2>(
    "box-box/resting", box_box_situation::everyday,
    "B stands on A, yawed by 2^-7 to 2^-23, sunk in by 2^-6 to 2^-14; both turned anyhow");
extern const Family box_box_level_family =
    matrix_family<Level>("box-box/level", box_box_situation::everyday,
                         "resting on a level floor: upright, A along the world's axes or yawed");
extern const Family box_box_crossed_family = matrix_family<CrossedEdges>(
    "box-box/crossed", box_box_situation::crossed,
    "edges of length up to 24 cross at an angle of 2^-5 to 2^-17, 2^-8 to 2^-20 apart or as deep");

extern const Family box_box_resting_turned_family = turned_family<RestingBoxes, 2>(
    "box-box/resting_turned", box_box_situation::everyday, "resting, as quaternions of integers");
extern const Family box_box_level_turned_family =
    turned_family<Level>("box-box/level_turned", box_box_situation::everyday, "level, as quaternions of integers");
extern const Family box_box_crossed_turned_family = turned_family<CrossedEdges>(
    "box-box/crossed_turned", box_box_situation::crossed, "crossed, as quaternions of integers");

}  // namespace axiscert::boxes

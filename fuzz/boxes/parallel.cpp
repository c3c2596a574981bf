// Boxes whose edges are parallel but for roundings: quarter turns of one rotation. The textbook's edge axes are then
// roundings alone, and it misses boxes that overlap by half.
#include "fuzz/boxes/parts.h"

namespace axiscert::boxes {
namespace {

// Four of the quarter turns that a cube does not show.
constexpr std::array<Quaternion, 4> quarters = {{{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 0, 1, 0}, {1, 0, 0, 1}}};

// A frame, and a turn of B in it by whole quarters.
struct Quarters {
  explicit Quarters(Stream& random)
      : frame(random_turn(random)), one(quarters[random.below(4)]), other(quarters[random.below(4)]) {}

  // The turn against the frame after so many rounds of both.
  Quaternion after(int rounds) const {
    Quaternion turned = {1, 0, 0, 0};
    for (int k = 0; k < rounds; ++k) turned = product(product(turned, one), other);
    return turned;
  }

  Quaternion frame, one, other;
};

// B at up to `part` of the distance of touching along each of A's axes, turned against A as `turns` says.
template <class Pair>
void place_parallel(Stream& random, const Quaternion& frame, const Quaternion& turns, const Rational& part, Pair& q) {
  std::array<Rational, 3> extent = {exact(q.a.half[0]), exact(q.a.half[1]), exact(q.a.half[2])};
  const std::array<Point, 3> axes = exact_axes(turns);
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational half = exact(q.b.half[k]);
    extent[0] += abs(axes[k].x) * half;
    extent[1] += abs(axes[k].y) * half;
    extent[2] += abs(axes[k].z) * half;
  }
  const Rational x = offset(random, part * extent[0]), y = offset(random, part * extent[1]);
  place(q, frame, {x, y, offset(random, part * extent[2])});
}

// The quaternion with length 1 in Real, as an engine keeps an orientation.
template <class Real>
std::array<Real, 4> unit(const Quaternion& q) {
  const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  return {static_cast<Real>(q[0] / length), static_cast<Real>(q[1] / length), static_cast<Real>(q[2] / length),
          static_cast<Real>(q[3] / length)};
}

// The columns of its matrix without a division, which a quaternion of length 1 does not need.
template <class Real>
std::array<Vec3<Real>, 3> columns_of_unit(const std::array<Real, 4>& q) {
  const auto& [w, x, y, z] = q;
  return {{{1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)},
           {2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)},
           {2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)}}};
}

// B turned as engines do it: unit quaternions multiplied in Real, a round of two quarters after the other, and the
// matrix of the product. It is some ulps from A's own turned.
template <class Real>
void turn_step_by_step(OrientedBox<Real>& box, const Quarters& turns, int rounds) {
  std::array<Real, 4> now = unit<Real>(turns.frame);
  for (int k = 0; k < rounds; ++k) now = product(product(now, unit<Real>(turns.one)), unit<Real>(turns.other));
  box.axis = columns_of_unit(now);
}
template <class Real>
void turn_step_by_step(TurnedBox<Real>& box, const Quarters& turns, int rounds) {
  turn(box, product(turns.frame, turns.after(rounds)));
}

// The numbers of B are rounded along another route than those of A: every eighth time the matrix of the exact
// quaternion in Real, else step by step.
struct Parallel {
  template <class Pair>
  static Pair make(Stream& random, std::uint64_t position) {
    Pair q = of_ordinary_size<Pair>(random, position);
    const Quarters turns(random);
    turn(q.a, turns.frame);
    if (position / 2 % 8 == 0) turn_in_floats(q.b, product(turns.frame, turns.after(1)));
    else turn_step_by_step(q.b, turns, 1);
    place_parallel(random, turns.frame, turns.after(1), Rational(13, 16), q);
    return q;
  }
};

// A rectangle A, and a box B after eight rounds of quarter turns, step by step.
struct Flat {
  template <class Pair>
  static Pair make(Stream& random, std::uint64_t position) {
    Pair q = of_ordinary_size<Pair>(random, position);
    const Quarters turns(random);
    turn(q.a, turns.frame);
    turn_step_by_step(q.b, turns, 8);
    const auto of_a = random.below(3);
    q.a.half[of_a] = 0;
    place_parallel(random, turns.frame, turns.after(8), Rational(1, 2), q);
    return q;
  }
};

// In turn: two rectangles, a segment and a box.
struct Rectangles {
  template <class Pair>
  static Pair make(Stream& random, std::uint64_t position) {
    Pair q = Parallel::make<Pair>(random, position);
    const auto of_a = random.below(3), of_b = random.below(3);
    q.a.half[of_a] = 0;
    (position / 16 % 2 == 0 ? q.b.half[of_b] : q.a.half[next(of_a)]) = 0;
    return q;
  }
};

}  // namespace

extern const Family box_box_parallel_family =
    matrix_family<Parallel, 2>("box-box/parallel", box_box_situation::parallel,
                               "quarter turns of one rotation, rounded along other routes; overlapping");
extern const Family box_box_flat_family = matrix_family<Flat, 2>(
    "box-box/flat", box_box_situation::flat, "a rectangle and a box after sixteen quarter turns, overlapping by half");
extern const Family box_box_rectangles_family = matrix_family<Rectangles>(
    "box-box/rectangles", box_box_situation::flat, "parallel: two rectangles, or a segment and a box");

extern const Family box_box_parallel_turned_family = turned_family<Parallel, 2>(
    "box-box/parallel_turned", box_box_situation::parallel, "parallel, as quaternions of integers");

}  // namespace axiscert::boxes

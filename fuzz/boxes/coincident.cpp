// Boxes at one place, where several axes are as deep: the direction of a push is then a matter of roundings.
#include "fuzz/boxes/parts.h"

namespace axiscert::boxes {
namespace {

// In turn: the same box twice; a box within another of the same axes; two cubes, one some quarter turns further; and a
// box beside its copy by 2^-4 to 2^-20 of its size along one axis of its own. Every other round one box or both have no
// thickness.
struct Coincident {
  template <class Pair>
  static Pair make(Stream& random, std::uint64_t position) {
    using Real = RealOf<Pair>;
    Pair q = of_ordinary_size<Pair>(random, position);
    const Quaternion frame = random_turn(random);
    static constexpr std::array<Quaternion, 4> quarters = {{{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 0, 1, 0}, {1, 0, 0, 1}}};
    const auto quarter = random.below(4), axis = random.below(3);
    const auto power = static_cast<int>(random.integer(4, 20));
    const auto kind = position / 2 % 4;
    turn(q.a, frame);
    turn(q.b, kind == 2 ? product(frame, quarters[quarter]) : frame);
    if (kind == 2) q.a.half = {{q.a.half[0], q.a.half[0], q.a.half[0]}};
    if (kind != 1) q.b.half = q.a.half;
    if (position / 8 % 2 == 1) q.b.half[axis] = 0;
    if (position / 16 % 2 == 1) q.a.half[axis] = 0;
    std::array<Rational, 3> at = {0, 0, 0};
    if (kind == 3) at[random.below(3)] = exact(static_cast<double>(std::ldexp(Real(1), -power)));
    place(q, frame, at);
    return q;
  }
};

}  // namespace

extern const Family box_box_coincident_family =
    by_name(matrix_family<Coincident>("box-box/coincident", box_box_situation::parallel,
                                      "equal boxes at one place, or one in the other: several axes are as deep"));
extern const Family box_box_coincident_turned_family = by_name(turned_family<Coincident>(
    "box-box/coincident_turned", box_box_situation::parallel, "coincident, as quaternions of integers"));

}  // namespace axiscert::boxes

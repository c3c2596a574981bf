#include "fuzz/boxes/parts.h"

#include "kernel/query.h"

namespace axiscert::boxes {

Quaternion random_turn(Stream& random) {
  constexpr std::int64_t bound = 3000;
  Quaternion q;
  for (double& x : q) x = static_cast<double>(random.integer(-bound, bound));
  if (q[0] == 0 && q[1] == 0 && q[2] == 0 && q[3] == 0) q[0] = 1;
  return q;
}

std::array<Point, 3> exact_axes(const Quaternion& q) {
  const TurnedBox<double> box{{0, 0, 0}, {1, 1, 1}, q};
  return exact_pair(TurnedPair<double>{box, box}).a.axis;
}

template <>
ExactPair exactly(const BoxPair<double>& q) {
  return exact_pair(q);
}
template <>
ExactPair exactly(const TurnedPair<double>& q) {
  return exact_pair(q);
}
template <>
ExactPair exactly(const BoxPair<float>& q) {
  const Numbers<double> wide = in_doubles(numbers_of(q));
  return exact_pair(MatrixBoxes::problem<double>([&](std::size_t k) { return wide[k]; }));
}
template <>
ExactPair exactly(const TurnedPair<float>& q) {
  const Numbers<double> wide = in_doubles(numbers_of(q));
  return exact_pair(QuaternionBoxes::problem<double>([&](std::size_t k) { return wide[k]; }));
}

}  // namespace axiscert::boxes

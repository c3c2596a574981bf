#include "fuzz/search/moves/frame_moves.h"

#include <cmath>
#include <limits>
#include <utility>

namespace axiscert {
namespace {

template <class Real>
void take_frame(Numbers<Real>& q, std::size_t to, const Numbers<Real>& from, std::size_t first) {
  for (std::size_t k = 0; k < 9; ++k) q[to + k] = from[first + k];
}

}  // namespace

template <class Real>
void move_frame(Dice& random, const QueryShape& shape, Numbers<Real>& q, const Numbers<Real>& other) {
  const std::vector<std::size_t>& frames = shape.frames;
  const auto any_frame = [&] { return frames[static_cast<std::size_t>(random.below(frames.size()))]; };
  const std::size_t first = any_frame();
  const std::uint64_t kind = random.below(4);
  if (kind == 0) {
    const bool from_other = random.coin();
    take_frame(q, first, from_other ? other : q, any_frame());
    return;
  }
  const auto about = static_cast<std::size_t>(random.below(3));
  const std::size_t one = first + 3 * ((about + 1) % 3), two = first + 3 * ((about + 2) % 3);
  if (kind == 1) {
    const bool exchange = random.coin();
    for (std::size_t k = 0; k < 3; ++k) {
      if (exchange) std::swap(q[one + k], q[two + k]);
      else q[one + k] = -q[one + k];
    }
    return;
  }
  const auto exponent = -static_cast<int>(random.below(std::numeric_limits<Real>::digits));
  const Real angle = std::ldexp(random.symmetric<Real>(), exponent);
  for (std::size_t k = 0; k < 3; ++k) {
    const Real x = q[one + k], y = q[two + k];
    q[one + k] = x + angle * y;
    q[two + k] = y - angle * x;
  }
}
template void move_frame(Dice&, const QueryShape&, Numbers<float>&, const Numbers<float>&);
template void move_frame(Dice&, const QueryShape&, Numbers<double>&, const Numbers<double>&);

}  // namespace axiscert

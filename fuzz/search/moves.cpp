#include "fuzz/search/moves.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "fuzz/queries/floats.h"

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

namespace {

template <class Real>
using Bits = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;
template <class Real>
constexpr int digits = std::numeric_limits<Real>::digits;
// In (-1, 1), down to 2^-n in magnitude. The exponent is drawn first: the order in which arguments are evaluated is not
// specified, and a seed has to give the same result with every compiler.
template <class Real>
Real fine_number(Dice& random, int n) {
  const auto exponent = -static_cast<int>(random.below(static_cast<std::uint64_t>(n)));
  return std::ldexp(random.symmetric<Real>(), exponent);
}

template <class Real>
Real random_number(Dice& random) {
  switch (random.below(4)) {
    case 0:
      return random.coin() ? Real(1) : Real(-1);
    case 1:
      return Real(0);
    case 2:
      return fine_number<Real>(random, digits<Real>);
    default:
      return random.symmetric<Real>();
  }
}

// Replaces a random number of the lowest bits of x by random ones.
template <class Real>
Real with_random_tail(Dice& random, Real x) {
  const auto mask = (Bits<Real>(1) << (1 + random.below(digits<Real> - 1))) - 1;
  const auto noise = static_cast<Bits<Real>>(random.bits());
  return std::bit_cast<Real>(static_cast<Bits<Real>>((std::bit_cast<Bits<Real>>(x) & ~mask) | (noise & mask)));
}

// A query that is moved, and what its numbers are.
template <class Real>
struct MovedQuery {
  const QueryShape& shape;
  Numbers<Real>& v;
  Real& at(std::size_t point, std::size_t axis) const { return v[shape.points[point] + axis]; }
};

// A new coordinate of the centre, the last point, along one axis, with the others moved along: the translated
// coordinates remain about the same, their roundings do not.
template <class Real>
void move_centre(Dice& random, const MovedQuery<Real>& moving) {
  const std::size_t vertices = moving.shape.vertices();
  const auto axis = static_cast<std::size_t>(random.below(moving.shape.axes));
  Real& p = moving.at(vertices, axis);
  const Real before = p;
  switch (random.below(4)) {
    case 0:
      p = 0;
      break;
    case 1:
      p = with_random_tail(random, p);
      break;
    case 2:
      p = random.symmetric<Real>();
      break;
    default:  // fine numbers, whose low bits are below those of the vertices
      p = fine_number<Real>(random, digits<Real> + 2);
  }
  for (std::size_t vertex = 0; vertex < vertices; ++vertex) {
    Real& x = moving.at(vertex, axis);
    x = (x - before) + p;
  }
}

template <class Real>
void swap_vertices(const MovedQuery<Real>& moving, std::size_t a, std::size_t b) {
  for (std::size_t axis = 0; axis < moving.shape.axes; ++axis) std::swap(moving.at(a, axis), moving.at(b, axis));
}

// A whole vertex or direction of the other query, or one axis of it.
template <class Real>
void move_part(Dice& random, const MovedQuery<Real>& moving, const Numbers<Real>& other) {
  const QueryShape& shape = moving.shape;
  Numbers<Real>& v = moving.v;
  if (random.coin()) {
    const auto part = static_cast<std::size_t>(random.below(shape.vertices() + shape.directions.size()));
    const std::size_t first = part < shape.vertices() ? shape.points[part] : shape.directions[part - shape.vertices()];
    for (std::size_t axis = 0; axis < shape.axes; ++axis) v[first + axis] = other[first + axis];
  } else {
    const auto axis = static_cast<std::size_t>(random.below(shape.axes));
    for (const std::size_t first : shape.points) v[first + axis] = other[first + axis];
    for (const std::size_t first : shape.directions) v[first + axis] = other[first + axis];
  }
}

// Changes one number by ulps, or in its tail, exponent or sign; or replaces it.
template <class Real>
void move_number(Dice& random, Numbers<Real>& v) {
  const auto place = static_cast<std::size_t>(random.below(v.size()));
  Real& x = v[place];
  switch (random.below(8)) {
    case 0:
    case 1: {
      const auto size = std::int64_t{1} << random.below(digits<Real>);
      x = moved_by_ulps(x, random.integer(-size, size));
      break;
    }
    case 2:
      x = moved_by_ulps(x, random.integer(-4, 4));
      break;
    case 3:
    case 4:
      x = with_random_tail(random, x);
      break;
    case 5:
      x = random.coin() ? -x : std::ldexp(x, static_cast<int>(random.integer(-3, 3)));
      break;
    case 6:
      x = random_number<Real>(random);
      break;
    default: {
      const Real number = v[random.below(v.size())];
      x = random.coin() ? number : -number;
    }
  }
}

}  // namespace

template <class Real>
Real moved_by_ulps(Real x, std::int64_t ulps) {
  // Floats as integers in the same order: the bits of a negative number count downwards.
  const auto bits = std::bit_cast<Bits<Real>>(x);
  constexpr auto sign = Bits<Real>(1) << (sizeof(Real) * 8 - 1);
  auto order = static_cast<std::int64_t>(bits & ~sign);
  if ((bits & sign) != 0) order = -order;
  order += ulps;
  const auto size = static_cast<Bits<Real>>(order < 0 ? -order : order);
  return std::bit_cast<Real>(static_cast<Bits<Real>>(order < 0 ? size | sign : size));
}

template <class Real>
void settle(const QueryShape& shape, Numbers<Real>& q) {
  constexpr Real most = 0x1p8f;
  Real greatest = 0;
  for (std::size_t k = 0; k < q.size(); ++k) {
    Real& x = q[k];
    if (!(std::fabs(x) <= most)) x = std::isnan(x) ? Real(0) : std::copysign(most, x);
    if (shape.is_length[k]) x = std::fabs(x);
    greatest = std::max(greatest, std::fabs(x));
  }
  if (greatest != 0 && greatest < Real(0.5)) {
    scale_by_power_of_two(q, -1 - std::ilogb(greatest));
  }
  for (const std::size_t first : shape.frames) {
    if (!is_nearly_rotation(q, first)) make_rotation(q, first);
  }
}

template <class Real>
void move(Dice& random, const QueryShape& shape, Numbers<Real>& v, const Numbers<Real>& o) {
  const auto index = [&](std::uint64_t n) { return static_cast<std::size_t>(random.below(n)); };
  const MovedQuery<Real> moving{shape, v};
  if (!shape.frames.empty() && random.below(3) == 0) return move_frame(random, shape, v, o);
  switch (random.below(16)) {
    case 0:
    case 1:
      move_centre(random, moving);
      break;
    case 2: {  // all tails
      const auto count = 1 + random.below(4);
      for (std::uint64_t i = 0; i < count; ++i) {
        Real& x = v[index(v.size())];
        x = with_random_tail(random, x);
      }
      break;
    }
    case 3:
      move_part(random, moving, o);
      break;
    case 4: {
      const std::size_t place = index(v.size());
      v[place] = random.coin() ? o[place] : v[place] + (o[place] - v[place]) * Real(0.5);
      break;
    }
    case 5:
      if (random.coin()) {
        const std::size_t vertex = index(shape.vertices());
        swap_vertices(moving, vertex, (vertex + 1) % shape.vertices());
      } else {
        std::swap(v[index(v.size())], v[index(v.size())]);  // which of the two is drawn first does not matter
      }
      break;
    default: {
      const auto count = 1 + (random.coin() ? 0 : random.below(3));
      for (std::uint64_t i = 0; i < count; ++i) move_number(random, v);
    }
  }
}

#define AXISCERT_INSTANTIATE(Real)                         \
  template Real moved_by_ulps(Real, std::int64_t);         \
  template void settle(const QueryShape&, Numbers<Real>&); \
  template void move(Dice&, const QueryShape&, Numbers<Real>&, const Numbers<Real>&);
AXISCERT_INSTANTIATE(float)
AXISCERT_INSTANTIATE(double)
#undef AXISCERT_INSTANTIATE

}  // namespace axiscert

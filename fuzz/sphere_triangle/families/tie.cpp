// Integers that touch exactly: the distance equals r, on each of the seven features in turn.
#include "fuzz/sphere_triangle/families/parts/shapes.h"
#include "kernel/sphere_triangle/query.h"
#include "fuzz/queries/family.h"
#include "fuzz/queries/random.h"

namespace axiscert {
namespace {

using Integers = Vec3<std::int64_t>;

// Three orthogonal columns of length n = a^2 + b^2 + c^2 + d^2: a rotation times n, from an integer quaternion.
struct Rotation {
  Integers x, y, z;
  std::int64_t n;
  Integers operator()(const Integers& v) const { return (x * v.x + y * v.y) + z * v.z; }
};
Rotation rotation(Stream& random, std::int64_t bound) {
  const auto [b, c, d] = shapes::integers(random, bound);
  const std::int64_t a = random.integer(-bound, bound);
  return {{a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c)},
          {2 * (b * c - a * d), a * a - b * b + c * c - d * d, 2 * (c * d + a * b)},
          {2 * (b * d + a * c), 2 * (c * d - a * b), a * a - b * b - c * c + d * d},
          a * a + b * b + c * c + d * d};
}

// A triangle whose nearest point to every centre (0, 0, z), z > 0, is the origin, in the interior of the feature.
std::array<Integers, 3> local_vertices(Stream& random, std::size_t axis, std::int64_t bound) {
  if (axis == 0) {  // in the plane z = 0, with the origin a positive combination of the vertices
    Integers u = shapes::integers(random, bound / 4), v = shapes::integers(random, bound / 4);
    if (u.x == 0 && u.y == 0) u.x = 1;
    if (u.x * v.y - u.y * v.x == 0) v = {-u.y, u.x, 0};
    u.z = v.z = 0;
    const std::int64_t s = random.integer(1, 2), t = random.integer(1, 2);
    return {u, v, u * -s - v * t};
  }
  // The other vertices lie strictly below the plane z = 0.
  const auto below = [&] {
    Integers v = shapes::integers(random, bound);
    v.z = -random.integer(1, bound);
    return v;
  };
  std::array<Integers, 3> vertices;
  if (axis < 4) {
    const std::size_t i = axis - 1;
    vertices[i] = {0, 0, 0};
    vertices[shapes::next(i)] = below();
    vertices[shapes::opposite(i)] = below();
  } else {
    const std::size_t i = axis - 4;
    Integers along = shapes::integers(random, bound / 4);
    if (along.x == 0 && along.y == 0) along.x = 1;
    along.z = 0;
    vertices[i] = along * -random.integer(1, 4);
    vertices[shapes::next(i)] = along * random.integer(1, 4);
    vertices[shapes::opposite(i)] = below();
  }
  return vertices;
}

// Bounds on the quaternion's components, the local coordinates and the final move. With n <= 4 q^2 a rotated coordinate
// is at most sqrt(3) n local, and the sum stays below 2^24 (2^53). In binary32 it stays below 2^18 before the move, so
// that degree 6 does not overflow.
struct Size {
  std::int64_t quaternion, local, move;
};
template <class Real>
constexpr std::array<Size, 3> sizes = {{{1, 4, 4}, {4, 64, 1 << 12}, {11, 256, 1 << 23}}};
template <>
constexpr std::array<Size, 3> sizes<double> = {
    {{1, 4, 4}, {64, 1 << 10, 1 << 30}, {1 << 10, 1 << 24, std::int64_t{1} << 52}}};

template <class Real>
Query<Real> turned_and_moved(Stream& random, std::uint64_t position) {
  const Size& size = sizes<Real>[position / axis_count % 3];
  const Rotation rotate = rotation(random, size.quaternion);
  const auto local = local_vertices(random, position % axis_count, size.local);
  const std::int64_t z = random.integer(1, size.local);
  const Integers move = shapes::integers(random, size.move);
  const auto real = [&](const Integers& v) {
    const Integers moved = rotate(v) + move;
    return Vec3<Real>{static_cast<Real>(moved.x), static_cast<Real>(moved.y), static_cast<Real>(moved.z)};
  };
  return {real(local[0]), real(local[1]), real(local[2]), real({0, 0, z}), static_cast<Real>(z * rotate.n)};
}

}  // namespace

template <class Real>
Query<Real> touching_integers(Stream& random, std::uint64_t position) {
  return turned_and_moved<Real>(random, position);
}
template Query<float> touching_integers(Stream&, std::uint64_t);
template Query<double> touching_integers(Stream&, std::uint64_t);

extern const Family tie_family = {
    sphere_triangle_predicate,
    "tie",
    "integers that touch exactly, on each of the seven features in turn; small ones and large ones",
    2,
    false,
    fill_one_by_one<touching_integers<float>>,
    fill_one_by_one<touching_integers<double>>,
    TrustGroup::resting};

}  // namespace axiscert

// Triangles that are a segment: three distinct points exactly on a line in a generic direction.
//
// The published formulae with strict sides answer most of these wrongly at some radius even in exact arithmetic, always
// with a phantom contact; random floats are never collinear.
#include "fuzz/sphere_triangle/families/parts/boundary.h"
#include "kernel/sphere_triangle/query.h"
#include "fuzz/sphere_triangle/families/parts/shapes.h"
#include "fuzz/queries/family.h"
#include "fuzz/queries/random.h"

namespace axiscert {
namespace {

// Vertices base + t D in integers, each coordinate below 2^24 (2^53): 2^22 + 2^8 2^14 and 2^51 + 2^11 2^40.
template <class Real>
Query<Real> collinear(Stream& random, std::uint64_t position) {
  constexpr bool single = sizeof(Real) == 4;
  constexpr int base_digits = single ? 22 : 51, step_digits = single ? 8 : 11;
  constexpr std::int64_t steps = std::int64_t{1} << step_digits;
  const auto base = shapes::integers<Real>(random, std::int64_t{1} << base_digits);
  const auto direction = shapes::integers<Real>(random, std::int64_t{1} << (base_digits - step_digits));
  const std::int64_t first = random.integer(-steps, 0), second = first + random.integer(1, steps / 2);
  const std::int64_t third = second + random.integer(1, steps / 2);
  const auto at = [&](std::int64_t t) { return shapes::scaled(base + direction * static_cast<Real>(t), -base_digits); };
  // The order of the vertices determines which of them lies between the other two.
  const auto vertices = shapes::shuffled<Real>(random, {at(first), at(second), at(third)});

  Query<Real> q = shapes::query(vertices, shapes::in_cube<Real>(random));
  switch (position % 3) {
    case 0:
      q.r = random.unit<Real>() * radius_at_distance(q);
      break;
    case 1:
      q.r = shapes::radius_near_distance(random, q, 2);
      break;
    default:
      q.r = radius_at_distance(q) * (1 + random.unit<Real>());
      break;
  }
  return q;
}

}  // namespace

extern const Family collinear_family = {
    sphere_triangle_predicate,
    "collinear",
    "three distinct vertices exactly on a line; radii below, at and above the distance",
    2,
    false,
    fill_one_by_one<collinear<float>>,
    fill_one_by_one<collinear<double>>,
    TrustGroup::degenerate};

}  // namespace axiscert

// Radius, distance and edge length of very different sizes, independently.
#include <cmath>

#include "fuzz/families/shapes.h"
#include "fuzz/family.h"

namespace axiscert {
namespace {

constexpr int most_halvings = 40, steps = 2 * most_halvings + 1;

// One vertex is the origin, so that the centre can be as near to it as it likes.
template <class Real>
Query<Real> ratio(Stream& random, std::uint64_t position) {
  const int distance_exponent = static_cast<int>(position % steps) - most_halvings;
  const int radius_exponent = static_cast<int>(position / steps % (steps + 1)) - most_halvings;
  const Vec3<Real> x = shapes::in_cube<Real>(random), y = shapes::in_cube<Real>(random);
  const Real edge = std::sqrt(dot(x, x));
  const Vec3<Real> towards = shapes::at_unit_length(shapes::in_cube<Real>(random));
  const Vec3<Real> p = shapes::scaled(towards * edge, distance_exponent);
  Real r = std::ldexp(edge * (random.unit<Real>() + Real(0.5)), radius_exponent);
  if (radius_exponent > most_halvings) r = 0;  // the last step of the radius is none at all
  return shapes::query(shapes::shuffled<Real>(random, {Vec3<Real>{0, 0, 0}, x, y}), p, r);
}

}  // namespace

extern const Family ratio_family = {"ratio",
                                    "r / edge and |A - P| / edge over 2^-40 to 2^40, independently, in turn; r = 0 too",
                                    1,
                                    false,
                                    ratio<float>,
                                    ratio<double>};

}  // namespace axiscert

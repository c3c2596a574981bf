// A query near tangency, and its images: in six vertex orders, in 48 permutations and reflections of the axes, with all
// signs changed, times powers of two, and translated. Every image is exact, so that no exact answer differs.
#include "fuzz/queries/image_groups.h"
#include "kernel/sphere_triangle/query.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fuzz/sphere_triangle/families/parts/images.h"
#include "fuzz/sphere_triangle/families/parts/shapes.h"
#include "fuzz/queries/family.h"
#include "fuzz/queries/random.h"

namespace axiscert {
namespace {

// Coordinates of A, B, C and P are multiples of 2^-grid_bits in [-1, 1], so that they leave room for a translation by
// such a multiple, at most 3: sums are at most 4 and have grid_bits + 3 <= digits bits. They also leave room for a
// power of two.
template <class Real>
constexpr int grid_bits = std::numeric_limits<Real>::digits - 4;
constexpr std::int64_t greatest_translation = 3;

// Powers within the range, near its end and beyond it: at 2^20 the edge axes of binary32, terms of degree 6, begin to
// overflow.
template <class Real>
constexpr std::array<int, 8> powers =
    sizeof(Real) == 4 ? std::array{0, 1, -1, 6, -6, 20, -20, 31} : std::array{0, 1, -1, 40, -40, 160, -160, 250};

template <class Real>
Vec3<Real> on_grid(Stream& random, std::int64_t greatest, int exponent) {
  const auto draw = [&] { return std::ldexp(static_cast<Real>(random.integer(-greatest, greatest)), exponent); };
  const Real x = draw(), y = draw(), z = draw();
  return {x, y, z};
}

// In turn: an arbitrary triangle, a sliver, a triangle of small integers where comparisons tie, and one with two equal
// vertices. The radius is the float nearest to the distance, -4 to +4 ulps.
template <class Real>
Query<Real> base_query(Stream& random, std::uint64_t base) {
  constexpr int bits = grid_bits<Real>;
  constexpr std::int64_t one = std::int64_t{1} << bits;
  const auto kind = base % 4;
  const std::int64_t greatest = kind == 2 ? 4 : one;
  const int exponent = kind == 2 ? -2 : -bits;
  shapes::Vertices<Real> v;
  for (Vec3<Real>& vertex : v) vertex = on_grid<Real>(random, greatest, exponent);
  if (kind == 1) {
    // C close to the line AB, between A and B: A and B are multiples of eight units, so an eighth of AB is on the grid.
    for (std::size_t i = 0; i < 2; ++i) v[i] = on_grid<Real>(random, one / 8, 3 - bits);
    const Real share = static_cast<Real>(random.integer(1, 7)) / 8;
    v[2] = v[0] + (v[1] - v[0]) * share + on_grid<Real>(random, 2, -bits);
    for (Real* x : {&v[2].x, &v[2].y, &v[2].z}) *x = std::clamp(*x, Real(-1), Real(1));
  }
  if (kind == 3) {
    const auto which = static_cast<std::size_t>(random.below(3));
    v[which] = v[shapes::next(which)];
  }
  Query<Real> q = shapes::query(v, on_grid<Real>(random, greatest, exponent));
  q.r = shapes::radius_near_distance(random, q, 4);
  // A few ulps from a distance of zero: scaling by the powers of two would round such a radius.
  if (!(q.r >= Real(0x1p-40))) q.r = 0;
  return q;
}

template <class Real>
Query<Real> order_image(const Query<Real>& base, std::size_t i, Stream&) {
  return image(base, symmetries()[48 * i]);
}
template <class Real>
Query<Real> axes_image(const Query<Real>& base, std::size_t i, Stream&) {
  return image(base, symmetries()[i]);
}
template <class Real>
Query<Real> inverted_image(const Query<Real>& base, std::size_t i, Stream&) {
  return image(base, symmetries()[i == 0 ? 0 : 7]);
}
template <class Real>
Query<Real> scaled_image(const Query<Real>& base, std::size_t i, Stream&) {
  return times_power(base, powers<Real>[i]);
}
template <class Real>
Query<Real> translated_image(const Query<Real>& base, std::size_t i, Stream& random) {
  Vec3<Real> by = {0, 0, 0};
  for (std::size_t k = 0; k < i; ++k) {
    by = on_grid<Real>(random, greatest_translation << grid_bits<Real>, -grid_bits<Real>);
  }
  return {base.a + by, base.b + by, base.c + by, base.p + by, base.r};
}

using Order = std::array<std::uint8_t, 3>;
Order same_order(std::size_t) { return {0, 1, 2}; }
template <ImageKind kind>
constexpr ImageKind always(std::size_t) {
  return kind;
}
// Eight choices of signs for each order of the axes.
ImageKind kind_on_axes(std::size_t image) { return image < 8 ? ImageKind::mirror : ImageKind::axes; }
int power_of(Precision precision, std::uint64_t, std::size_t image) {
  return precision == Precision::binary32 ? powers<float>[image] : powers<double>[image];
}
constexpr std::array<ImageGroup, 5> groups = {{
    {sphere_triangle_predicate, "orders", 6,
     [](std::size_t image) -> Order { return symmetries()[48 * image].vertices; }, always<ImageKind::order>},
    {sphere_triangle_predicate, "axes", 48, same_order, kind_on_axes},
    {sphere_triangle_predicate, "inverted", 2, same_order, always<ImageKind::mirror>},
    {sphere_triangle_predicate, "scaled", 8, same_order, always<ImageKind::scale>, power_of},
    {sphere_triangle_predicate, "translated", 4, same_order, always<ImageKind::translation>},
}};

// The images from `first` on.
template <class Real, std::size_t group, Query<Real> (*make_image)(const Query<Real>&, std::size_t, Stream&)>
void fill(const StreamName& name, std::uint64_t first, const MutableColumns<Real>& out) {
  fill_groups(
      name, first, out, groups[group].size, base_query<Real>,
      [](Stream& after, const Query<Real>& q, std::uint64_t, std::size_t i) { return make_image(q, i, after); });
}

template <std::size_t group, auto image_binary32, auto image_binary64>
constexpr Family family_of_images(std::string_view purpose) {
  return {
      sphere_triangle_predicate,          groups[group].family, purpose, 1, false, fill<float, group, image_binary32>,
      fill<double, group, image_binary64>};
}

}  // namespace

extern const ImageGroup units_group, spans_group;  // of the files of their families

std::span<const ImageGroup* const> sphere_triangle_image_groups() {
  static const ImageGroup* const all[] = {&groups[0], &groups[1],   &groups[2],  &groups[3],
                                          &groups[4], &units_group, &spans_group};
  return all;
}

extern const Family orders_family = family_of_images<0, order_image<float>, order_image<double>>(
    "a query near tangency in the six orders of its vertices");
extern const Family axes_family = family_of_images<1, axes_image<float>, axes_image<double>>(
    "a query near tangency in the 48 permutations and reflections of the axes");
extern const Family inverted_family = family_of_images<2, inverted_image<float>, inverted_image<double>>(
    "a query near tangency, and with all signs changed but the radius's");
extern const Family scaled_family = family_of_images<3, scaled_image<float>, scaled_image<double>>(
    "a query near tangency times eight powers of two, 2^-20 to 2^31 or 2^-160 to 2^250");
extern const Family translated_family = family_of_images<4, translated_image<float>, translated_image<double>>(
    "a query near tangency, and translated three times, exactly");

}  // namespace axiscert

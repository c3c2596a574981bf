#include "exact/capsule_triangle/contact.h"

#include <algorithm>
#include <limits>

#include "exact/moving_sphere/first_contact.h"
#include "exact/numbers/roots.h"

namespace axiscert::capsule {
namespace {

RationalPoint rational_point(const portable::Vec3<double>& v) { return {exact(v.x), exact(v.y), exact(v.z)}; }
Rational square_of(const RationalPoint& v) { return dot(v, v); }

// A box without breadth around the middle of the segment. Its other axes are any two that make a basis: it has no
// extent along them, and a push along an axis that is no facet's normal is never the shortest alone.
boxes::ExactBoxAndTriangle as_box(const std::array<RationalPoint, 2>& end, const std::array<RationalPoint, 3>& corner) {
  const std::array<RationalPoint, 3> units = {RationalPoint{1, 0, 0}, RationalPoint{0, 1, 0}, RationalPoint{0, 0, 1}};
  RationalPoint along = end[1] - end[0];
  const bool is_point = square_of(along) == 0;
  if (is_point) along = units[0];
  const Rational size[] = {abs(along.x), abs(along.y), abs(along.z)};
  const auto most = static_cast<std::size_t>(std::max_element(size, size + 3) - size);
  return {{(end[0] + end[1]) * Rational(1, 2),
           {is_point ? Rational(0) : Rational(1, 2), 0, 0},
           {along, units[(most + 1) % 3], units[(most + 2) % 3]}},
          corner};
}

}  // namespace

ExactContact::ExactContact(const moving_sphere::GivenMotion& q)
    : end_{rational_point(q.p), rational_point(q.to)},
      corner_{rational_point(q.a), rational_point(q.b), rational_point(q.c)},
      r_(exact(q.r)),
      scene_(moving_sphere::squared_scene(q)),
      segment_(as_box(end_, corner_)) {}

bool ExactContact::is_deep() const {
  if (segment_.is_apart()) return segment_.squared_separation() < r_ * r_;
  return r_ > 0 || segment_.squared_separation() > 0;
}

boxes::RootLess ExactContact::separation(const Rational& margin) const {
  const Rational less = r_ + margin;
  if (segment_.is_apart()) return {segment_.squared_separation(), less, false};
  return {segment_.squared_separation(), Rational(-less), true};
}

double ExactContact::rounded_separation() const {
  const boxes::RootLess exact = separation(0);
  const RootNumber number{-exact.less, exact.squared};
  const int side = compare(number, 0);
  if (side == 0) return 0;
  const double size = boxes::at_most_finite(nearest<double>(approximate_magnitude(number)));
  return (side < 0) != exact.is_negated ? -size : size;
}

std::optional<boxes::NearestPair> ExactContact::only_points() const {
  std::optional<boxes::NearestPair> points = segment_.only_points();
  if (!points) return std::nullopt;
  const RationalPoint& normal = normals().front();
  points->a = points->a + normal * Rational(r_ / root_below(square_of(normal)));
  return points;
}

bool ExactContact::is_right(const RationalPoint& n) const {
  if (segment_.is_apart() || segment_.squared_separation() != 0) {
    return std::ranges::any_of(
        normals(), [&](const RationalPoint& right) { return square_of(cross(right, n)) == 0 && dot(right, n) > 0; });
  }
  // The segment and the triangle touch: right is what a plane has them on either side of.
  const Rational reach = std::max(Rational(dot(end_[0], n)), Rational(dot(end_[1], n)));
  return std::ranges::all_of(corner_, [&](const RationalPoint& corner) { return dot(corner, n) >= reach; });
}

Rational ExactContact::rest_after(const RationalPoint& way) const {
  std::array<RationalPoint, 3> pushed = corner_;
  for (RationalPoint& corner : pushed) corner = corner + way;
  const boxes::ExactContact after(as_box(end_, pushed));
  const Rational &squared = after.squared_separation(), root = root_below(squared);
  // r - d without a difference of roots.
  return after.is_apart() ? Rational((r_ * r_ - squared) / (r_ + root)) : Rational(r_ + root);
}

Decimal6 ExactContact::left(const RationalPoint& n) const {
  if (is_right(n)) return {};
  const Rational depth = approximate_magnitude({r_, squared_sides(), segment_.is_apart() ? -1 : 1});
  // Both roots and the depth are relatively within 2^-240: so the place is within 2^-238 of the depth, and how far the
  // segment and the triangle are apart, or in each other, is too.
  const Rational rest = rest_after(n * Rational(depth / root_below(square_of(n))));
  const Rational off(mpz_class(1), mpz_class(1) << 230);
  return round_up(std::max(Rational(rest / depth - off), off));
}

double ExactContact::share_of(const Rational& length) const {
  if (length == 0 || scene_ == 0) return 0;
  const double share = nearest<double>(Rational(length / root_below(scene_)));
  return std::clamp(share, std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::max());
}

double ExactContact::share_outside_of_a(const RationalPoint& p) const {
  const Rational squared = boxes::squared_distance(boxes::Hull{p}, boxes::Hull{end_[0], end_[1]});
  return squared <= r_ * r_ ? 0 : share_of(approximate_magnitude({-r_, squared}));
}
double ExactContact::share_outside_of_b(const RationalPoint& p) const {
  return share_of(root_below(boxes::squared_distance(boxes::Hull{p}, boxes::hull_of(corner_))));
}

// As of two boxes, with |a - b| - |root - less|.
double ExactContact::share_of_mismatch(const RationalPoint& a, const RationalPoint& b, bool any_way) const {
  const boxes::RootLess right = separation(0);
  const Rational sign = compare({-right.less, right.squared}, 0) < 0 ? -1 : 1;
  const RootTerm between{1, square_of(a - b)}, root{-sign, right.squared}, less{sign * right.less};
  const bool is_length = is_apart() || any_way;
  const Rational rest = is_length ? Rational(0) : rest_after(a - b);
  const int is_longer = sign_of_sum(between, root, less);
  if (is_longer == 0 && rest <= 0) return 0;
  const Rational longer = root_below(between.square) + root.factor * root_below(root.square) + less.factor,
                 off = is_length ? Rational(abs(longer)) : std::max(longer, rest);
  // The roots may be alike to all of their 240 bits.
  return off == 0 ? std::numeric_limits<double>::denorm_min() : share_of(abs(off));
}

namespace {

ExactDepth depth_of(const ExactContact& contact) {
  const boxes::ExactContact& segment = contact.of_segment();
  const Rational& scene = contact.squared_scene();
  return {segment.squared_separation(), segment.is_apart() ? contact.radius() : Rational(-contact.radius()),
          scene == 0 ? Rational(1) : scene};  // where it is 0, so is all else
}

}  // namespace

ExactDepth exact_depth(const moving_sphere::GivenMotion& q) { return depth_of(ExactContact(q)); }

std::vector<ExactFact> exact_facts(const moving_sphere::GivenMotion& q) {
  constexpr std::string_view not_the_only_one = "not the only one";
  const ExactContact contact(q);
  const boxes::ExactContact& segment = contact.of_segment();
  const Rational &squared = segment.squared_separation(), &r = contact.radius();
  const Rational distance = segment.is_apart() ? squared : Rational(0);
  const RationalPoint& normal = segment.normals().front();
  std::vector<ExactFact> facts = {contact.is_apart()
                                      ? length_fact("distance", {-r, squared})
                                      : length_fact("penetration", {r, squared, segment.is_apart() ? -1 : 1}),
                                  depth_fact(depth_of(contact)), length_fact("segment_distance", {0, distance}),
                                  direction_fact("normal", normal.x, normal.y, normal.z)};
  if (!segment.only_normal()) facts.back().note = not_the_only_one;
  if (!segment.is_apart() && squared != 0) return facts;
  const boxes::NearestPair pair = contact.nearest_points();
  const std::string_view other_points = contact.is_only_pair(pair) ? "" : not_the_only_one;
  for (const auto& [name, point] :
       {std::pair("nearest_point_segment", &pair.a), std::pair("nearest_point_triangle", &pair.b)})
    facts.emplace_back(place_fact(name, point->x, point->y, point->z)).note = other_points;
  return facts;
}

}  // namespace axiscert::capsule

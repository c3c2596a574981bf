#include "exact/boxes/contact.h"

#include <algorithm>

#include "exact/numbers/roots.h"

namespace axiscert::boxes {
namespace {

bool is_zero(const Point& v) { return v.x == 0 && v.y == 0 && v.z == 0; }
bool is_same_way(const Point& u, const Point& v) { return is_zero(cross(u, v)) && dot(u, v) > 0; }

// Both ways of each axis.
std::vector<Push> pushes_of(const std::vector<AxisRest>& axes) {
  std::vector<Push> found;
  for (const AxisRest& axis : axes) {
    found.push_back({axis.along, axis.rest, axis.squared_length, axis.squared()});
    found.push_back(
        {Point{} - axis.along, axis.back, axis.squared_length, Rational(axis.back * axis.back / axis.squared_length)});
  }
  return found;
}

}  // namespace

template <class Bodies>
struct ExactContact::InUnits {
  Bodies bodies;
  Rational unit;
};

namespace {

// The least common multiples of the denominators of lengths and places, and of axes.
struct Denominators {
  mpz_class lengths = 1, axes = 1;

  void include(mpz_class& common, const Rational& x) {
    if (!mpz_divisible_p(common.get_mpz_t(), x.get_den_mpz_t())) common = lcm(common, x.get_den());
  }
  void include(mpz_class& common, const Point& p) {
    for (const Rational* x : {&p.x, &p.y, &p.z}) include(common, *x);
  }
  void include(const ExactBox& box) {
    include(lengths, box.centre);
    for (const Rational& half : box.half) include(lengths, half);
    for (const Point& axis : box.axis) include(axes, axis);
  }
  Rational unit() const { return lengths * axes; }
  ExactBox of(const ExactBox& box) const {
    ExactBox found{box.centre * unit(), {}, {}};
    for (std::size_t k = 0; k < 3; ++k) {
      found.half[k] = box.half[k] * lengths;
      found.axis[k] = box.axis[k] * Rational(axes);
    }
    return found;
  }
};

Denominators denominators_of(const ExactPair& q) {
  Denominators found;
  found.include(q.a);
  found.include(q.b);
  return found;
}
ExactPair times(const Denominators& by, const ExactPair& q) { return {by.of(q.a), by.of(q.b)}; }

Denominators denominators_of(const ExactBoxAndTriangle& q) {
  Denominators found;
  found.include(q.box);
  for (const Point& corner : q.corner) found.include(found.lengths, corner);
  return found;
}
ExactBoxAndTriangle times(const Denominators& by, const ExactBoxAndTriangle& q) {
  ExactBoxAndTriangle found{by.of(q.box), q.corner};
  for (Point& corner : found.corner) corner = corner * by.unit();
  return found;
}

Hull first_of(const ExactPair& q) { return corners_of(q.a); }
Hull second_of(const ExactPair& q) { return corners_of(q.b); }
Hull first_of(const ExactBoxAndTriangle& q) { return corners_of(q.box); }
Hull second_of(const ExactBoxAndTriangle& q) { return hull_of(q.corner); }

}  // namespace

template <class Bodies>
ExactContact::ExactContact(const InUnits<Bodies>& q)
    : unit_(q.unit), a_(first_of(q.bodies)), b_(second_of(q.bodies)), scene_(boxes::squared_scene(q.bodies)) {
  const std::vector<AxisRest> axes = axis_rests(q.bodies), least = deciding(axes);
  for (const AxisRest& axis : least) least_axes_.push_back(axis.index);
  is_apart_ = least.front().rest < 0;  // by the theorem of the axes, to which every query is held
  if (is_apart_) {
    find_apart();
  } else {
    pushes_ = pushes_of(axes);
    find_in_contact();
  }
  squared_ = in_squares(squared_);
  scene_ = in_squares(scene_);
}

ExactContact::ExactContact(const ExactPair& q)
    : ExactContact(InUnits<ExactPair>{times(denominators_of(q), q), denominators_of(q).unit()}) {}
ExactContact::ExactContact(const ExactBoxAndTriangle& q)
    : ExactContact(InUnits<ExactBoxAndTriangle>{times(denominators_of(q), q), denominators_of(q).unit()}) {}

void ExactContact::find_apart() {
  nearest_ = nearest_pair(a_, b_);
  normals_ = {nearest_->b - nearest_->a};
  squared_ = dot(normals_.front(), normals_.front());
}

void ExactContact::find_in_contact() {
  for (std::size_t i = 1; i < pushes_.size(); ++i) {
    if (pushes_[i].squared < least().squared) least_ = i;
  }
  squared_ = least().squared;
  for (const Push& push : pushes_) {
    if (push.squared != least().squared) continue;
    if (std::ranges::none_of(normals_, [&](const Point& n) { return is_same_way(n, push.along); }))
      normals_.push_back(push.along);
  }
}

std::optional<NearestPair> ExactContact::touching_points() const {
  if (normals_.size() != 1) return std::nullopt;
  const auto in_lengths = [&](const Point& a, const Point& b) { return NearestPair{a / unit_, b / unit_}; };
  if (is_apart_) {
    if (!is_only_pair(*nearest_, normals_.front(), a_, b_)) return std::nullopt;
    return in_lengths(nearest_->a, nearest_->b);
  }
  const Point way = least().along * Rational(least().rest / least().squared_length);
  Hull pushed = b_;
  for (Point& p : pushed) p = p + way;
  const NearestPair touching = nearest_pair(a_, pushed);
  if (!is_only_pair(touching, least().along, a_, pushed)) return std::nullopt;
  return in_lengths(touching.a, touching.b - way);
}

const std::optional<NearestPair>& ExactContact::only_points() const {
  if (!points_) points_ = touching_points();
  return *points_;
}

std::optional<Point> ExactContact::only_normal() const {
  return normals_.size() == 1 ? std::optional(normals_.front()) : std::nullopt;
}

// (rest_u / |u| - d) / d + (1 - cos), in which nothing cancels: the first numerator as a difference of squares, and 1 -
// cos = sin^2 / (1 + cos).
Rational ExactContact::approximate_left(const Push& push, const Point& n) const {
  const Rational &u = push.squared_length, &s = least().squared_length, nn = dot(n, n);
  const Rational here = root_below(Rational(push.rest * push.rest * s)),
                 best = root_below(Rational(least().rest * least().rest * u));
  const Rational further =
      (push.rest * push.rest * s - least().rest * least().rest * u) / (best * Rational(here + best));
  const Rational along = dot(push.along, n), length = root_below(Rational(u * nn));
  const Point turn = cross(push.along, n);
  if (along <= 0) return further + 1 - along / length;
  return further + dot(turn, turn) / (length * Rational(length + along));
}

int ExactContact::compare_left(const Point& n, const Rational& f) const {
  // rest_u / |u| - d u.n / (|u| |n|) - f d, times |u| |n| |s|, d = rest_s / |s|.
  const Rational nn = dot(n, n);
  int sign = 1;
  for (const Push& push : pushes_) {
    if (is_longer(push, f)) continue;
    const RootTerm here{push.rest, Rational(least().squared_length * nn)}, turned{-least().rest * dot(push.along, n)},
        allowed{-f * least().rest, Rational(push.squared_length * nn)};
    sign = std::min(sign, sign_of_sum(here, allowed, turned));
  }
  return sign;
}

Decimal6 ExactContact::left(const Point& n) const {
  const auto has_its_way = [&](const Point& normal) { return is_same_way(normal, n); };
  if (std::ranges::any_of(normals_, has_its_way)) return {};
  Rational guess = approximate_left(least(), n);
  for (const Push& push : pushes_) {
    if (is_longer(push, guess)) continue;
    guess = std::min(guess, approximate_left(push, n));
  }
  return round_up(guess, [&](const Rational& f) { return compare_left(n, f); });
}

double ExactContact::rounded_separation() const {
  const double size = at_most_finite(nearest_sqrt<double>(squared_));
  return is_apart_ || size == 0 ? size : -size;
}
double ExactContact::share_of(const Rational& squared) const {
  if (scene_ == 0 || squared == 0) return 0;
  return std::max(at_most_finite(nearest_sqrt<double>(Rational(squared / scene_))),
                  std::numeric_limits<double>::denorm_min());
}

Rational ExactContact::rest_after(const Point& way) const {
  const Point in_units = way * unit_;
  std::optional<Rational> least;
  for (const Push& push : pushes_) {
    Rational rest = (push.rest - dot(push.along, in_units)) / root_below(push.squared_length);
    if (!least || rest < *least) least = std::move(rest);
  }
  return *least / unit_;
}

Rational ExactContact::mismatch(const Point& a, const Point& b, bool any_way) const {
  const Point between = a - b;
  const Rational apart = dot(between, between);
  Rational longer = 0;  // as a difference of squares, in which nothing cancels
  if (apart != squared_) longer = (apart - squared_) / (root_below(apart) + root_below(squared_));
  // A push leaves no less than what it is shorter: so `longer` below 0 is never the greater.
  return is_apart_ || any_way ? Rational(abs(longer)) : std::max(longer, rest_after(between));
}

}  // namespace axiscert::boxes

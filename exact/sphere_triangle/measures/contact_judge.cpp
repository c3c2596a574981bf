#include "exact/sphere_triangle/measures/contact_judge.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/numbers/roots.h"

namespace axiscert {
namespace {

using portable::cross;
using portable::dot;

RationalVector rational_vector(const auto& v) { return {Rational(v.x), Rational(v.y), Rational(v.z)}; }

constexpr std::string_view part_names[triangle_parts] = {"vertex_a", "vertex_b", "vertex_c", "edge_ab",
                                                         "edge_bc",  "edge_ca",  "face"};

// x 2^-n.
Rational shifted_down(Rational x, unsigned n) {
  mpq_div_2exp(x.get_mpq_t(), x.get_mpq_t(), n);
  return x;
}

// Where the first measure of each kind is (kernel/sphere_triangle/description.cpp).
struct MeasurePlaces {
  std::size_t separation, feature, normal, point;
};
const MeasurePlaces& places() {
  static const MeasurePlaces all = [] {
    const auto first = [](MeasureKind kind) { return first_measure(sphere_triangle_predicate(), kind).value(); };
    return MeasurePlaces{first(MeasureKind::separation), first(MeasureKind::feature), first(MeasureKind::normal),
                         first(MeasureKind::point)};
  }();
  return all;
}

// A triangle, against a point that a push has moved to. All candidates of the least distance are points of the
// triangle, and the nearest point is one of them: so no two distances are compared.
class Triangle {
 public:
  explicit Triangle(const std::array<RationalVector, 3>& vertex)
      : vertex_(vertex), normal_(cross(vertex[1] - vertex[0], vertex[2] - vertex[0])), area_(dot(normal_, normal_)) {
    for (std::size_t k = 0; k < 3; ++k) {
      edge_[k] = vertex[(k + 1) % 3] - vertex[k];
      length_[k] = dot(edge_[k], edge_[k]);
      outwards_[k] = cross(edge_[k], normal_);
    }
  }

  // see(x) of the squared distance of each candidate. A Number is made by from(rational vector component); `square` and
  // `sign` are its own.
  template <class Number, class Square, class Sign, class See>
  void candidates(const portable::Vec3<Number>& at, Square&& square, Sign&& sign, See&& see) const {
    const auto along = [](const portable::Vec3<Number>& v, const RationalVector& by) {
      return Number(v.x * by.x + v.y * by.y + v.z * by.z);
    };
    const auto squared = [&](const portable::Vec3<Number>& v) {
      return Number(square(v.x) + square(v.y) + square(v.z));
    };
    std::array<portable::Vec3<Number>, 3> from;
    bool is_above = sgn(area_) != 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto number = [](const Rational& x) { return Number{x}; };
      from[k] = {Number(at.x - number(vertex_[k].x)), Number(at.y - number(vertex_[k].y)),
                 Number(at.z - number(vertex_[k].z))};
      const Number whole = squared(from[k]), foot = along(from[k], edge_[k]);
      see(whole);
      if (sign(foot) > 0 && sign(Number(foot - number(length_[k]))) < 0)
        see(Number(whole - square(foot) * Rational(1 / length_[k])));
      is_above = is_above && sign(along(from[k], outwards_[k])) <= 0;
    }
    if (is_above) see(Number(square(along(from[0], normal_)) * Rational(1 / area_)));
  }

 private:
  std::array<RationalVector, 3> vertex_, edge_, outwards_;
  std::array<Rational, 3> length_;
  RationalVector normal_;
  Rational area_;
};

// What a push of the sphere by the exact depth along a vector, which is not 0, leaves. The triangle is seen from the
// centre, which is `away` from its nearest point and at the distance sqrt(dd) < r.
Pushed pushed(const std::array<RationalVector, 3>& vertex, const RationalVector& away, const Rational& dd,
              const Rational& r, const Rational& squared_side_error, const RationalVector& along) {
  const Rational mm = dot(along, along), depth = approximate_magnitude({r, dd, -1}), length = root_below(mm);
  const bool is_exact_normal =
      sgn(dd) != 0 && sgn(dot(along, away)) > 0 && Rational(dot(along, away) * dot(along, away)) == Rational(mm * dd);
  if (is_exact_normal) return {};  // it goes straight away from the nearest point, which stays the nearest
  const Triangle triangle(vertex);
  // Both roots and the depth are relatively within 2^-240: so the place is within 2^-238 of the depth, and its distance
  // too.
  const Rational share = depth / length;
  std::optional<Rational> least;
  triangle.candidates<Rational>(
      along * share, [](const Rational& x) { return Rational(x * x); }, [](const Rational& x) { return sgn(x); },
      [&](const Rational& x) {
        if (!least || x < *least) least = x;
      });
  // r - sqrt(least) without a difference of roots: so an error of the place is one of at most 2^-236 in what is left,
  // however small the depth is beside r.
  const Rational left = (r * r - *least) / ((r + root_below(*least)) * depth), error = shifted_down(1, 230);
  // left > F where the distance is below t = r - F (r - d) = (r - F r) + F d.
  const TwoRootField field(dd, mm);
  const auto exceeds = [&](const Rational& f) {
    const TwoRoots t{r - f * r, f};
    if (field.sign(t) <= 0) return false;
    const TwoRoots tt = field.product(t, t);
    // (r - d) / m: r sqrt(mm) / mm - sqrt(dd mm) / mm.
    const TwoRoots step{0, 0, r / mm, -1 / mm};
    bool found = false;
    triangle.candidates<TwoRoots>(
        {step * along.x, step * along.y, step * along.z}, [&](const TwoRoots& x) { return field.product(x, x); },
        [&](const TwoRoots& x) { return field.sign(x); },
        [&](const TwoRoots& x) { found = found || field.sign(x - tt) < 0; });
    return found;
  };
  const Rational low = left - error, high = left + error;
  Pushed out;
  if (sgn(high) <= 0 || (sgn(low) <= 0 && !exceeds(0))) return out;
  // A share below 2^-230 of the depth is told as that at most.
  Decimal6 rounded = round_up(sgn(low) > 0 ? low : high);
  if (sgn(low) > 0 && rounded != round_up(high) && exceeds(exact(rounded))) rounded = next(rounded);
  out.left = rounded;
  const Rational sixteenth = Rational(1, 16);
  const bool is_wide = sgn(dot(along, away)) < 0;
  out.is_flip = is_wide && dd > squared_side_error && (low > sixteenth || (high > sixteenth && exceeds(sixteenth)));
  return out;
}

}  // namespace

template <class Real>
SphereTriangleJudge<Real>::SphereTriangleJudge(const Query<double>& q)
    : nearest_(nearest_place(q)), r_(exact(q.r)), dd_(nearest_.squared_distance), centre_{q.p.x, q.p.y, q.p.z} {
  const RationalVector p = rational_vector(q.p);
  vertex_ = {rational_vector(q.a) - p, rational_vector(q.b) - p, rational_vector(q.c) - p};
  point_ = rational_vector(nearest_.point) - p;
  away_ = RationalVector{} - point_;
  scene_ = r_ * r_;
  for (const RationalVector& v : vertex_) scene_ = std::max(scene_, Rational(dot(v, v)));
}

template <class Real>
void SphereTriangleJudge<Real>::judge_separation(Verdict said, double given, ContactJudgement& out) const {
  if (said == Verdict::contact && given > 0) out.consistency = Consistency::positive;
  if (said == Verdict::separated && given < 0) out.consistency = Consistency::negative;
  if (sgn(scene_) == 0) return;
  out.separation = separation_error<Real>(given, dd_, r_, scene_);
  if (sgn(margin_) != 0)
    out.separation_less_margin = separation_error<Real>(given, dd_, Rational(r_ + margin_), scene_);
}

template <class Real>
void SphereTriangleJudge<Real>::judge_feature(double number, ContactJudgement& out) const {
  const std::optional<std::size_t> named = part_named(number);
  out.feature_is_right = named && std::ranges::find(nearest_.features, part_names[*named]) != nearest_.features.end();
  if (*out.feature_is_right) return;
  out.feature_error = 0;
  if (!named) out.feature_error = std::numeric_limits<double>::infinity();
  else if (sgn(scene_) != 0)
    out.feature_error = nearest_sqrt<double>(Rational(squared_beyond(*named, vertex_, RationalVector{}) / scene_));
}

template <class Real>
void SphereTriangleJudge<Real>::judge_normal(const RationalVector& normal, ContactJudgement& out) const {
  out.normal_length_error = length_error(normal);
  if (sgn(dd_) != 0) out.normal_angle = angle_between(normal, away_);
  if (dd_ >= r_ * r_) return;
  if (sgn(dot(normal, normal)) == 0) {
    if (sgn(dd_) != 0) out.pushed = pushed_nowhere();
    return;
  }
  // The rounding of the differences A - P and so on moves a vertex by u of the scene at most: 2 u is more than that.
  const Rational side_error = shifted_down(scene_, 2 * (std::numeric_limits<Real>::digits - 1));
  out.pushed = pushed(vertex_, away_, dd_, r_, side_error, normal);
}

template <class Real>
ContactJudgement SphereTriangleJudge<Real>::judge(Verdict said, std::span<const double> measures) {
  ContactJudgement out;
  const auto gives = [&](std::size_t first, std::size_t size) { return measures.size() >= first + size; };
  const bool any_given = std::ranges::any_of(measures, [](double x) { return !std::isnan(x); });
  // Nothing beside `separated` is no fault: many kernels speak of contacts alone.
  const bool is_asked = any_given || said == Verdict::contact;
  if (gives(places().separation, 1)) {
    if (any_given) out.consistency = Consistency::consistent;
    const double given = measures[places().separation];
    if (std::isfinite(given)) judge_separation(said, given, out);
    else out.lacks_separation = is_asked;
  }
  if (gives(places().feature, 1)) {
    const double number = measures[places().feature];
    if (std::isnan(number)) out.lacks_feature = is_asked;
    else judge_feature(number, out);
  }
  if (gives(places().normal, 3)) {
    if (const auto normal = vector_at(measures, places().normal)) judge_normal(*normal, out);
    else out.lacks_normal = is_asked && sgn(dd_) != 0;
    out.has_right_normal = sgn(dd_) != 0;
    out.lacks_push = out.lacks_normal && dd_ < r_ * r_;
  }
  if (gives(places().point, 3)) {
    if (const auto point = vector_at(measures, places().point); !point) {
      out.lacks_point = is_asked;
    } else if (sgn(scene_) != 0) {
      const RationalVector centre = {exact(centre_[0]), exact(centre_[1]), exact(centre_[2])},
                           off = *point - centre - point_;
      out.point_error =
          std::min(nearest_sqrt<double>(Rational(dot(off, off) / scene_)), std::numeric_limits<double>::max());
    }
  }
  // Beside a normal a feature that is not named is no contradiction: engines name none.
  const bool lacks_feature = out.lacks_feature && !out.normal_length_error;
  const bool lacks = out.lacks_separation || lacks_feature || out.lacks_normal || out.lacks_point;
  if (any_given && lacks && out.consistency == Consistency::consistent) out.consistency = Consistency::missing;
  return out;
}

template <class Real>
ContactPlace SphereTriangleJudge<Real>::place() const {
  ContactPlace out;
  const RootNumber separation{-r_, dd_};
  const int side = compare(separation, 0);
  const double size = side == 0 ? 0 : nearest<double>(approximate_magnitude(separation));
  out.separation = side < 0 ? -size : size;
  out.point = rounded({nearest_.point.x, nearest_.point.y, nearest_.point.z});
  out.from_a = rounded(point_ - vertex_[0]);
  if (sgn(dd_) != 0) out.normal = unit_vector(away_);
  return out;
}

template <class Real>
double SphereTriangleJudge<Real>::scene() const {
  return nearest_sqrt<double>(scene_);
}

template class SphereTriangleJudge<float>;
template class SphereTriangleJudge<double>;

}  // namespace axiscert

// The trait of the moving sphere: the truth by our own rationals, compared on every query with CGAL's distance and, by
// the theorem of docs/moving.md, with the twenty axes.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "exact/judge/clear.h"
#include "exact/judge/oracles.h"
#include "exact/judge/trait.h"
#include "exact/moving_sphere/first_contact.h"
#include "exact/moving_sphere/motion_distance.h"
#include "exact/moving_sphere/motion_judge.h"
#include "exact/sphere_triangle/measures/depth.h"
#include "exact/sphere_triangle/measures/input_class.h"
#include "kernel/moving_sphere/twenty.h"

namespace axiscert::moving_sphere {

// `Entry` is the predicate in one of its entries.
template <class Entry>
struct MotionTrait : Entry {
  using AllFormulae = FormulaeList<Twenty, TwentyNonstrict>;
  using ClearForms = FormulaeList<TwentyNonstrict>;  // right for a motion of zero too, whose sides are exactly 0

  template <class Real>
  static GivenMotion query(const Numbers<Real>& numbers) {
    return Entry::template problem<double>([&](std::size_t k) { return static_cast<double>(numbers[k]); });
  }
  // The sphere before the motion, and the triangle.
  template <class Real>
  static axiscert::Query<Real> start_of(const GivenMotion& q) {
    const auto point = [](const portable::Vec3<double>& v) {
      return Vec3<Real>{static_cast<Real>(v.x), static_cast<Real>(v.y), static_cast<Real>(v.z)};
    };
    return {point(q.a), point(q.b), point(q.c), point(q.p), static_cast<Real>(q.r)};
  }

  template <class Real>
  static double moved_length(const Numbers<Real>& numbers) {
    const GivenMotion q = query(numbers);
    return barycentric_length(q.a, q.b, q.c);
  }
  // Methods by roots of quadratics lose b^2 - a c, which is |D|^2 (r^2 - d^2) for a vertex at v from the start, d from
  // the line of the path: some fifteen roundings of terms of |D|^2 v^2, so at most K u v^2 of d^2. Of an edge it is as
  // much of the squared distance d^2 of the lines, v that of its farther end. To them the radius is one whose square is
  // r^2 + e with |e| <= K u v^2: for a vertex or edge that is d away, one within K u v^2 / (d + r) of r. That is at
  // most sqrt(K u) v where it decides, as |d - r| <= d + r.
  template <class Real>
  static double rooted_length(const Numbers<Real>& numbers) {
    const GivenMotion q = query(numbers);
    const portable::Vec3<double> d = q.to_is_end ? q.to - q.p : q.to;
    const double greatest = 1 / std::sqrt(rough_unit<Real>);
    double found = 0;
    const auto note = [&](double v, double apart) {
      found = std::max(found, v * std::min(v / (apart + q.r), greatest));
    };
    const std::array<portable::Vec3<double>, 3> corner = {q.a - q.p, q.b - q.p, q.c - q.p};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto &from = corner[k], &to = corner[(k + 1) % 3], along = to - from;
      const double v = length_of(from);
      note(v, distance_by(cross(from, d), length_of(d), v));
      const auto across = cross(d, along);
      const double beside = distance_by(cross(from, along), length_of(along), v);
      note(std::max(v, length_of(to)), distance_by(dot(from, across), length_of(across), beside));
    }
    return found;
  }
  // Where the sphere all but touches at the start, a method by roots may not see it.
  template <class Real>
  static bool is_clear_at_start(const Numbers<Real>& numbers) {
    const Numbers<Real> start = start_of<Real>(query(numbers));
    return oracles_of(sphere_triangle_predicate()).clear_verdict(start).has_value();
  }

  static bool is_valid(const Numbers<double>& numbers) {
    return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); }) &&
           query(numbers).r >= 0;
  }

  static Truth geometric_truth(const Numbers<double>& numbers) {
    const GivenMotion q = query(numbers);
    const LeastDistance least = least_distance(q);
    const Rational r(q.r);
    const int order = cmp(least.squared, Rational(r * r));
    if (order > 0) return {Verdict::separated, false};
    return {Verdict::contact, order == 0 && !(q.r == 0 && least.crosses_the_face)};
  }

  // With `>=` in the sides, one of the twenty axes separates exactly where the sphere is nowhere in contact.
  static std::string contradiction(const Numbers<double>& numbers, const Truth& truth, ComparisonBits holds,
                                   ComparisonBits ties) {
    const int order = swept_distance_order(query(numbers));
    const Verdict by_cgal = order > 0 ? Verdict::separated : Verdict::contact;
    const Verdict by_axes = verdict_of(moving_sphere_predicate(), holds | (ties & side_bits));
    const bool touching_agrees = truth.touching ? order == 0 : order != 0 || query(numbers).r == 0;
    if (truth.verdict == by_cgal && truth.verdict == by_axes && touching_agrees) return "";
    return fmt::format(
        "feature by feature {}, touching {}; CGAL {}, touching {}; the twenty axes with >= {}: {:#b}, "
        "ties {:#b}",
        name(truth.verdict), truth.touching, name(by_cgal), order == 0, name(by_axes), holds, ties);
  }

  // |dist - r| over the greatest of r and the distances of the prism's corners, A to C' = C - D, from P; dist is the
  // least distance of the motion.
  static ExactDepth exact_depth(const Numbers<double>& numbers) {
    const GivenMotion q = query(numbers);
    const Rational scene = squared_scene(q);
    return {least_distance(q).squared, exact(q.r), scene == 0 ? Rational(1) : scene};  // where it is 0, so are both
  }

  // `time`: the greatest number of the precision that is not later than the first contact. `features`: all that are
  // nearest to the centre then. `start`: sphere and triangle before the motion.
  template <class Real>
  static std::vector<Detail> details(const Numbers<double>& numbers) {
    Detail time{"time", {}}, features{"features", {}}, start{"start", start_names[Start::clear]};
    if (const std::optional<FirstContact> contact = first_contact(query(numbers))) {
      start.value = start_names[contact->start];
      time.value = static_cast<double>(rounded_down<Real>(contact->time));
      std::vector<std::string_view> names;
      for (const Feature feature : contact->features) names.push_back(feature_names[feature]);
      features.value = std::move(names);
    }
    return {time, features, start};
  }
  static std::vector<std::string_view> detail_names() { return {"time", "features", "start"}; }

  // The sphere before the motion decides.
  template <class Real>
  static bool is_degenerate(const Numbers<double>& numbers) {
    return axiscert::is_degenerate(start_of<Real>(query(numbers)));
  }

  static Distance distance(const Numbers<double>& numbers) {
    const GivenMotion q = query(numbers);
    return {least_distance(q).squared, exact(q.r)};
  }

  static bool is_promised(const MotionPolicy& policy, const Numbers<double>& numbers) {
    return moving_sphere::is_promised(policy, query(numbers));
  }

  template <class Real>
  static std::unique_ptr<ContactJudge> contact_judge(const Numbers<double>& numbers) {
    return std::make_unique<FirstContactJudge<Real>>(query(numbers));
  }

 private:
  static double length_of(const portable::Vec3<double>& v) { return std::sqrt(dot(v, v)); }
  static double length_of(double x) { return std::fabs(x); }
  // A product by the length of one of its factors; where that is 0, the other distance.
  template <class Product>
  static double distance_by(const Product& product, double length, double otherwise) {
    return length > 0 ? length_of(product) / length : otherwise;
  }
};

struct MovingSphereTrait : MotionTrait<MovingSphere> {
  static constexpr std::size_t critical_centre = 9;  // the first column of P
  // The least distance of the moving centre.
  static std::optional<Rational> squared_critical_length(const Numbers<double>& numbers) {
    return least_distance(query(numbers)).squared;
  }
};
using MovingEndsTrait = MotionTrait<MovingEnds>;

}  // namespace axiscert::moving_sphere

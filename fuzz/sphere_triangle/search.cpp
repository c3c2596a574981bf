// What a search for the worst queries of sphere-triangle values exactly besides wrong verdicts: the errors of the
// sides, the scales at which a comparison leaves the range, and the error of the critical radius.
#include "fuzz/sphere_triangle/capability_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "exact/sphere_triangle/measures/critical_radius.h"
#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "exact/sphere_triangle/unbounded.h"
#include "fuzz/queries/image_groups.h"
#include "fuzz/sphere_triangle/search_evaluator.h"
#include "fuzz/sphere_triangle/search_ranges.h"
#include "kernel/ask.h"
#include "kernel/formulae_list.h"
#include "kernel/sphere_triangle/forms/scalar.h"
#include "kernel/sphere_triangle/names.h"
#include "kernel/sphere_triangle/proved_bounds.h"

namespace axiscert {
namespace {

template <class Real>
std::optional<Decimal6> range_value(const Aim& aim, const Kernel& kernel, const Implementation<Real>& implementation,
                                    const Query<Real>& q) {
  QueryBatch<Real> one(1, coordinate_count);
  one.push_back(q);
  const auto m = range_left(implementation, aim, one).front();
  if (!m) return std::nullopt;
  const Query<Real> there = times_power(q, *m);
  const Reply<Real> reply = ask(implementation, there);
  const std::size_t k = aim.which;
  const bool finite = std::isfinite(reply.answers.lhs[k][0]) && std::isfinite(reply.answers.rhs[k][0]);
  const ComparisonBits expected = *unbounded(formulae_of(kernel), kernel.arithmetic, kernel.strictness, there).bits;
  if (finite && !has_bit(reply.answers.bits[0] ^ expected, k)) return std::nullopt;
  return round_up(exact(range_score(aim.goal, precision_of<Real>, *m)));
}

template <class Real>
std::optional<Decimal6> critical_error(const Kernel& kernel, const Implementation<Real>& implementation,
                                       const Query<Real>& q) {
  const Rational squared = squared_distance(q);
  const auto range = radii_within<Real>(kernel.limits);
  const auto distance = distance_within(squared, range);
  if (!distance) return std::nullopt;
  const auto critical = critical_radius(implementation, q, range);
  if (!critical.answered || critical.not_decided || !critical.radius) return std::nullopt;
  return radius_error_ulps(*critical.radius, *distance, squared);
}

template <class Real>
std::optional<Decimal6> aim_value(const Aim& aim, const Kernel& kernel, const Implementation<Real>& implementation,
                                  const Query<Real>& q) {
  if (!is_valid(q)) return std::nullopt;
  switch (aim.goal) {
    case Goal::error:
    case Goal::relative_error: {
      if (aim.goal == Goal::error && !is_in_box(q)) return std::nullopt;
      const auto all = side_errors<Real>(kernel, implementation, q);
      if (!all) return std::nullopt;
      return (aim.goal == Goal::error ? all->absolute : all->relative)[aim.which];
    }
    case Goal::overflow:
    case Goal::underflow:
      return range_value(aim, kernel, implementation, q);
    case Goal::critical_radius:
      return critical_error(kernel, implementation, q);
    case Goal::missed_contact:
    case Goal::phantom_contact:
    case Goal::number:
      return std::nullopt;  // which every predicate has
  }
  return std::nullopt;
}

class SphereTriangleAims final : public AimValues {
 public:
  std::optional<Decimal6> value(const Aim& aim, const Kernel& kernel, const Implementation<float>& implementation,
                                const Numbers<float>& q) const override {
    return aim_value<float>(aim, kernel, implementation, q);
  }
  std::optional<Decimal6> value(const Aim& aim, const Kernel& kernel, const Implementation<double>& implementation,
                                const Numbers<double>& q) const override {
    return aim_value<double>(aim, kernel, implementation, q);
  }
};

}  // namespace

const AimValues& sphere_triangle_aim_values() {
  static const SphereTriangleAims values;
  return values;
}

namespace {

class SphereTriangleBounds final : public ProvedBounds {
 public:
  // Both precisions have the same bound in u.
  std::optional<Decimal6> error(const Kernel& kernel, Precision, std::size_t comparison) const override {
    const bool published = formulae_of(kernel) == Formulae::published,
               reduced = formulae_of(kernel) == Formulae::reduced;
    const bool plain = kernel.arithmetic == Arithmetic::plain, fma = kernel.arithmetic == Arithmetic::fma;
    if (!kernel.is_reference || !(published || reduced) || !(plain || fma)) return std::nullopt;
    const auto row = (reduced ? 2u : 0u) + (fma ? 1u : 0u);
    return round_up(Rational(proved_sixteenths[row][comparison], 16));
  }
  bool cover(const Numbers<float>& q) const override { return is_in_box(query_from(q)); }
  bool cover(const Numbers<double>& q) const override { return is_in_box(query_from(q)); }
  bool are_as_claimed(const Kernel& kernel, const Numbers<float>& q, const Answers<float>& answers,
                      std::size_t i) const override {
    return are_claimed(kernel, query_from(q), sides_at(answers, i));
  }
  bool are_as_claimed(const Kernel& kernel, const Numbers<double>& q, const Answers<double>& answers,
                      std::size_t i) const override {
    return are_claimed(kernel, query_from(q), sides_at(answers, i));
  }

 private:
  template <class Real>
  static bool are_claimed(const Kernel& kernel, const Query<Real>& q, const Sides<Real>& sides) {
    Sides<Real> claimed;
    reference(formulae_of(kernel), kernel.arithmetic, kernel.strictness, q, &claimed);
    return claimed.lhs == sides.lhs && claimed.rhs == sides.rhs;
  }
};

}  // namespace

const ProvedBounds& sphere_triangle_proved_bounds() {
  static const SphereTriangleBounds bounds;
  return bounds;
}

namespace {

// Errors of the computed sides, the scales at which range fails, and wrong verdicts by the critical radius.
class SearchBySides final : public SearchMethod {
 public:
  // Comparisons if the kernel exposes their sides and claims formulae.
  std::vector<Aim> aims(const Kernel& kernel, const std::vector<std::size_t>& only) const override {
    std::vector<Aim> aims;
    if (kernel.exposes == Exposure::sides && has_comparisons(formulae_of(kernel))) {
      for (const Goal goal : {Goal::error, Goal::relative_error, Goal::overflow, Goal::underflow}) {
        for (std::size_t k = 0; k < comparison_count; ++k) {
          if (only.empty() || std::find(only.begin(), only.end(), k) != only.end()) aims.push_back({goal, k});
        }
      }
    }
    if (only.empty()) {
      for (const Goal goal : {Goal::missed_contact, Goal::phantom_contact, Goal::critical_radius})
        aims.push_back({goal});
    }
    return aims;
  }
  std::string why_no_aims(const Kernel& kernel) const override {
    return fmt::format("kernel {} exposes none of these comparisons", kernel.id);
  }

  // Errors of vertex comparisons soon reach their maximum; those of edges profit from each other; the plane's has no
  // such partner. An estimate for a verdict takes thirty questions to the kernel, one for range a hundred and exact
  // signs; range is also soon exhausted.
  IslandShare share(const Aim& aim) const override {
    const Axis axis = comparisons[aim.which].axis;
    if (aim.goal == Goal::error && axis == Axis::plane) return {most_islands, 1 << 16};
    if (aim.goal == Goal::error && axis >= Axis::edge_ab) return {6, 1 << 16};
    if (aim.goal == Goal::error) return {1, 1 << 16};
    if (aim.goal == Goal::relative_error) return {1, 1 << 13};
    if (is_about_range(aim.goal)) return {1, 1 << 9};
    return {1, 1 << 14};
  }

  std::unique_ptr<Guide<float>> guide(const Kernel& kernel, std::string_view target,
                                      std::type_identity<float>) const override {
    return std::make_unique<Evaluator<float>>(kernel, target);
  }
  std::unique_ptr<Guide<double>> guide(const Kernel& kernel, std::string_view target,
                                       std::type_identity<double>) const override {
    return std::make_unique<Evaluator<double>>(kernel, target);
  }

  int exponent(Goal goal, Precision precision, double value) const override {
    return range_exponent(goal, precision, value);
  }

  // The evaluations take a few seconds, the run from which a search begins a second or two.
  const SearchDefaults& defaults() const override {
    static const SearchDefaults defaults = {
        .evaluations = 1 << 24,
        .first_queries = 1 << 13,
        .families = {"general", "tangent", "seam", "sliver", "needle", "collinear", "repeated", "far", "ratio"}};
    return defaults;
  }

  std::vector<std::string> notes() const override {
    return {
        "Attained: |(l^ - r^) - (l - r)| in u, the greatest found where every coordinate of A - P, B - P, C - P is in "
        "[-1, 1] and r in [0, 1], the rounding of the translation included. Proved: a bound that a checker accepted; "
        "open where there is none. Relative: the same over |l| + |r|, of any query; looked for up to 2^40 u, and "
        "without a bound where both sides vanish.",
        "Overflow and underflow: the exponent m of the first 2^m at which a comparison leaves the range, of queries of "
        "size 1/2 to 1 that are far from every change of sign and whose radius, edges and distances to the vertices "
        "are at least 1/8 of the greatest.",
        "A depth is in units of the scene, the error of the critical radius in ulps of the exact distance. Every "
        "witness was confirmed by exact arithmetic. All of these are lower bounds of the worst: a search proves "
        "nothing "
        "about what it does not find."};
  }
};

}  // namespace

const SearchMethod& sphere_triangle_search() {
  static const SearchBySides search;
  return search;
}

}  // namespace axiscert

#include "fuzz/confirm/image_numbers.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace axiscert {
namespace {

// The permutations of three axes.
constexpr std::array<std::array<std::uint8_t, 3>, 6> orders_of_axes = {
    {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};

bool is_vector_kind(MeasureKind kind) {
  return kind == MeasureKind::normal || kind == MeasureKind::point || kind == MeasureKind::point_a ||
         kind == MeasureKind::point_b;
}

// Parts of a triangle whose vertices are in another order: vertex i of the image is vertex order[i] of the base.
double part_of_image(double part, const std::array<std::uint8_t, 3>& order) {
  constexpr double face = 6;
  if (!(part >= 0 && part < face) || part != std::floor(part)) return part;
  const auto place_of = [&](std::size_t vertex) {
    return static_cast<std::size_t>(std::ranges::find(order, vertex) - order.begin());
  };
  const auto number = static_cast<std::size_t>(part);
  if (number < 3) return static_cast<double>(place_of(number));
  // The edge from vertex k to the next: the one that the third vertex is not on.
  const std::size_t opposite = place_of((number - 3 + 2) % 3);
  return static_cast<double>(3 + (opposite + 1) % 3);
}

std::optional<std::array<double, 3>> vector_of(std::span<const double> measures, std::size_t first) {
  if (measures.size() < first + 3) return std::nullopt;
  std::array<double, 3> v;
  for (std::size_t i = 0; i < 3; ++i) v[i] = measures[first + i];
  const bool is_finite = std::ranges::all_of(v, [](double x) { return std::isfinite(x); });
  return is_finite ? std::optional(v) : std::nullopt;
}

double length_of(const std::array<double, 3>& v) { return std::hypot(v[0], v[1], v[2]); }

// The vectors are not 0, and are made shorter or longer first: products of long and short ones leave the range.
double angle_of(std::array<double, 3> u, std::array<double, 3> v) {
  for (auto* const one : {&u, &v}) {
    const double greatest = std::max({std::fabs((*one)[0]), std::fabs((*one)[1]), std::fabs((*one)[2])});
    for (double& x : *one) x /= greatest;
  }
  const std::array<double, 3> across = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                                        u[0] * v[1] - u[1] * v[0]};
  return std::atan2(length_of(across), u[0] * v[0] + u[1] * v[1] + u[2] * v[2]);
}

}  // namespace

double image_extent(const PredicateEntry& entry, const Numbers<double>& numbers) {
  double most = 0;
  std::array<double, 3> least = {INFINITY, INFINITY, INFINITY}, greatest = {-INFINITY, -INFINITY, -INFINITY};
  for (std::size_t k = 0; k < numbers.size(); k += exact_images::is_vector(entry, k) ? 3 : 1) {
    if (entry.columns[k].role == Role::length) most = std::max(most, std::fabs(numbers[k]));
    if (!exact_images::is_vector(entry, k) || entry.columns[k].role != Role::coordinate) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      least[i] = std::min(least[i], numbers[k + i]);
      greatest[i] = std::max(greatest[i], numbers[k + i]);
    }
  }
  for (std::size_t i = 0; i < 3; ++i) most = std::max(most, greatest[i] - least[i]);
  return most;
}

std::optional<ImageMap> image_map(const PredicateEntry& entry, const ImageGroup& group, std::size_t image, int exponent,
                                  const Numbers<double>& base, const Numbers<double>& numbers) {
  ImageMap map;
  map.order = group.order(image);
  switch (group.kind(image)) {
    case ImageKind::order:
    case ImageKind::turn:
      return map;
    case ImageKind::swap:
      map.exchanged = true;
      return map;
    case ImageKind::scale:
      map.exponent = exponent;
      return map;
    case ImageKind::translation:
      for (std::size_t i = 0; i < 3; ++i) map.moved[i] = numbers[i] - base[i];
      return exact_images::is_vector(entry, 0) ? std::optional(map) : std::nullopt;
    case ImageKind::axes:
    case ImageKind::mirror:
      for (const auto& axes : orders_of_axes) {
        for (std::uint8_t signs = 0; signs < 8; ++signs) {
          const Numbers<double> made = exact_images::with_axes(base, entry, axes, signs);
          if (!std::equal(made.begin(), made.end(), numbers.begin(), numbers.end())) continue;
          map.axes = axes;
          map.signs = signs;
          return map;
        }
      }
      return std::nullopt;
    default:
      return std::nullopt;
  }
}

std::vector<double> mapped_measures(const Predicate& predicate, const ImageMap& map, std::span<const double> measures) {
  std::vector<double> mapped(measures.begin(), measures.end());
  for (std::size_t k = 0; k < measures.size(); ++k) {
    const MeasureKind kind = predicate.measures[k].kind;
    if (kind == MeasureKind::separation) mapped[k] = std::ldexp(measures[k], map.exponent);
    if (kind == MeasureKind::feature) mapped[k] = part_of_image(measures[k], map.order);
    if (!is_vector_kind(kind) || first_measure(predicate, kind) != k || k + 3 > measures.size()) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const double x = measures[k + map.axes[i]], turned = has_bit(map.signs, i) ? -x : x;
      mapped[k + i] = kind == MeasureKind::normal ? turned : std::ldexp(turned, map.exponent) + map.moved[i];
    }
  }
  if (!map.exchanged) return mapped;
  for (std::size_t k = 0; k < mapped.size(); ++k) {
    if (predicate.measures[k].kind == MeasureKind::normal) mapped[k] = -mapped[k];
  }
  const auto a = first_measure(predicate, MeasureKind::point_a), b = first_measure(predicate, MeasureKind::point_b);
  if (a && b && gives_measure(predicate, mapped.size(), MeasureKind::point_b)) {
    for (std::size_t i = 0; i < 3; ++i) std::swap(mapped[*a + i], mapped[*b + i]);
  }
  return mapped;
}

ImageErrors image_errors(const Predicate& predicate, const PredicateEntry& entry, const Numbers<double>& image,
                         std::span<const double> expected, std::span<const double> measures) {
  ImageErrors errors;
  const double extent = image_extent(entry, image);
  if (!(extent > 0 && std::isfinite(extent))) return errors;
  const auto at = [&](std::span<const double> from, MeasureKind kind) -> std::optional<double> {
    const auto first = first_measure(predicate, kind);
    return first && *first < from.size() && std::isfinite(from[*first]) ? std::optional(from[*first]) : std::nullopt;
  };
  const auto see_vectors = [&](MeasureKind kind, bool& is_lost, auto&& see) {
    const auto first = first_measure(predicate, kind);
    if (!first) return;
    auto u = vector_of(expected, *first), v = vector_of(measures, *first);
    // A normal of length 0 says as little as none.
    for (auto* const one : {&u, &v}) {
      if (kind == MeasureKind::normal && *one && length_of(**one) == 0) one->reset();
    }
    if (u && v) see(*u, *v);
    is_lost |= u.has_value() != v.has_value();
  };
  const auto see_numbers = [&](MeasureKind kind, auto&& see) {
    const auto u = at(expected, kind), v = at(measures, kind);
    if (u && v) see(*u, *v);
    errors.is_lost |= u.has_value() != v.has_value();
  };
  see_numbers(MeasureKind::separation, [&](double u, double v) {
    errors.separation = std::min(std::fabs(u / extent - v / extent), std::numeric_limits<double>::max());
  });
  see_numbers(MeasureKind::feature, [&](double u, double v) { errors.is_other_feature = u != v; });
  see_vectors(MeasureKind::normal, errors.has_lost_normal,
              [&](const auto& u, const auto& v) { errors.angle = angle_of(u, v); });
  for (const MeasureKind kind : {MeasureKind::point, MeasureKind::point_a, MeasureKind::point_b}) {
    see_vectors(kind, errors.is_lost, [&](const auto& u, const auto& v) {
      const auto apart = [&](std::size_t i) { return u[i] / extent - v[i] / extent; };
      const double off = std::min(length_of({apart(0), apart(1), apart(2)}), std::numeric_limits<double>::max());
      errors.point = std::max(errors.point.value_or(0), off);
    });
  }
  return errors;
}

OwnErrors own_errors(const ContactJudgement& judgement, double scene, double extent) {
  OwnErrors own;
  if (judgement.pushed) own.angle = 2 * std::asin(std::sqrt(std::min(judgement.pushed->left.value() / 2, 1.0)));
  own.has_normal = judgement.pushed || judgement.has_right_normal;
  own.has_right_feature = judgement.feature_is_right.value_or(false);
  if (judgement.point_a_error && judgement.point_b_error) {
    const double apart = judgement.points_apart.value_or(0);
    own.point = std::max({*judgement.point_a_error, *judgement.point_b_error, apart}) * (scene / extent);
  }
  return own;
}

ImageErrors at_most(ImageErrors errors, const OwnErrors& base, const OwnErrors& image) {
  const auto lower = [](std::optional<double>& error, const std::optional<double>& u, const std::optional<double>& v) {
    if (error && u && v) error = std::min(*error, *u + *v);
  };
  lower(errors.angle, base.angle, image.angle);
  lower(errors.point, base.point, image.point);
  if (!base.has_normal || !image.has_normal) {
    errors.angle.reset();
    errors.has_lost_normal = false;
  }
  if (errors.is_other_feature && base.has_right_feature && image.has_right_feature) errors.is_other_feature = false;
  return errors;
}

}  // namespace axiscert

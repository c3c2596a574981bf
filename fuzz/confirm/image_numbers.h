// The numbers beside the verdicts on a query and on an exact image of it: what those of the image have to be.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "exact/judge/contact_judgement.h"
#include "fuzz/queries/image_groups.h"
#include "kernel/predicate.h"
#include "kernel/query.h"

namespace axiscert {

// How an image is made of its base, found from their numbers: coordinate i of a vector of the image is coordinate
// axes[i] of the base, with its sign changed where bit i of `signs` is set, times 2^exponent; a place is moved too.
struct ImageMap {
  std::array<std::uint8_t, 3> axes = {0, 1, 2}, order = {0, 1, 2};  // order: ImageGroup::order
  std::uint8_t signs = 0;
  int exponent = 0;
  std::array<double, 3> moved = {0, 0, 0};
  bool exchanged = false;  // the first body is the base's second
};
// Empty for images of a kind that is no map of places (a motion in parts), and where no map is found.
std::optional<ImageMap> image_map(const PredicateEntry& entry, const ImageGroup& group, std::size_t image, int exponent,
                                  const Numbers<double>& base, const Numbers<double>& numbers);

// The measures of the base as the image has them, in doubles.
std::vector<double> mapped_measures(const Predicate& predicate, const ImageMap& map, std::span<const double> measures);

// How far the measures of an image are from those, in binary64. Empty where one of the two is not given or not finite,
// or the predicate has none.
struct ImageErrors {
  std::optional<double> separation, point;  // relative to the greatest difference of the image's coordinates
  std::optional<double> angle;              // of the normals, in radians
  std::optional<bool> is_other_feature;
  bool is_lost = false;  // a number is given for one of the two alone
  bool has_lost_normal = false;

  bool any() const { return separation || point || angle || is_other_feature || is_lost || has_lost_normal; }
};
ImageErrors image_errors(const Predicate& predicate, const PredicateEntry& entry, const Numbers<double>& image,
                         std::span<const double> expected, std::span<const double> measures);

// By how much two answers may differ that are both no worse than they are, one of them so judged: where several normals
// or points are right, the two may take any of them. Empty where one answer alone is right, or none can be judged.
struct OwnErrors {
  std::optional<double> angle;  // from a normal that leaves as much: 1 - cos angle of the depth; radians
  std::optional<double> point;  // of the two bodies' points, relative to the extent that image_errors() has
  bool has_normal = true;       // whether some normal is right, and not all are
  bool has_right_feature = false;
};
OwnErrors own_errors(const ContactJudgement& judgement, double scene, double extent);
// The errors, none above the sum of the two answers' own.
ImageErrors at_most(ImageErrors errors, const OwnErrors& base, const OwnErrors& image);

// The greatest difference of two places of the query along an axis, or length.
double image_extent(const PredicateEntry& entry, const Numbers<double>& numbers);

}  // namespace axiscert

// One kernel's results on one family.
#pragma once

#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include "fuzz/record/tally.h"
#include "fuzz/text/values.h"
#include "fuzz/queries/image_groups.h"

namespace axiscert {

// A summary of a CriticalRadiusTally.
struct CriticalRadiusRecord {
  std::uint64_t sampled = 0;
  std::optional<double> median_ulps, largest_ulps;
  std::uint64_t unbounded = 0, unanswered = 0, undecided = 0, invalid = 0;
  std::optional<SignedNumber> signed_median_ulps;
  std::uint64_t early = 0, late = 0;

  static constexpr std::string_view about =
      "The distance of the smallest radius for which the kernel says contact from the exact distance.";
  AXISCERT_FIELDS(
      CriticalRadiusRecord, AXISCERT_FIELD(sampled, "Queries whose critical radius was found by bisection."),
      AXISCERT_FIELD(
          median_ulps,
          "Median of the finite errors, in ulps of the correctly rounded exact distance; null where there is none.",
          "ulps"),
      AXISCERT_FIELD(largest_ulps, "Largest finite error, in the same ulps; null where there is none.", "ulps"),
      field(&Of::unbounded,
            figure_of("sampled", "unbounded",
                      "Sampled queries for which the kernel says contact for no finite radius within its limits.")),
      AXISCERT_FIELD(unanswered, "Queries whose search ended at a radius that got no answer: not sampled."),
      AXISCERT_FIELD(undecided,
                     "Queries of which the kernel declined some radius that was asked: not sampled, since the change "
                     "that was found may be one to that."),
      AXISCERT_FIELD(invalid,
                     "Queries of which the kernel called some radius that was asked invalid: not sampled either."),
      AXISCERT_FIELD(signed_median_ulps,
                     "Median of the finite errors with their signs: negative where the kernel says contact too early, "
                     "at a radius below the exact distance.",
                     "ulps"),
      field(&Of::early, figure_of("sampled", "early",
                                  "Sampled queries whose critical radius is below the exact distance, correctly "
                                  "rounded: phantom contacts there.")),
      field(&Of::late, figure_of("sampled", "late",
                                 "Sampled queries whose critical radius is more than one ulp above that: missed "
                                 "contacts there; a right kernel's is at most one ulp above.")))
};
CriticalRadiusRecord summary_of(CriticalRadiusTally tally);

// Two queries to which the kernel gives different answers, by their addresses.
struct AddressPair {
  Name base, image;

  static constexpr std::string_view about =
      "Two queries to which the kernel gives different answers; null where there are none.";
  AXISCERT_FIELDS(AddressPair, AXISCERT_FIELD(base, "Address of the query."),
                  AXISCERT_FIELD(image, "Address of its image."))
};

struct ImageNumbersRecord {
  std::uint64_t images = 0, compared = 0;
  std::uint64_t separations = 0, angles = 0, points = 0, compared_features = 0, lost = 0;
  std::optional<std::uint64_t> features;
  std::optional<double> largest_separation, largest_angle, largest_point;
  std::optional<AddressPair> worst_separation, worst_angle, worst_point, first_feature, first_lost;

  static constexpr std::string_view about =
      "What the kernel says beside its verdict on images, against the same of their base, turned, mirrored, moved or "
      "scaled with it. Sizes are of binary64. The extent is the greatest difference of coordinates of the image, or "
      "length. "
      "Absent for a kernel without "
      "measures.";
  AXISCERT_FIELDS(
      ImageNumbersRecord,
      AXISCERT_FIELD(images,
                     "Images among the first 65,536 queries that have their base's verdict, and are maps of it."),
      AXISCERT_FIELD(compared, "Those for which the kernel gives a number, or gives one for their base."),
      AXISCERT_FIELD(separations, "Those with a separation for both."),
      AXISCERT_FIELD(angles, "Those with a normal for both."), AXISCERT_FIELD(points, "Those with a point for both."),
      AXISCERT_FIELD(compared_features, "Those with a feature for both."),
      field(&Of::lost, figure_of("compared", "lost",
                                 "Those with a number for one of the two alone, where both have one: not given, not a "
                                 "number, or infinite.")),
      AXISCERT_FIELD(features,
                     "Those with another feature than the base's, one of the two wrong; null where none was compared."),
      AXISCERT_FIELD(largest_separation, "Greatest difference of separations; null where none was compared.",
                     "of the extent"),
      AXISCERT_FIELD(
          largest_angle,
          "Greatest angle between the two normals, where there is one; null where none was compared. Of two that "
          "overlap at most the sum of the angles at which normals leave as much: two right ones differ by 0.",
          "radians"),
      AXISCERT_FIELD(largest_point,
                     "Greatest distance of the two points; null where none was compared. Of two bodies' points at most "
                     "the sum of what the two answers are off by.",
                     "of the extent"),
      AXISCERT_FIELD(worst_separation, "The pair with it; null: none."),
      AXISCERT_FIELD(worst_angle, "The pair with it; null: none."),
      AXISCERT_FIELD(worst_point, "The pair with it; null: none."),
      AXISCERT_FIELD(first_feature, "The first with another feature; null: none."),
      AXISCERT_FIELD(first_lost, "The first with a number for one alone; null: none."))
};

struct AsymmetryRecord {
  std::uint64_t images = 0, verdicts = 0, images_with_comparisons = 0;
  std::optional<std::uint64_t> comparisons = 0;
  std::optional<AddressPair> first_verdict, first_comparison;
  std::optional<ImageNumbersRecord> numbers;

  static constexpr std::string_view about =
      "For a family of images: answers of the kernel to an exact image of a query, in another order of its vertices, "
      "turned, mirrored, translated or scaled, that differ from its answer to the query. No exact answer differs. "
      "Absent "
      "where a family makes no images.";
  AXISCERT_FIELDS(
      AsymmetryRecord,
      AXISCERT_FIELD(images,
                     "Images compared with their base: whole groups among the first 2^22 queries, both within the "
                     "kernel's limits, neither unanswered nor undecided, nor both invalid."),
      field(&Of::verdicts, figure_of("images", "verdicts", "Images with another verdict than the base.")),
      AXISCERT_FIELD(images_with_comparisons,
                     "Images whose comparisons were compared: those that have the base's names, with both shown."),
      field(&Of::comparisons, figure_of("images_with_comparisons", "comparisons",
                                        "Those with another comparison than the base, whatever the verdict; null for a "
                                        "kernel that shows none.")),
      AXISCERT_FIELD(first_verdict, "The first with another verdict; null: none."),
      AXISCERT_FIELD(first_comparison, "The first with another comparison; null: none."),
      AXISCERT_OPTIONAL_FIELD(numbers, ImageNumbersRecord::about))
};

struct ComparedQuantity {
  Name quantity;
  int degree = 0;
  double least = 0, greatest = 0;
  std::uint64_t explains = 0;

  static constexpr std::string_view about = "One quantity.";
  AXISCERT_FIELDS(ComparedQuantity, AXISCERT_FIELD(quantity, "What may have been compared, in terms of the query."),
                  AXISCERT_FIELD(degree,
                                 "The power of s by which the quantity grows where every number is multiplied by s."),
                  AXISCERT_FIELD(least, "The number is not less."),
                  AXISCERT_FIELD(greatest, "The number is not greater."),
                  AXISCERT_FIELD(explains, "Bases for which this quantity passes the number."))
};

struct AbsoluteSizeRecord {
  std::uint64_t bases = 0;
  std::vector<ComparedQuantity> compared;

  static constexpr std::string_view about =
      "An estimate of the number with which a kernel compares something that has a size, such as an epsilon: from at "
      "most 256 bases of depth above 2^-10, the first, that are right times one power of two and wrong times the next.";
  AXISCERT_FIELDS(
      AbsoluteSizeRecord, AXISCERT_FIELD(bases, "Bases used."),
      AXISCERT_FIELD(compared,
                     "The quantities that may have been compared, at most three: those that pass a common number "
                     "between the two powers for most of the bases, at least three quarters of them."))
};

// Counts by size: of the kind scale the power of two, as its exponent; of a translation the exponent of its greatest
// coordinate; 0 of the other kinds.
using CountsBySize = std::map<int, std::uint64_t>;

struct UnitFaultsRecord {
  std::uint64_t count = 0;
  CountsBySize by_size;
  std::optional<AddressPair> first;
  AbsoluteSizeRecord where_small, where_large;

  static constexpr std::string_view about =
      "Images within the range to which the answer is wrong, of a base to which it is right and whose depth exceeds "
      "2^-10. No rounding differs between the two, so that something was compared with a number of the kernel's own.";
  AXISCERT_FIELDS(UnitFaultsRecord, AXISCERT_FIELD(count, "Images."),
                  AXISCERT_FIELD(by_size, "The same by power of two."),
                  AXISCERT_FIELD(first, "The pair whose power is nearest to 1, and the first of these; null: none."),
                  AXISCERT_FIELD(where_small, "The estimate from answers that are wrong where numbers are small."),
                  AXISCERT_FIELD(where_large, "The estimate from answers that are wrong where numbers are large."))
};

struct PowerRangeRecord {
  int least = 0, greatest = 0;

  AXISCERT_FIELDS(PowerRangeRecord, AXISCERT_FIELD(least, "The exponent of the least power."),
                  AXISCERT_FIELD(greatest, "The exponent of the greatest power."))
};

struct ImageChangesRecord {
  std::uint64_t images = 0, changed = 0, undecided = 0;
  CountsBySize by_size;
  std::optional<AddressPair> first;
  std::optional<std::optional<PowerRangeRecord>> range;
  std::optional<UnitFaultsRecord> wrong;

  static constexpr std::string_view about = "Images of one kind that were compared with their base.";
  AXISCERT_FIELDS(
      ImageChangesRecord,
      AXISCERT_FIELD(images,
                     "Images of this kind whose verdict was compared with their base's: both within the kernel's "
                     "limits, neither unanswered nor undecided."),
      field(&Of::changed, figure_of("images", "changed", "Images with another verdict than the base.")),
      AXISCERT_FIELD(undecided, "Images that were not compared, since the kernel declined the image or its base."),
      AXISCERT_FIELD(by_size,
                     "Those that changed, by size: of the kind scale the power of two, as its exponent; of a "
                     "translation the exponent of its greatest coordinate; 0 of the other kinds."),
      AXISCERT_FIELD(
          first,
          "The pair of the least size, for a power of two regardless of its sign, and the first of these; null: none."),
      AXISCERT_OPTIONAL_FIELD(
          range,
          "Of the kind scale: all images are times powers of two from 2^least to 2^greatest, within which no form of "
          "degree 6 overflows or underflows; null where that is not known of every base."),
      AXISCERT_OPTIONAL_FIELD(wrong,
                              "Of the kind scale, with a range: those that are wrong although the base is right."))
};

struct ClassRecord : ClassCount {
  Name witness;

  static constexpr std::string_view about = ClassCount::about;
  AXISCERT_FIELDS(ClassRecord, base<ClassRecord, ClassCount>(), AXISCERT_FIELD(witness, "The address of the deepest."))
};

// What adds up over families.
struct FamilyCounts {
  std::uint64_t trials = 0, base_triangles = 0;
  bool exact_arithmetic = false;
  TruthCounts truth;
  VerdictTally verdict;
  std::optional<NamedValues<AxisTally>> axes;
  std::optional<NamedValues<ComparisonTally>> comparisons;
  std::optional<ContactTally> contacts;
  std::optional<std::uint64_t> asked_again;

  AXISCERT_FIELDS(
      FamilyCounts, AXISCERT_FIELD(trials, "Number of queries: separated + contact + invalid."),
      AXISCERT_FIELD(base_triangles,
                     "Number of different triangles among them. Queries that share a triangle are not independent, so "
                     "limits for zero failures count triangles. Of a query file of a predicate without triangles, the "
                     "number of different queries."),
      field(&Of::exact_arithmetic,
            {"exact_arithmetic", "The precision's arithmetic is exact on every query of the family."}, by::least),
      AXISCERT_FIELD(truth), AXISCERT_FIELD(verdict),
      AXISCERT_FIELD(axes, "Results per axis, or other clause; null for a kernel that shows only verdicts."),
      AXISCERT_FIELD(
          comparisons,
          "Results per comparison, in the order of the strings of bits; null for a kernel that shows only verdicts."),
      AXISCERT_OPTIONAL_FIELD(contacts,
                              "What the kernel says beside its verdicts, against what is exact. Absent for a kernel "
                              "without measures of a predicate without motions, and where a predicate has none."),
      AXISCERT_OPTIONAL_FIELD(asked_again,
                              "Queries that were asked again with their batch reversed and shifted by one, and at most "
                              "251 of a batch alone: each other answer is a finding. Absent for a built-in kernel."))
};

struct FamilyRecord : FamilyCounts {
  CriticalRadiusRecord critical_radius;
  std::optional<AsymmetryRecord> asymmetry;
  std::optional<std::map<ImageKind, ImageChangesRecord>> invariance;
  std::optional<std::map<InputClass, ClassRecord>> classes;

  static constexpr std::string_view about = "One kernel's results on one family.";
  AXISCERT_FIELDS(
      FamilyRecord, base<Of, FamilyCounts>(), AXISCERT_FIELD(critical_radius, "Critical radii on this family."),
      AXISCERT_OPTIONAL_FIELD(asymmetry, AsymmetryRecord::about),
      AXISCERT_OPTIONAL_FIELD(
          invariance, "For a family of images: the same images by kind. Absent where a family makes no images."),
      AXISCERT_OPTIONAL_FIELD(
          classes,
          "Wrong verdicts by the class of the input, the first of these whose definition it meets; together all wrong "
          "verdicts of the family. A class without any is left out. Absent for a kernel with a reference, whose links "
          "say why it is wrong. L is the greatest |coordinate of A-P, B-P, C-P| or r, E that of the edges."))
};

}  // namespace axiscert

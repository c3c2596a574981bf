// Asymmetries: answers of a kernel to images of a query (fuzz/queries/image_groups.h) that differ from its answer to
// the query.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fuzz/campaign/campaign.h"
#include "fuzz/confirm/absolute_size.h"
#include "fuzz/queries/image_groups.h"
#include "fuzz/queries/source.h"
#include "fuzz/record/family_record.h"
#include "kernel/outcome.h"
#include "kernel/query.h"

namespace axiscert {
// Invariance: to which kinds of images (fuzz/queries/image_groups.h) a kernel gives another verdict than to their base,
// and from which size on; and which images in another unit of length it has wrong although it has the base right.

// An image and its base, by position.
struct ImagePair {
  std::uint64_t base, image;
};

// Images of one kind whose verdict was compared with their base's. The size of an image is its power of two, of a
// translation that of its greatest coordinate; images of the other kinds have the size 0.
struct ImageChanges {
  std::uint64_t images = 0, changed = 0;
  // Others, which were not compared: the kernel declined one of the two, or called both invalid.
  std::uint64_t undecided = 0;
  std::map<int, std::uint64_t> by_size;  // of those that changed
  // The pair of the least size, for a power of two regardless of its sign; among equals the first.
  std::optional<ImagePair> first;
  int first_size = 0;

  void add(int size, const ImagePair& pair, bool is_changed);
  void merge(const ImageChanges& later);
};

// Images times powers of two within the range of forms of degree 6 (ImageGroup::range), for which every rounding is
// that of the base: a verdict that changes has been compared with a number of the kernel's own.
struct UnitFaults {
  ImageChanges wrong;                  // those of `changed` images that are wrong; the base right and clear
  std::vector<UnitFlip> small, large;  // of clear bases: wrong where numbers are small, or large; the first few
};

// A query is clear if its depth exceeds 2^-10, exactly: an answer to it that is wrong is not one of rounding. Touching
// queries are not.
inline constexpr int clear_depth_exponent = -10;

struct Invariance {
  EnumArray<ImageKind, ImageChanges> kinds{};
  UnitFaults units;  // of a group whose range is known, which no image of it leaves

  void merge(const Invariance& later);
};

// The verdicts of one kernel on the images of one base; empty: no answer, or outside the kernel's limits. Of an image
// in parts the first has the verdict of all of them, and the others none.
template <class Real>
struct AnsweredGroup {
  const ImageGroup& group;
  std::uint64_t position;                  // of the base
  std::span<const Numbers<Real>> queries;  // the base first
  std::span<const std::optional<Verdict>> verdicts;
};
template <class Real>
void count_invariance(Invariance& into, const AnsweredGroup<Real>& answered);

// The greatest of a difference over images, with the first pair that has it.
struct WorstImage {
  std::uint64_t compared = 0;
  double size = 0;
  std::optional<ImagePair> pair;
  void offer(const std::optional<double>& found, const ImagePair& of);
  void merge(const WorstImage& later);
  bool would_take(const std::optional<double>& found) const { return found && *found > size; }
};
// What is said beside verdicts on images, against that on their base (fuzz/confirm/image_numbers.h).
struct ImageNumbers {
  std::uint64_t images = 0;    // with their base's verdict
  std::uint64_t compared = 0;  // of these, with a number that one of the two has
  std::uint64_t compared_features = 0, features = 0, lost = 0;
  WorstImage separation, angle, point;
  std::optional<ImagePair> first_feature, first_lost;
  void merge(const ImageNumbers& later);
};

struct Asymmetry {
  std::uint64_t images = 0;    // compared with their base, which decides them: both within the kernel's limits, neither
                               // unanswered nor declined
  std::uint64_t verdicts = 0;  // images whose verdict differs
  std::uint64_t images_with_comparisons = 0;  // images whose comparisons have the base's names, and both show theirs
  std::uint64_t comparisons = 0;              // of these, with a comparison that differs, whatever the verdict
  std::optional<ImagePair> first_verdict, first_comparison;
  Invariance invariance;  // the same images by kind and size
  ImageNumbers numbers;   // of a kernel with measures
};

// A long run is not repeated in full: this many queries are examined, or all if there are fewer.
inline constexpr std::uint64_t asymmetry_queries = std::uint64_t{1} << 22;
// Numbers beside verdicts are compared on the first of them: exact ones are asked for where two differ.
inline constexpr std::uint64_t image_numbers_queries = std::uint64_t{1} << 16;

// Asks a kernel again about the first `queries` of a source, complete groups of images only; where there are replies,
// those are examined instead. Empty if the source makes no images, or the kernel does not exist in the precision.
std::optional<Asymmetry> asymmetry_of(const SeededSource& of, std::uint64_t queries, const Kernel& kernel,
                                      const StoredReplies* replies, const RunningOptions& running);

// Asymmetries and invariance in the form in which the record lists them.

// `has_numbers`: of a kernel with measures.
AsymmetryRecord asymmetry_record(const Asymmetry& asymmetry, const AddressOf& address, bool has_numbers);
// `sizes` estimates the numbers that explain flips (absolute_sizes).
std::map<ImageKind, ImageChangesRecord> invariance_record(
    const Invariance& invariance, const ImageGroup& group, Precision precision, const AddressOf& address,
    const std::function<std::vector<AbsoluteSize>(std::span<const UnitFlip>)>& sizes);

}  // namespace axiscert

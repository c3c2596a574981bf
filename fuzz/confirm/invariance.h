// Invariance: to which kinds of images (fuzz/queries/image_groups.h) a kernel gives another verdict than to their base,
// and from which size on; and which images in another unit of length it has wrong although it has the base right.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <vector>

#include "fuzz/confirm/absolute_size.h"
#include "fuzz/queries/image_groups.h"
#include "kernel/outcome.h"
#include "kernel/query.h"

namespace axiscert {

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

}  // namespace axiscert

// Asymmetries: answers of a kernel to images of a query (fuzz/queries/image_groups.h) that differ from its answer to
// the query.
#pragma once

#include "fuzz/campaign/campaign.h"
#include "fuzz/confirm/invariance.h"

namespace axiscert {

struct Asymmetry {
  std::uint64_t images = 0;       // compared with their base, which decides them; both answered and within the kernel's
                                  // limits
  std::uint64_t verdicts = 0;     // images whose verdict differs
  std::uint64_t comparisons = 0;  // images with a comparison that differs, by the base's names, whatever the verdict
  std::optional<ImagePair> first_verdict, first_comparison;
  Invariance invariance;  // the same images by kind and size
};

// A long run is not repeated in full: this many queries are examined, or all if there are fewer.
inline constexpr std::uint64_t asymmetry_queries = std::uint64_t{1} << 22;

// Asks a kernel again about the first `queries` of a source, complete groups of images only; where there are replies,
// those are examined instead. Empty if the source makes no images, or the kernel does not exist in the precision.
std::optional<Asymmetry> asymmetry_of(const SeededSource& of, std::uint64_t queries, const Kernel& kernel,
                                      const StoredReplies* replies, const RunningOptions& running);

}  // namespace axiscert

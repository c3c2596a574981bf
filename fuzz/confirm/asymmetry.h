// Where a kernel says of an image of a query what it did not say of the query: fuzz/queries/images.h.
#pragma once

#include "fuzz/campaign/campaign.h"

namespace axiscert {

// An image, and the base that it is one of, by position.
struct AsymmetryWitness {
  std::uint64_t base, image;
};

struct Asymmetry {
  std::uint64_t images = 0;       // held against their base; both with an answer and within the kernel's limits
  std::uint64_t verdicts = 0;     // of those, with another verdict
  std::uint64_t comparisons = 0;  // with another comparison, by the base's names, whatever the verdict
  std::optional<AsymmetryWitness> first_verdict, first_comparison;
};

// A long run is not asked all over again: these are looked at, or as many as there are.
inline constexpr std::uint64_t asymmetry_queries = std::uint64_t{1} << 22;

// Asks the kernel of a plan again about the first `queries` of a source, whole groups of images alone, on all cores; of
// a plan with replies those are looked at. Nothing where the source makes no images, or the kernel does not exist in
// the precision.
std::optional<Asymmetry> asymmetry_of(const Plan& plan, const Kernel& kernel, const Source& source, Precision precision,
                                      std::uint64_t queries);

}  // namespace axiscert

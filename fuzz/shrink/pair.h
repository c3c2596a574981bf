// A query of sphere-triangle and an image of it that a kernel answers differently, and a smaller pair of which the same
// is true.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "fuzz/shrink/image_map.h"
#include "fuzz/shrink/shrink.h"

namespace axiscert {

// The difference: the verdict or, if both verdicts are the same, a comparison by the name that it has in the query.
struct PairSymptom {
  Verdict of_query, of_image;
  std::optional<Comparison> which;
};
// "separated, and contact of its image"; "contact of both, but edge_ab.side_c differs".
std::string text(const PairSymptom& symptom);

template <class Real>
struct Pair {
  Query<Real> query, image;
  ImageMap map;
  PairSymptom symptom;
};

// The pair of a query of a family of images (fuzz/queries/image_groups.h) with its base or, if it is a base, with the
// first of its images that the kernel answers differently. Empty if the address is of no such query, or there is no
// such image, or one of the two is not valid or outside the kernel's limits.
template <class Real>
std::optional<Pair<Real>> asymmetric_pair(const std::string& address, const Kernel& kernel, std::string_view target);

// The same for a query that states its address in a file; empty too if its numbers are not those of the address.
template <class Real>
std::optional<Pair<Real>> asymmetric_pair(const Query<Real>& q, const std::string& stated, const Kernel& kernel,
                                          std::string_view target);

template <class Real>
struct ShrunkPair {
  Shrunk<Real> query;
  Query<Real> image;
};

// A smaller query whose image by the same map is exact too, and on which the kernel's two answers differ in the same
// way. The severity of another verdict is the query's depth, which is that of its image; other comparisons have none.
template <class Real>
ShrunkPair<Real> shrink_pair(const Pair<Real>& pair, const Kernel& kernel, std::string_view target, std::uint64_t limit,
                             Keeping keeping = Keeping::symptom_and_class, const Evaluated& evaluated = {});

}  // namespace axiscert

// A query and an image of it that a kernel answers differently, and a smaller pair of which the same is true.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "fuzz/shrink/shrink.h"

namespace axiscert {

// The exact map from a query to an image of it: no exact answer changes, except for the names of comparisons.
template <class Real>
class ImageMap {
 public:
  virtual ~ImageMap() = default;
  // The image of a valid query; empty if the precision cannot represent it.
  virtual std::optional<Numbers<Real>> image(const Numbers<Real>& query) const = 0;
  // The comparisons of the image by their names in the query.
  virtual ComparisonBits of_query(ComparisonBits image) const = 0;
};

// The maps of a predicate.
class ImageMaps {
 public:
  // The first that makes `image` of `query`, exactly; both are valid. Null if none does.
  virtual std::unique_ptr<ImageMap<float>> between(const Numbers<float>& query, const Numbers<float>& image) const = 0;
  virtual std::unique_ptr<ImageMap<double>> between(const Numbers<double>& query,
                                                    const Numbers<double>& image) const = 0;

 protected:
  ~ImageMaps() = default;
};

// The difference: the verdict or, if both verdicts are the same, a comparison by the name that it has in the query.
struct PairSymptom {
  Verdict of_query, of_image;
  std::optional<std::size_t> which;
  const Predicate* predicate;
};
// "separated, and contact of its image"; "contact of both, but edge_ab.side_c differs".
std::string text(const PairSymptom& symptom);

template <class Real>
struct Pair {
  Numbers<Real> query, image;
  std::unique_ptr<ImageMap<Real>> map;
  PairSymptom symptom;
};

// The pair of a query of a family of images (fuzz/queries/image_groups.h) with its base or, if it is a base, with the
// first of its images that the kernel answers differently. Empty if the address is of no such query, the predicate has
// no ImageMaps, there is no such image, or one of the two is not valid or outside the kernel's limits.
template <class Real>
std::optional<Pair<Real>> asymmetric_pair(const std::string& address, const Kernel& kernel, std::string_view target);

// The same for a query that states its address in a file; empty too if its numbers are not those of the address.
template <class Real>
std::optional<Pair<Real>> asymmetric_pair(const Numbers<Real>& q, const std::string& stated, const Kernel& kernel,
                                          std::string_view target);

// Another query of the family of images of a stated address, whose verdict is wrong: where a kernel answers a query and
// its images differently, one of the answers is. The base of an image comes first; empty too as above.
template <class Real>
struct WrongRelative {
  std::string address;
  Numbers<Real> query;
};
template <class Real>
std::optional<WrongRelative<Real>> wrong_relative(const Numbers<Real>& q, const std::string& stated,
                                                  const Kernel& kernel, std::string_view target);

template <class Real>
struct ShrunkPair {
  ShrinkResult<Real> query;
  Numbers<Real> image;
};

// A smaller query whose image by the same map is exact too, and on which the kernel's two answers differ in the same
// way. The severity of another verdict is the query's depth, which is that of its image; other comparisons have none.
template <class Real>
ShrunkPair<Real> shrink_pair(const Pair<Real>& pair, const Kernel& kernel, std::string_view target, std::uint64_t limit,
                             KeepingRule keeping = KeepingRule::symptom_and_class,
                             const CountEvaluations& evaluated = {});

}  // namespace axiscert

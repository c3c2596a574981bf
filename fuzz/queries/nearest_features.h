// The parts of a shape that are nearest to the other, in a predicate that names them.
#pragma once

#include <string_view>
#include <vector>

#include "kernel/query.h"

namespace axiscert {

class NearestFeatures {
 public:
  // The names of all parts that have a point at the least distance of a valid query: at least one, exactly. A part is
  // without its rim: where a vertex is nearest, its edges are not.
  virtual std::vector<std::string_view> of(const Numbers<float>& query) const = 0;
  virtual std::vector<std::string_view> of(const Numbers<double>& query) const = 0;

 protected:
  ~NearestFeatures() = default;
};

}  // namespace axiscert

// Classes of the input of a predicate, by definitions of its own: why a kernel may be wrong on a query.
#pragma once

#include <string_view>
#include <vector>

#include "kernel/query.h"

namespace axiscert {

class InputClasses {
 public:
  // The names of the definitions that a valid query meets, in their order and at least one: the first is its class.
  virtual std::vector<std::string_view> of(const Numbers<float>& query) const = 0;
  virtual std::vector<std::string_view> of(const Numbers<double>& query) const = 0;

 protected:
  ~InputClasses() = default;
};

}  // namespace axiscert

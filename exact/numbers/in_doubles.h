// The numbers of a query in doubles: a float widens exactly.
#pragma once

#include <algorithm>

#include "kernel/query.h"

namespace axiscert {

template <class Real>
Numbers<double> in_doubles(const Numbers<Real>& query) {
  Numbers<double> wide(query.size());
  std::copy(query.begin(), query.end(), wide.begin());
  return wide;
}

}  // namespace axiscert

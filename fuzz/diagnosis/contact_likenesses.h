// Numbers that kernels give in place of those of a contact, by predicate: a diagnosis says where they are these.
#pragma once

#include <string_view>
#include <vector>

#include "kernel/predicate.h"
#include "kernel/query.h"

namespace axiscert {

struct ContactLikeness {
  MeasureKind kind;
  std::string_view value;     // of the property of a diagnosis
  std::string_view sentence;  // "It is the distance to the triangle's plane, less the radius"
  // One number, or the three of a vector, in doubles; empty where there is none. `entry` is that of the query.
  std::vector<double> (*numbers)(const Numbers<double>& query, std::size_t entry);
};

}  // namespace axiscert

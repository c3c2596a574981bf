// The formulae that permissions are applied to, as graphs.
#pragma once

#include <functional>
#include <string_view>
#include <utility>
#include <vector>

#include "kernel/kernel.h"
#include "kernel/permitted/graph.h"

namespace axiscert::permitted {

struct Recording {
  Graph graph;
  std::vector<std::pair<Value, Value>> sides;  // by comparison; a comparison is lhs > rhs
  ComparisonBits nonstrict = 0;                // those that are lhs >= rhs
};

// Records the formulae of a kernel under permissions; empty where they are not known here.
std::function<Recording(const Permissions&)> recorder_of(const Kernel& kernel);

}  // namespace axiscert::permitted

// Common parts of the benchmarks that print a table with a row per family: the sources, the median, and main.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "fuzz/queries/family.h"
#include "fuzz/queries/source.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {

// The median; of an even number, the lower of the two in the middle.
inline double median(std::vector<double> of) {
  std::sort(of.begin(), of.end());
  return of[(of.size() - 1) / 2];
}

// The families and the mesh with these names; all if there are no names. Throws std::invalid_argument for another name.
inline std::vector<SourcePtr> sources_named(const std::vector<std::string_view>& names) {
  std::vector<SourcePtr> all, named;
  for (const Family* family : families_of(sphere_triangle_predicate())) all.push_back(family_source(*family));
  all.push_back(mesh_source(TEST_MODELS "/OBJ/spider.obj", sphere_triangle_predicate()));
  if (names.empty()) return all;
  for (const std::string_view name : names) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const SourcePtr& s) { return s->name() == name; });
    if (found == all.end())
      throw std::invalid_argument(fmt::format("'{}' is not the name of a family or a mesh", name));
    named.push_back(*found);
  }
  return named;
}

// Calls run(arguments after the program's name). Returns 2 if it throws std::invalid_argument, 1 for another exception.
template <class Run>
int bench_main(const char* program, int argc, char** argv, Run run) {
  try {
    run(std::vector<std::string_view>(argv + 1, argv + argc));
    return 0;
  } catch (const std::exception& fault) {
    fmt::print(stderr, "{}: {}\n", program, fault.what());
    return dynamic_cast<const std::invalid_argument*>(&fault) ? 2 : 1;
  }
}

}  // namespace axiscert

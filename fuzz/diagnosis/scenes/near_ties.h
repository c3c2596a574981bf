// Queries on which the last bit decides, and plain ones beside them.
#pragma once

#include "fuzz/diagnosis/subject.h"
#include "fuzz/queries/random.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert::diagnosis {

// Four points with full significands in (-1, 1), the radius 0.
template <class Real>
Query<Real> random_scene(Stream& random);

// A sphere-triangle scene with the radius nearest to its distance, up to two ulps from there; the radius is not 0.
// `flat`: a coordinate that is 0 in all points; 3: none.
template <class Real>
Query<Real> near_tie(std::uint64_t seed, std::string_view probe, std::uint64_t position, std::size_t flat = 3);

// Queries of the kernel's test and entry: near touching (for other tests: of every family in turn), and of the family
// "general".
template <class Real>
Queries<Real> sharp_queries(const Kernel& kernel, std::uint64_t seed, std::size_t count);
template <class Real>
Queries<Real> plain_queries(const Kernel& kernel, std::uint64_t seed, std::size_t count);

}  // namespace axiscert::diagnosis

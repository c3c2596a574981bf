// The scenes that a diagnosis asks kernels of sphere-triangle about.
#pragma once

#include "fuzz/diagnosis/scenes.h"

namespace axiscert::diagnosis {

const DiagnosisScenes& sphere_triangle_scenes();

// Only scenes with full significands: clear ones are those of the ladder's range windows,
// a near tie has the radius nearest to its distance, up to two ulps from there, which is not 0, and a scene whose
// answer turns is not flat, thin, or nearly in contact.
template <class Real>
std::vector<ClearQuery<Real>> clear_window_queries(const Kernel& kernel, std::size_t count);
template <class Real>
Numbers<Real> sphere_near_tie(std::uint64_t seed, std::string_view probe, std::uint64_t position, std::size_t flat);
template <class Real>
TurningScenes<Real> plump_scenes(Subject<Real>& subject, std::size_t count);

}  // namespace axiscert::diagnosis

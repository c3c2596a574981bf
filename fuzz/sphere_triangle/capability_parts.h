// The parts of sphere-triangle's capabilities, each in a source of its own.
#pragma once

#include <span>

#include "fuzz/confirm/absolute_size.h"
#include "fuzz/confirm/witness.h"
#include "fuzz/diagnosis/scenes.h"
#include "fuzz/queries/capabilities.h"
#include "fuzz/search/confirm.h"
#include "fuzz/search/method.h"

namespace axiscert {

const InputClasses& sphere_triangle_input_classes();
const NearestFeatures& sphere_triangle_nearest_features();
const Quantities& sphere_triangle_quantities();
const WitnessSides& sphere_triangle_witness_sides();

// What kernels give in place of the separation, normal and point of a sphere and a triangle.

std::span<const ContactLikeness* const> sphere_triangle_contact_likenesses();

// What a search and a map have of sphere-triangle.

const SearchMethod& sphere_triangle_search();
const ProvedBounds& sphere_triangle_proved_bounds();

const AimValues& sphere_triangle_aim_values();

}  // namespace axiscert

namespace axiscert::diagnosis {

// The scenes that a diagnosis asks kernels of sphere-triangle about.

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

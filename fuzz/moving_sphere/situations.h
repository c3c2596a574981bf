// The situations of the moving sphere's families, the most everyday ones first.
#pragma once

#include "fuzz/queries/family.h"

namespace axiscert::moving_sphere {

inline constexpr std::string_view sweeps = "docs/moving.md#libraries-and-engines",
                                  sweeps_over_reals = "docs/moving.md#what-each-method-gets-wrong-over-the-reals";

namespace situation {

inline constexpr Situation everyday = {
    "everyday", "motions of everyday sizes, and scenes in metres",
    "Do not build on it as it stands: sweep by another method, and ask both about your own motions "
    "(`axiscert run --queries`).",
    sweeps};
inline constexpr Situation small_integers = {
    "small_integers", "motions in small integers, on which hardly an operation is rounded",
    "A case of its method is wrong or left out: `axiscert shrink` a witness, and see which methods lack the same.",
    sweeps_over_reals};
inline constexpr Situation starts = {
    "starts", "motions that start in contact or beside the triangle, and leave, stand still or go on",
    "Ask the static predicate, sphere-triangle, at the start of every motion as well.", sweeps_over_reals};
inline constexpr Situation parallel = {
    "parallel", "motions parallel to the face or to an edge",
    "Ask the static predicate at the end of such a motion as well, or keep the sphere a skin away from the surface.",
    sweeps_over_reals};
inline constexpr Situation no_motion = {
    "no_motion", "no motion, or one that hardly changes the place",
    "Ask the static predicate, sphere-triangle, where the motion is shorter than an ulp of the place.", sweeps};
inline constexpr Situation point = {"point", "spheres of radius 0 or nearly 0",
                                    "Cast a ray for these, or give every sphere a radius.", sweeps};
inline constexpr Situation far = {"far", "motions of many radii, or that begin far away",
                                  "Cut long motions into parts, or start them near the triangle.",
                                  "docs/moving.md#what-distance-does-to-b2---a-c"};
inline constexpr Situation units = {"units", "clear motions in other units of length", mend_units,
                                    "docs/error_model.md#units-of-length"};
inline constexpr Situation zero_area = {"zero_area", "triangles without area",
                                        "Drop triangles without area when the mesh is read.", sweeps_over_reals};
inline constexpr Situation touching = {
    "touching", "motions that touch, at the start, on the way or at the end, or miss by ulps",
    "Roundings, where the depth is small: keep a skin between sphere and mesh, larger than the safe margin. Where it "
    "is not small, contacts at the start or at the end are left out: ask the static predicate there.",
    sweeps};
inline constexpr const Situation* in_order[] = {&everyday, &small_integers, &starts,    &parallel, &no_motion, &point,
                                                &far,      &units,          &zero_area, &touching};
inline constexpr Situations all = {in_order, of_own_queries("the queries of meshes and files that were given", sweeps)};

}  // namespace situation

}  // namespace axiscert::moving_sphere

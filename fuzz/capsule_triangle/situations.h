// The situations of the capsule's families, the most everyday ones first.
#pragma once

#include "fuzz/queries/family.h"

namespace axiscert::capsule::situation {

inline constexpr std::string_view section = "docs/moving.md#a-capsule";

inline constexpr Situation everyday = {
    "everyday", "capsules of everyday sizes, and scenes in metres",
    "Do not build on it as it stands: take the distance of the segment, and ask both about your own capsules "
    "(`axiscert run --queries`).",
    section};
inline constexpr Situation small_integers = {"small_integers", "capsules in small integers", shrink_small_integers,
                                             section};
inline constexpr Situation parallel = {
    "parallel", "capsules along the face or an edge",
    "Test both ends as spheres as well, or keep the capsule a skin away from the surface.", section};
inline constexpr Situation ball = {"ball", "capsules without length",
                                   "Ask sphere-triangle where both ends are one point.", section};
inline constexpr Situation segment = {"segment", "capsules of radius 0 or nearly 0",
                                      "Cast a ray for these, or give every capsule a radius.", section};
inline constexpr Situation far = {"far", "capsules of many radii, or far from the triangle",
                                  "Move the triangle to the capsule's end before the test.", section};
inline constexpr Situation zero_area = {"zero_area", "triangles without area",
                                        "Drop triangles without area when the mesh is read.", section};
inline constexpr Situation touching = {"touching", "capsules that touch, or miss by ulps",
                                       "Roundings, where the depth is small: keep a skin larger than the safe margin.",
                                       section};
inline constexpr const Situation* in_order[] = {&everyday, &small_integers, &parallel, &ball, &segment,
                                                &far,      &zero_area,      &touching};
inline constexpr Situations all = {in_order,
                                   of_own_queries("the queries of meshes and files that were given", section)};

}  // namespace axiscert::capsule::situation

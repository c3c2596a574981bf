// The situations of the families of two boxes, and of a box and a triangle, the most everyday ones first.
#pragma once

#include "fuzz/queries/family.h"

namespace axiscert::boxes {

inline constexpr std::string_view by_epsilon = "docs/boxes.md#the-price-of-an-epsilon",
                                  box_libraries = "docs/boxes.md#libraries",
                                  box_and_triangle = "docs/boxes.md#a-box-and-a-triangle";

namespace box_box_situation {

inline constexpr Situation everyday = {
    "everyday", "boxes of everyday sizes at any angle, and crates, beams and walls in metres",
    "Do not build on it as it stands: take another predicate, as box-box/cofactor, and ask both about your own boxes "
    "(`axiscert run --queries`).",
    box_libraries};
inline constexpr Situation small_integers = {"small_integers",
                                             "boxes in small integers, turned by quarter turns: nothing is rounded",
                                             shrink_small_integers, by_epsilon};
inline constexpr Situation parallel = {
    "parallel", "boxes whose axes are parallel but for roundings",
    "Products of nearly parallel edges separate what overlaps, or an epsilon holds what is apart: leave these axes "
    "out, or take products that bound their roundings.",
    by_epsilon};
inline constexpr Situation crossed = {
    "crossed", "long edges that cross at a small angle",
    "The epsilon is too large or too small for these lengths: take a predicate whose bound grows with the boxes.",
    by_epsilon};
inline constexpr Situation flat = {"flat", "boxes without thickness, or thin by a factor of 1,000 or a million",
                                   "Give every box a thickness that is visible in its scene.", box_libraries};
inline constexpr Situation far = {
    "far", "boxes far from the origin that touch but for ulps",
    "Subtract an origin near the boxes before their numbers are rounded to the test's precision.", box_libraries};
inline constexpr Situation units = {"units", "boxes in other units of length", mend_units,
                                    "docs/error_model.md#units-of-length"};
inline constexpr Situation sizes = {"sizes", "boxes of very different sizes: a crumb and a floor",
                                    "Take a predicate whose bound is a part of the boxes that meet, and no length.",
                                    by_epsilon};
inline constexpr Situation quaternions = {
    "quaternions", "quaternions that are not of length 1, half turns, and turns that are hardly one",
    "Bring quaternions to length 1 before the predicate is asked, and take none for the identity.",
    "docs/boxes.md#the-question"};
inline constexpr Situation no_rotation = {
    "no_rotation", "axes that are no rotation: any numbers, or columns at right angles that are not of length 1",
    "Make the axes of length 1 and at right angles before the predicate is asked.", "docs/boxes.md#the-question"};
inline constexpr Situation touching = {
    "touching", "boxes that touch, or miss by ulps",
    "Roundings, where the depth is small: let the boxes grow by more than that depth of the scene.",
    "docs/boxes.md#from-the-definition-to-the-books"};
inline constexpr const Situation* in_order[] = {&everyday, &small_integers, &parallel,    &crossed,     &flat,    &far,
                                                &units,    &sizes,          &quaternions, &no_rotation, &touching};
inline constexpr Situations all = {in_order, of_own_queries("the queries of files that were given", box_libraries)};

}  // namespace box_box_situation

namespace box_triangle_situation {

inline constexpr Situation everyday = {"everyday",
                                       "boxes and triangles of everyday sizes, crates and cells of a grid in a level",
                                       "Do not build on it as it stands: take another predicate, as "
                                       "box-triangle/thirteen, and ask both about your own mesh "
                                       "(`axiscert run --mesh`).",
                                       box_and_triangle};
inline constexpr Situation small_integers = {"small_integers",
                                             "boxes and triangles in small integers: nothing is rounded",
                                             shrink_small_integers, box_and_triangle};
inline constexpr Situation degenerate = {
    "degenerate", "triangles without area, or boxes without thickness",
    "Drop triangles without area when the mesh is read, and give every box a thickness.", box_and_triangle};
inline constexpr Situation touching = {
    "touching", "boxes and triangles that touch, or miss by ulps",
    "Roundings, where the depth is small: let the box grow by more than that depth of the scene.", box_and_triangle};
inline constexpr Situation units = {"units", "boxes and triangles in other units of length", mend_units,
                                    "docs/error_model.md#units-of-length"};
inline constexpr Situation sizes = {"sizes", "boxes and triangles of very different sizes: a voxel and a wall",
                                    "Cut large triangles into parts of the size of the boxes that they meet.",
                                    box_and_triangle};
inline constexpr Situation thin = {"thin", "needles, slivers and boxes that are thin or without a thickness",
                                   "Mend needles and slivers when the mesh is read, and give every box a thickness.",
                                   box_and_triangle};
inline constexpr Situation parallel = {
    "parallel", "triangles whose edges or plane are parallel to the box's, or nearly so",
    "A product of nearly parallel edges is left out, or an epsilon holds what is apart: take all thirteen axes as they "
    "are.",
    box_and_triangle};
inline constexpr const Situation* in_order[] = {&everyday, &small_integers, &parallel,   &units,
                                                &sizes,    &thin,           &degenerate, &touching};
inline constexpr Situations all = {in_order,
                                   of_own_queries("the queries of meshes and files that were given", box_and_triangle)};

}  // namespace box_triangle_situation

}  // namespace axiscert::boxes

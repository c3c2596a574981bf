#include "reports/certificate/findings/common_situations.h"
#include "reports/certificate/findings/test_words.h"

namespace axiscert {
namespace {

constexpr std::string_view boxes_by_epsilon = "docs/boxes.md#the-price-of-an-epsilon",
                           box_libraries = "docs/boxes.md#libraries";
constexpr Situation of_box_box[] = {
    {"everyday", "boxes of everyday sizes at any angle, and crates in metres as a solver leaves them",
     "Do not build on it as it stands: take another test, as box-box/cofactor, and ask both about your own boxes "
     "(`axiscert run --queries`).",
     box_libraries,
     "general stack pile resting level general_turned stack_turned pile_turned resting_turned level_turned"},
    {"small_integers", "boxes in small integers, turned by quarter turns: nothing is rounded", shrink_small_integers,
     boxes_by_epsilon, "lattice lattice_turned"},
    {"parallel", "boxes whose axes are parallel but for roundings",
     "Products of nearly parallel edges separate what overlaps, or an epsilon holds what is apart: leave these axes "
     "out, or take products that bound their roundings.",
     boxes_by_epsilon, "parallel parallel_turned"},
    {"crossed", "long edges that cross at a small angle",
     "The epsilon is too large or too small for these lengths: take a test whose bound grows with the boxes.",
     boxes_by_epsilon, "crossed crossed_turned"},
    {"flat", "boxes without thickness, or thin by a factor of 1,000 or a million",
     "Give every box a thickness that is visible in its scene.", box_libraries, "flat rectangles thin"},
    {"far", "boxes far from the origin that touch but for ulps",
     "Subtract an origin near the boxes before their numbers are rounded to the test's precision.", box_libraries,
     "far"},
    {"units", "boxes in other units of length", mend_units, "docs/error_model.md#units-of-length", "scale"},
    {"no_rotation", "axes that are no rotation: any numbers, or columns at right angles that are not of length 1",
     "Make the axes of length 1 and at right angles before the test is asked.", "docs/boxes.md#the-question",
     "bits int_scaled"},
    {"touching", "boxes that touch, or miss by ulps",
     "Roundings, where the depth is small: let the boxes grow by more than that depth of the scene.",
     "docs/boxes.md#from-the-definition-to-the-books",
     "tangent stacked edge_edge vertex_face tangent_turned edge_edge_turned vertex_face_turned"},
    of_corpus,
    of_own_queries("the queries of files that were given", box_libraries),
};

constexpr std::string_view box_and_triangle = "docs/boxes.md#a-box-and-a-triangle";
constexpr Situation of_box_triangle[] = {
    {"everyday", "boxes and triangles of everyday sizes, and cells of a grid as a voxelizer asks",
     "Do not build on it as it stands: take another test, as box-triangle/thirteen, and ask both about your own mesh "
     "(`axiscert run --mesh`).",
     box_and_triangle, "general voxel general_minmax general_oriented"},
    {"small_integers", "boxes and triangles in small integers: nothing is rounded", shrink_small_integers,
     box_and_triangle, "lattice lattice_minmax lattice_oriented"},
    {"degenerate", "triangles without area, or boxes without thickness",
     "Drop triangles without area when the mesh is read, and give every box a thickness.", box_and_triangle,
     "degenerate"},
    {"touching", "boxes and triangles that touch, or miss by ulps",
     "Roundings, where the depth is small: let the box grow by more than that depth of the scene.", box_and_triangle,
     "touching touching_minmax touching_oriented"},
    of_corpus,
    of_own_queries("the queries of meshes and files that were given", box_and_triangle),
};

}  // namespace

const TestWords& box_box_words() {
  static constexpr TestWords words = {"docs/boxes.md#from-the-definition-to-the-books", of_box_box};
  return words;
}

const TestWords& box_triangle_words() {
  static constexpr TestWords words = {"docs/boxes.md#from-the-definition-to-the-books", of_box_triangle};
  return words;
}

}  // namespace axiscert

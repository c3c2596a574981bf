#include "reports/certificate/findings/common_situations.h"
#include "reports/certificate/findings/test_words.h"

namespace axiscert {
namespace {

constexpr std::string_view sweeps = "docs/moving.md#libraries-and-engines",
                           sweeps_over_reals = "docs/moving.md#what-each-method-gets-wrong-over-the-reals";
constexpr Situation of_moving_sphere[] = {
    {"everyday", "motions of everyday sizes, and scenes in metres",
     "Do not build on it as it stands: sweep by another method, and ask both about your own motions "
     "(`axiscert run --queries`).",
     sweeps, "general scene_walk scene_fall scene_bullet scene_shake ends_general ends_walk"},
    {"small_integers", "motions in small integers, on which hardly an operation is rounded",
     "A case of its method is wrong or left out: `axiscert shrink` a witness, and see which methods lack the same.",
     sweeps_over_reals, "lattice one_axis ends_lattice"},
    {"parallel", "motions parallel to the face or to an edge",
     "Ask the static test at the end of such a motion as well, or keep the sphere a skin away from the surface.",
     sweeps_over_reals, "slide skim along_edge ends_slide ends_along"},
    {"no_motion", "no motion, or one that hardly changes the place",
     "Ask the static test, sphere-triangle, where the motion is shorter than an ulp of the place.", sweeps,
     "tiny_d zero_d ends_still"},
    {"point", "spheres of radius 0 or nearly 0", "Cast a ray for these, or give every sphere a radius.", sweeps,
     "point ends_point"},
    {"far", "motions of many radii, or that begin far away",
     "Cut long motions into parts, or start them near the triangle.", "docs/moving.md#what-distance-does-to-b2---a-c",
     "approach huge_d ends_approach ends_huge"},
    {"units", "clear motions in other units of length", mend_units, "docs/error_model.md#units-of-length",
     "units scale"},
    {"zero_area", "triangles without area", "Drop triangles without area when the mesh is read.", sweeps_over_reals,
     "line_sweep repeated_sweep ends_line"},
    {"touching", "motions that touch, at the start, on the way or at the end, or miss by ulps",
     "Roundings, where the depth is small: keep a skin between sphere and mesh, larger than the safe margin. Where it "
     "is not small, contacts at the start or at the end are left out: ask the static test there.",
     sweeps,
     "graze touch_end touch_start exact_time seam_time overlap_ulp orders axes inverted translated reversed split "
     "halved ends_graze ends_touch"},
    of_corpus,
    of_own_queries("the queries of meshes and files that were given", sweeps),
};

}  // namespace

const TestWords& moving_sphere_words() {
  static constexpr TestWords words = {"docs/moving.md#what-each-method-gets-wrong-over-the-reals", of_moving_sphere};
  return words;
}

}  // namespace axiscert

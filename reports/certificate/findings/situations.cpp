#include "reports/certificate/findings/situations.h"

#include <algorithm>

#include "kernel/test.h"
#include "reports/run_folder/run_folder.h"

namespace axiscert {
namespace {

// Situations and advice of more than one test.
constexpr std::string_view mend_units =
                               "Bring the scene to a unit in which the kernel is right: `range_window` and "
                               "`absolute_threshold` of the diagnosis say which.",
                           shrink_small_integers =
                               "A case is wrong or left out, or an epsilon is larger than the gap: `axiscert shrink` a "
                               "witness.";
constexpr Situation of_corpus = {"known", "queries of the corpus, which were hard once or are faults of engines",
                                 "`axiscert corpus list` says what each is about.", "docs/corpus.md#the-corpus",
                                 "corpus"};
constexpr Situation of_own_queries(std::string_view meaning, std::string_view section) {
  return {"own", meaning, "`axiscert check` a witness.", section, ""};
}

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

bool has_word(std::string_view words, std::string_view word) {
  for (std::size_t at = words.find(word); at != words.npos; at = words.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || words[at - 1] == ' ') && (end == words.size() || words[end] == ' ')) return true;
  }
  return false;
}

const Situation& situation_of(std::span<const Situation> situations, std::string_view family) {
  const std::string_view own = family.substr(family.find('/') + 1);
  for (const Situation& situation : situations) {
    if (has_word(situation.families, own)) return situation;
  }
  return situations.back();
}

// The wrong verdicts of one situation in one precision.
struct WrongVerdicts {
  std::uint64_t missed = 0, phantom = 0;
  double deepest_missed = 0, deepest_phantom = 0;
  std::vector<std::pair<double, std::string>> families = {};  // by their deepest

  void add(const std::string& family, const Json& verdict) {
    const std::uint64_t more = verdict["false_separation"], others = verdict["false_contact"];
    if (more + others == 0) return;
    const double of_missed = verdict["deepest_false_separation"], of_phantom = verdict["deepest_false_contact"];
    missed += more;
    phantom += others;
    deepest_missed = std::max(deepest_missed, of_missed);
    deepest_phantom = std::max(deepest_phantom, of_phantom);
    families.emplace_back(std::max(of_missed, of_phantom), family);
  }
};

}  // namespace

std::span<const Situation> situations_of(std::string_view test) {
  if (test == "moving-sphere") return of_moving_sphere;
  if (test == "box-box") return of_box_box;
  if (test == "box-triangle") return of_box_triangle;
  return {};
}

Json situations_json(const Json& record, const std::string& kernel) {
  Json found = Json::array();
  const std::span<const Situation> situations = situations_of(test_of(record["plan"]).id);
  for (const Situation& situation : situations) {
    for (const Json& entry : record["kernels"]) {
      if (entry["id"] != kernel) continue;
      WrongVerdicts tally;
      for (const auto& [family, result] : entry["families"].items()) {
        if (&situation_of(situations, family) == &situation) tally.add(family, result["verdict"]);
      }
      if (tally.families.empty()) continue;
      std::ranges::stable_sort(tally.families, [](const auto& x, const auto& y) { return x.first > y.first; });
      Json families = Json::array();
      for (const auto& [depth, family] : tally.families) families.push_back(family);
      found.push_back({{"precision", entry["precision"]},
                       {"situation", situation.name},
                       {"meaning", situation.meaning},
                       {"families", families},
                       {"missed", tally.missed},
                       {"deepest_missed", tally.deepest_missed},
                       {"phantom", tally.phantom},
                       {"deepest_phantom", tally.deepest_phantom},
                       {"advice", situation.advice},
                       {"section", situation.section}});
    }
  }
  return found;
}

const Json* first_situation(const Json& situations, bool& missed) {
  for (const bool is_missed : {true, false}) {
    const char* depth = is_missed ? "deepest_missed" : "deepest_phantom";
    missed = is_missed;
    for (const Json& entry : situations) {
      if (entry[depth].get<double>() >= visible_depth) return &entry;
    }
  }
  for (const bool is_missed : {true, false}) {
    const char *count = is_missed ? "missed" : "phantom", *depth = is_missed ? "deepest_missed" : "deepest_phantom";
    missed = is_missed;
    const Json* deepest = nullptr;
    for (const Json& entry : situations) {
      if (entry[count] != 0 && (!deepest || entry[depth].get<double>() > (*deepest)[depth].get<double>()))
        deepest = &entry;
    }
    if (deepest) return deepest;
  }
  return nullptr;
}

}  // namespace axiscert

#include "fuzz/queries/capabilities.h"

#include "exact/sphere_triangle/measures/nearest_place.h"
#include "fuzz/instruments/critical_radius.h"
#include "fuzz/queries/image_groups.h"
#include "fuzz/sphere_triangle/capability_parts.h"
#include "fuzz/sphere_triangle/images.h"
#include "fuzz/sphere_triangle/mesh_queries.h"
#include "fuzz/sphere_triangle/screen.h"
#include "fuzz/sphere_triangle/slack_scenes.h"
#include "fuzz/sphere_triangle/traits.h"

namespace axiscert {

std::span<const ImageGroup* const> sphere_triangle_image_groups();  // families/images.cpp

const Capabilities& sphere_triangle_capabilities() {
  static const CriticalRadiusDefaults critical_radius = {
      {"published", "nonstrict", "reduced", "ladder-0", "minkowski", "closest-point", "segments", "packed-nonstrict"},
      {"general", "far", "sliver", "needle", "collinear", "repeated", "ratio", "scale"}};
  static constexpr std::string_view correct_forms[] = {"nonstrict", "reduced-nonstrict", "reduced-shared-nonstrict",
                                                       "packed-nonstrict", "minkowski"};
  static const Capabilities all = {
      .image_groups = sphere_triangle_image_groups(),
      .mesh = &sphere_triangle_mesh,
      .canonical_form = least_image_text,
      .screens = &sphere_triangle_screens(),
      .input_classes = &sphere_triangle_input_classes(),
      .nearest_features = &sphere_triangle_nearest_features(),
      .has_engine_queries = true,
      .quantities = &sphere_triangle_quantities(),
      .witness_sides = &sphere_triangle_witness_sides(),
      .section_of_forms = "docs/kernels.md#what-each-answers",
      .correct_forms = correct_forms,
      .diagnosis_scenes = &diagnosis::sphere_triangle_scenes(),
      .critical_radius_defaults = &critical_radius,
      .proved_bounds = &sphere_triangle_proved_bounds(),
      .search_method = &sphere_triangle_search(),
      .aim_values = &sphere_triangle_aim_values(),
      .image_maps = &sphere_triangle_image_maps(),
      .slack_scenes = &sphere_triangle_slack_scenes,
      .traits = &sphere_triangle_traits(),
      .contact_likenesses = sphere_triangle_contact_likenesses(),
      .exact_facts = [](const Numbers<double>& q, std::size_t) { return exact_facts(query_from(q)); },
  };
  return all;
}

}  // namespace axiscert

#include "fuzz/queries/capabilities.h"

#include "exact/moving_sphere/first_contact.h"
#include "fuzz/diagnosis/scenes.h"
#include "fuzz/moving_sphere/capability_parts.h"
#include "fuzz/moving_sphere/mesh_motion.h"
#include "fuzz/moving_sphere/situations.h"
#include "fuzz/queries/image_groups.h"

namespace axiscert {

std::span<const ImageGroup* const> moving_sphere_image_groups();  // images.cpp

namespace {

std::vector<ExactFact> facts_of_motion(const Numbers<double>& q, std::size_t entry) {
  const auto load = [&](std::size_t k) { return q[k]; };
  if (entry == MovingEnds::entry) return moving_sphere::exact_facts(MovingEnds::problem<double>(load));
  return moving_sphere::exact_facts(MovingSphere::problem<double>(load));
}

}  // namespace

const Capabilities& moving_sphere_capabilities() {
  static constexpr std::string_view correct_forms[] = {"moving-sphere/twenty-nonstrict"};
  static const diagnosis::DiagnosisScenes scenes = {.words = {.touching = "motions",
                                                              .length = "radius",
                                                              .sided = "motions",
                                                              .front = "the motion comes from in front of the face",
                                                              .behind = "the motion comes from behind the face",
                                                              .first = "the vertices",
                                                              .second = "the motion"}};
  static const Capabilities all = {.image_groups = moving_sphere_image_groups(),
                                   .mesh = &moving_sphere_mesh,
                                   .quantities = &moving_sphere::quantities(),
                                   .section_of_forms = moving_sphere::sweeps_over_reals,
                                   .situations = &moving_sphere::situation::all,
                                   .correct_forms = correct_forms,
                                   .diagnosis_scenes = &scenes,
                                   .slack_scenes = &moving_sphere_slack_scenes,
                                   .traits = &moving_sphere_traits(),
                                   .exact_facts = facts_of_motion};
  return all;
}

}  // namespace axiscert

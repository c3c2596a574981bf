#include "fuzz/queries/capabilities.h"

#include "fuzz/capsule_triangle/families/situations.h"

namespace axiscert {

const Capabilities& capsule_triangle_capabilities() {
  static constexpr std::string_view correct_forms[] = {"capsule-triangle/twenty-nonstrict"};
  static const Capabilities all = {.section_of_forms = capsule::situation::section,
                                   .situations = &capsule::situation::all,
                                   .correct_forms = correct_forms};
  return all;
}

}  // namespace axiscert

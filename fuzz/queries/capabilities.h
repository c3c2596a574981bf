// What fuzz/ has for a test beside its families: each member serves one command or measurement, and is null where the
// test has no such thing. Code asks for the capability that it needs, and never which test it is.
#pragma once

#include "kernel/test.h"

namespace axiscert {

class Screens;
namespace diagnosis {
struct DiagnosisScenes;
}

struct Capabilities {
  // fuzz/campaign/stages/screen.h: filters, which judge nearly every answer of a run.
  const Screens* screens = nullptr;
  // A screen that counts wrong verdicts by the class of their input.
  bool has_input_classes = false;
  // fuzz/diagnosis/scenes/scenes.h
  const diagnosis::DiagnosisScenes* diagnosis_scenes = nullptr;
};

// Those of a test on the list of kernel/test_list.h: NAME_capabilities() of its room in fuzz/.
const Capabilities& capabilities_of(const TestDescription& test);

}  // namespace axiscert

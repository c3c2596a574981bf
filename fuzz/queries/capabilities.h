// What fuzz/ has for a test beside its families: each member serves one command or measurement, and is null where the
// test has no such thing. Code asks for the capability that it needs, and never which test it is.
#pragma once

#include "kernel/test.h"

namespace axiscert {

class Screens;  // fuzz/campaign/stages/screen.h

struct Capabilities {
  const Screens* screens = nullptr;  // filters, which judge nearly every answer of a run
  bool has_input_classes = false;    // a screen that counts wrong verdicts by the class of their input
};

// Those of a test on the list of kernel/test_list.h: NAME_capabilities() of its room in fuzz/.
const Capabilities& capabilities_of(const TestDescription& test);

}  // namespace axiscert

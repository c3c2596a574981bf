// Answers counted.
#pragma once

#include <cstddef>

#include "fuzz/text/json.h"
#include "kernel/names.h"

namespace axiscert::diagnosis {

// Contacts and separations by a group of scenes.
struct TalliedVerdicts {
  std::size_t contact = 0, separated = 0, other = 0;
  void add(Verdict v) { ++(v == Verdict::contact ? contact : v == Verdict::separated ? separated : other); }
  std::size_t all() const { return contact + separated; }  // decided
  Json json() const { return {{"contact", contact}, {"separated", separated}}; }
};

}  // namespace axiscert::diagnosis

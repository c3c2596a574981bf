// What the library asks itself at its first call.
#pragma once

#include "kernel/sphere_triangle/certified/steps.h"

namespace axiscert::certified {

// Whether the forms give the stored answers to the stored queries, as pairs and as a block. Integers alone answer
// Question::conservative as the closed sphere. The caller has to set the modes of default_modes.h.
bool answer_as_stored(const Forms& forms, bool are_integers) noexcept;

}  // namespace axiscert::certified

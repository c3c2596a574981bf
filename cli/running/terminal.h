// Output that depends on whether a person sees it: colour.
#pragma once

#include <string>

namespace axiscert {

enum class TextColour { red, yellow, green };

// Whether standard output is a terminal that shows colours, and NO_COLOR is not set to any value.
bool output_has_colour();
// The text in that colour where output_has_colour(), otherwise unchanged. A line end stays outside the colour.
std::string coloured(const std::string& text, TextColour colour);

}  // namespace axiscert
